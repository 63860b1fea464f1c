// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   counts the triangles that are removed because of missing heights
 */
#ifndef HoleCount_h
#define HoleCount_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

namespace relevo
{
class PatternSelection;
class RefinementMesh;
struct HeightValidity;

/**
 * Return the number of removed triangles of a selection on faces that are not hidden. `hidden` has
 * one byte per face, or is nullptr if no face is hidden.
 */
RELEVOFILTERSREFINEMENT_EXPORT vtkIdType CountHoles(const RefinementMesh& mesh,
  const PatternSelection& selection, const HeightValidity& validity,
  const unsigned char* hidden = nullptr);
}

#endif
