// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reports lack of memory as an error
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
/// Run the body and return whether it gets the memory that it allocates. Sizes that containers do
/// not support are treated as lack of memory.
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

/// Run the body and return its result. If memory runs out, reports an error of the object and
/// returns false. `purpose` follows "Not enough memory for ".
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

/// Does the same for a request of an algorithm, and clears its outputs after an error.
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
