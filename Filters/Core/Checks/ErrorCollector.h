// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the errors of a reader or writer that another object uses, and tells of itself
 *
 * Private to Relevo's own sources.
 */
#ifndef ErrorCollector_h
#define ErrorCollector_h

#include "vtkCallbackCommand.h"
#include "vtkSmartPointer.h"

#include <string>

namespace relevo
{
/// An observer of ErrorEvents that appends them to a string.
inline vtkSmartPointer<vtkCallbackCommand> NewErrorCollector(std::string& errors)
{
  auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(&errors);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* clientData, void* callData)
    {
      if (callData)
      {
        static_cast<std::string*>(clientData)->append(static_cast<const char*>(callData));
      }
    });
  return command;
}
}

#endif
