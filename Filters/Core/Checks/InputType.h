// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   checks the types of inputs and of the blocks of composite inputs
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
/// Check whether the inputs of all ports, and the blocks of composite inputs, have the required
/// type. VTK checks only the whole data set. Reports an error of the algorithm if they do not.
RELEVOFILTERSCORE_EXPORT bool CheckInputTypes(
  vtkAlgorithm* algorithm, vtkInformationVector** inputs);

/// Whether the data have a type that the port requires.
RELEVOFILTERSCORE_EXPORT bool IsOfRequiredType(vtkDataObject* data, vtkInformation* port);

/**
 * The message of the error if an input or blocks of a composite input do not have a type that the
 * port requires, otherwise empty. Mappers use this function, because no executive checks their
 * inputs.
 */
RELEVOFILTERSCORE_EXPORT std::string FindTypeError(vtkDataObject* input, vtkInformation* port);
}

#endif
