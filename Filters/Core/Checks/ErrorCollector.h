// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   collects the errors of a reader or writer that another object uses and reports
 */
#ifndef ErrorCollector_h
#define ErrorCollector_h

#include "vtkCallbackCommand.h"
#include "vtkSmartPointer.h"

#include <string>

namespace relevo
{
/// Create an observer of ErrorEvents that appends their messages to a string.
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
