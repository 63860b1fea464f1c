// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether inputs, and blocks of composite ones, are of a type that an algorithm takes
 *
 * Private to the modules' own sources.
 */
#ifndef InputType_h
#define InputType_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <string>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

namespace relevo
{
/// Whether the inputs of all ports are of a type that their port requires: VTK asks this of a whole
/// data set, not of each block. Else an ErrorEvent of the algorithm.
RELEVOFILTERSCORE_EXPORT bool CheckInputTypes(
  vtkAlgorithm* algorithm, vtkInformationVector** inputs);

/// Whether the data are of a type that the port requires.
RELEVOFILTERSCORE_EXPORT bool IsOfRequiredType(vtkDataObject* data, vtkInformation* port);

/**
 * The words of an error where an input is not of a type that the port requires, or where blocks of
 * a composite one are not; empty otherwise. Mappers ask it: no executive checks their inputs.
 */
RELEVOFILTERSCORE_EXPORT std::string FindTypeError(vtkDataObject* input, vtkInformation* port);
}

#endif
