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
/// Whether the inputs of all ports are of a type that their port requires: VTK asks this of a whole
/// data set, not of each block. Else an ErrorEvent of the algorithm.
RELEVOFILTERSREFINEMENT_EXPORT bool CheckInputTypes(
  vtkAlgorithm* algorithm, vtkInformationVector** inputs);
}

#endif
