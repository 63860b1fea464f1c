// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   InputCheck
 * @brief   checks the type of a mapper's input and reports an error once per input
 *
 * Private to the module.
 */
#ifndef InputCheck_h
#define InputCheck_h

#include "Stages/StageResult.h"

#include <string> // for members

class vtkDataObject;
class vtkInformation;

namespace relevo
{
class InputCheck
{
public:
  /// Check the input of a port; nullptr is no input.
  StageResult Update(vtkDataObject* input, vtkInformation* port);

private:
  vtkDataObject* Input = nullptr; // for comparison; it is not dereferenced
  std::string Error;              // error that was reported last
};
}

#endif
