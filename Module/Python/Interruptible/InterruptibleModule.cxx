// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The extension module relevo._interruptible: long calls of VTK that let other threads of Python
// run, and that stop when Python asks for it. VTK's own wrappers keep Python's lock.

#include "StopObserver.h"

#include <vtkAlgorithm.h>
#include <vtkNew.h>
#include <vtkPythonUtil.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <set>
#include <utility>
#include <vector>

namespace
{
constexpr unsigned long TimerPause = 100; // milliseconds between questions in an event loop

/// Parse the arguments: an object of VTK and the question whether to stop.
template <typename Class>
vtkSmartPointer<Class> ParseArguments(
  PyObject* arguments, const char* className, PyObject** question)
{
  PyObject* object = nullptr;
  if (!PyArg_ParseTuple(arguments, "OO", &object, question))
  {
    return nullptr;
  }
  // This sets a TypeError if the object is of another class.
  return static_cast<Class*>(vtkPythonUtil::GetPointerFromObject(object, className));
}

/// Call a function without Python's lock.
template <typename Function>
void CallWithoutLock(const Function& function)
{
  PyThreadState* state = PyEval_SaveThread();
  function();
  PyEval_RestoreThread(state);
}

void AddInputs(vtkAlgorithm* algorithm, std::set<vtkSmartPointer<vtkAlgorithm>>& found)
{
  if (!algorithm || !found.insert(algorithm).second)
  {
    return;
  }
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      AddInputs(algorithm->GetInputAlgorithm(port, i), found);
    }
  }
}

PyObject* UpdateAlgorithm(PyObject*, PyObject* arguments)
{
  PyObject* question = nullptr;
  const auto last = ParseArguments<vtkAlgorithm>(arguments, "vtkAlgorithm", &question);
  if (!last)
  {
    return nullptr;
  }
  vtkNew<relevo::StopObserver> observer;
  observer->SetQuestion(question);
  std::set<vtkSmartPointer<vtkAlgorithm>> algorithms;
  AddInputs(last, algorithms);
  std::vector<std::pair<vtkAlgorithm*, unsigned long>> tags;
  for (vtkAlgorithm* algorithm : algorithms)
  {
    tags.emplace_back(algorithm, algorithm->AddObserver(vtkCommand::ProgressEvent, observer));
  }
  CallWithoutLock([&last] { last->Update(); });
  for (const auto& [algorithm, tag] : tags)
  {
    algorithm->RemoveObserver(tag);
    if (observer->IsStopped() && algorithm->GetAbortExecute())
    {
      // The next update must not take a partial output for a complete one.
      algorithm->SetAbortExecute(0);
      algorithm->Modified();
    }
  }
  Py_RETURN_NONE;
}

PyObject* RenderWindow(PyObject*, PyObject* arguments)
{
  PyObject* question = nullptr;
  const auto window = ParseArguments<vtkRenderWindow>(arguments, "vtkRenderWindow", &question);
  if (!window)
  {
    return nullptr;
  }
  vtkNew<relevo::StopObserver> observer;
  observer->SetQuestion(question);
  const unsigned long tag = window->AddObserver(vtkCommand::AbortCheckEvent, observer);
  CallWithoutLock([&window] { window->Render(); });
  window->RemoveObserver(tag);
  window->SetAbortRender(0);
  Py_RETURN_NONE;
}

PyObject* StartInteractor(PyObject*, PyObject* arguments)
{
  PyObject* question = nullptr;
  const auto interactor =
    ParseArguments<vtkRenderWindowInteractor>(arguments, "vtkRenderWindowInteractor", &question);
  if (!interactor)
  {
    return nullptr;
  }
  vtkNew<relevo::StopObserver> observer;
  observer->SetQuestion(question);
  const unsigned long tag = interactor->AddObserver(vtkCommand::TimerEvent, observer);
  const int timer = interactor->CreateRepeatingTimer(TimerPause);
  CallWithoutLock([&interactor] { interactor->Start(); });
  interactor->DestroyTimer(timer);
  interactor->RemoveObserver(tag);
  Py_RETURN_NONE;
}

PyMethodDef Methods[] = {
  { "update", UpdateAlgorithm, METH_VARARGS,
    "update(algorithm, is_stopped)\n\nUpdate an algorithm and those before it." },
  { "render", RenderWindow, METH_VARARGS, "render(window, is_stopped)\n\nRender a window." },
  { "start", StartInteractor, METH_VARARGS,
    "start(interactor, is_stopped)\n\nRun the event loop of a window." },
  { nullptr, nullptr, 0, nullptr },
};

PyModuleDef Definition = { PyModuleDef_HEAD_INIT, "_interruptible",
  "Long calls of VTK without Python's lock. is_stopped() returns whether they must stop.", -1,
  Methods, nullptr, nullptr, nullptr, nullptr };
}

PyMODINIT_FUNC PyInit__interruptible()
{
  return PyModule_Create(&Definition);
}
