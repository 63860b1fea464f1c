// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoWarnings.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

RelevoWarnings::RelevoWarnings(vtkObject* object)
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
