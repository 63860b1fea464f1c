// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   InputCheck
 * @brief   whether a mapper takes the type of its input, reported once for each input
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
  /// An input, nullptr for none, of a port.
  StageResult Update(vtkDataObject* input, vtkInformation* port);

private:
  vtkDataObject* Input = nullptr; // to compare, never read
  std::string Error;              // that was reported last
};
}

#endif
