// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether blocks of composite data sets are of a type that an algorithm takes
 *
 * Private to the modules' own sources.
 */
#ifndef InputType_h
#define InputType_h

#include "RelevoFiltersRefinementModule.h" // for export macro

class vtkAlgorithm;
class vtkInformationVector;

namespace relevo
{
/// Whether the input of port 0 is of a type that the port requires: VTK asks this of the whole, not
/// of each block. Else an ErrorEvent of the algorithm.
RELEVOFILTERSREFINEMENT_EXPORT bool CheckInputType(
  vtkAlgorithm* algorithm, vtkInformationVector* input);
}

#endif
