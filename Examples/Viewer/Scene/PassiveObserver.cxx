// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/PassiveObserver.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

namespace
{
class FunctionCommand : public vtkCommand
{
public:
  static FunctionCommand* New() { return new FunctionCommand; }

  void Execute(vtkObject*, unsigned long, void* data) override { this->Function(data); }

  std::function<void(void*)> Function;
};
}

//------------------------------------------------------------------------------
void AddPassiveObserver(
  vtkObject* object, unsigned long event, const std::function<void(void*)>& function)
{
  vtkNew<FunctionCommand> command;
  command->Function = function;
  command->SetPassiveObserver(1);
  object->AddObserver(event, command);
}
