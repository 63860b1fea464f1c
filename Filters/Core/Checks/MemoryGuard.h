// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   out of memory as an error like any other
 *
 * Private to the modules' own sources.
 */
#ifndef MemoryGuard_h
#define MemoryGuard_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkObject.h"

#include <new>
#include <stdexcept>

namespace relevo
{
/// Whether the body finds the memory that it asks for. Sizes beyond what containers can hold count
/// as memory that there is not.
template <typename Body>
bool FitsMemory(const Body& body)
{
  try
  {
    body();
    return true;
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
  catch (const std::length_error&)
  {
    return false;
  }
}

/// The body's result; without enough memory false, after an ErrorEvent of the object. `purpose`
/// follows "Not enough memory for ".
template <typename Body>
bool RunWithinMemory(vtkObject* object, const char* purpose, const Body& body)
{
  bool result = false;
  if (!FitsMemory([&] { result = body(); }))
  {
    vtkErrorWithObjectMacro(object, "Not enough memory for " << purpose << ".");
    return false;
  }
  return result;
}

/// The same of an algorithm's request, whose outputs become empty.
template <typename Body>
int RequestWithinMemory(
  vtkAlgorithm* algorithm, vtkInformationVector* outputs, const char* purpose, const Body& body)
{
  int result = 0;
  if (FitsMemory([&] { result = body(); }))
  {
    return result;
  }
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      output->Initialize();
    }
  }
  vtkErrorWithObjectMacro(algorithm, "Not enough memory for " << purpose << ".");
  return 0;
}
}

#endif
