// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The warnings of an object, counted.
#ifndef RelevoWarnings_h
#define RelevoWarnings_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <string>

// Lives at least as long as the object warns; none of the warnings is printed.
class RelevoWarnings
{
public:
  explicit RelevoWarnings(vtkObject* object)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        ++static_cast<RelevoWarnings*>(self)->Number;
        static_cast<RelevoWarnings*>(self)->Text = static_cast<const char*>(text);
      });
    object->AddObserver(vtkCommand::WarningEvent, command);
  }
  int Number = 0;
  std::string Text;
};

#endif
