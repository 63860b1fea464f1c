// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The extension module relevo._filechecks: finds damaged files before VTK's readers read them, as
// relevo-view does.

#include <vtkPython.h> // before standard headers

#include "FileEnd.h"
#include "FileNames.h"
#include "GLTFCheck.h"

#include <exception>
#include <string>
#include <vector>

namespace
{
/// Throws an exception for a damaged file.
void CheckDamage(const std::string& fileName, std::vector<std::string>& warnings)
{
  CheckFileEnd(fileName, [&warnings](const std::string& text) { warnings.push_back(text); });
  const std::string extension = GetExtension(fileName);
  if (extension == ".gltf" || extension == ".glb")
  {
    CheckGLTF(fileName);
  }
}

PyObject* Check(PyObject*, PyObject* name)
{
  const char* text = PyUnicode_AsUTF8(name);
  if (!text)
  {
    return nullptr;
  }
  const std::string fileName = text;
  std::vector<std::string> warnings;
  std::string error;
  PyThreadState* state = PyEval_SaveThread();
  try
  {
    CheckDamage(fileName, warnings);
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  PyEval_RestoreThread(state);
  if (!error.empty())
  {
    PyErr_SetString(PyExc_ValueError, error.c_str());
    return nullptr;
  }
  PyObject* list = PyList_New(0);
  for (const std::string& warning : warnings)
  {
    PyObject* item = PyUnicode_FromString(warning.c_str());
    if (!item || PyList_Append(list, item) < 0)
    {
      Py_XDECREF(item);
      Py_DECREF(list);
      return nullptr;
    }
    Py_DECREF(item);
  }
  return list;
}

PyMethodDef Methods[] = {
  { "check", Check, METH_O,
    "check(name)\n\nReturn warnings about a file. Raise ValueError with the fault of a damaged "
    "one." },
  { nullptr, nullptr, 0, nullptr },
};

PyModuleDef Definition = { PyModuleDef_HEAD_INIT, "_filechecks", "Finds damaged files.", -1,
  Methods, nullptr, nullptr, nullptr, nullptr };
}

PyMODINIT_FUNC PyInit__filechecks()
{
  return PyModule_Create(&Definition);
}
