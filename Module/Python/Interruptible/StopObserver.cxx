// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StopObserver.h"

#include <vtkAlgorithm.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

namespace
{
constexpr std::chrono::milliseconds Pause(50);

void Abort(vtkObject* caller)
{
  if (vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(caller))
  {
    algorithm->SetAbortExecute(1);
  }
  else if (vtkRenderWindow* window = vtkRenderWindow::SafeDownCast(caller))
  {
    window->SetAbortRender(1);
  }
  else if (vtkRenderWindowInteractor* interactor = vtkRenderWindowInteractor::SafeDownCast(caller))
  {
    interactor->TerminateApp();
  }
}
}

namespace relevo
{
//------------------------------------------------------------------------------
void StopObserver::Execute(vtkObject* caller, unsigned long, void*)
{
  const auto now = std::chrono::steady_clock::now();
  if (!this->Stopped && now >= this->Next)
  {
    this->Ask();
    this->Next = std::chrono::steady_clock::now() + Pause;
  }
  if (this->Stopped)
  {
    Abort(caller);
  }
}

//------------------------------------------------------------------------------
void StopObserver::Ask()
{
  const vtkPythonScopeGilEnsurer lock(true);
  PyObject* answer = PyObject_CallObject(this->Question, nullptr);
  if (!answer)
  {
    PyErr_WriteUnraisable(this->Question);
  }
  this->Stopped = !answer || PyObject_IsTrue(answer) != 0;
  Py_XDECREF(answer);
}
}
