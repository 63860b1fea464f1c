// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   curves and overlaps as VTK's cells
 *
 * Private to the module's own sources.
 */
#ifndef CurveOutputs_h
#define CurveOutputs_h

#include "Pairs/PairSearch.h"

class vtkPolyData;

namespace relevo
{
/**
 * Fill `curves` with what the pairs have in common in points and segments, these joined if asked
 * for, and `overlaps` with polygons.
 */
void MakeCurves(const MovedSurface& first, const MovedSurface& second,
  const std::vector<IntersectingPair>& pairs, bool joinSegments, vtkPolyData* curves,
  vtkPolyData* overlaps);
}

#endif
