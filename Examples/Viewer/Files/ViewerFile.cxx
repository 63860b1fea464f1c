// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ViewerFile.h"

#include "Files/AtomicFile.h"
#include "Text/ViewerMessages.h"

#include <exception>
#include <new>

//------------------------------------------------------------------------------
void CheckFile(const std::string& fileName)
{
  const std::string error = FindReadError(fileName);
  if (!error.empty())
  {
    throw ViewerError("cannot read " + fileName + ": " + error);
  }
}

//------------------------------------------------------------------------------
bool CanRead(const std::string& fileName)
{
  return FindReadError(fileName).empty();
}

//------------------------------------------------------------------------------
void CheckOutput(const std::string& fileName)
{
  const std::string error = relevo::AtomicFile::FindError(fileName);
  if (!error.empty())
  {
    throw ViewerError("cannot write " + fileName + ": " + error);
  }
}

//------------------------------------------------------------------------------
void ThrowReadingError(const std::string& fileName)
{
  const std::string start = "cannot read " + fileName + ": ";
  try
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw ViewerError(
      start + "not enough memory; the file is damaged, or too large for this machine");
  }
  catch (const std::exception& error)
  {
    const std::string text = error.what();
    throw ViewerError(text.find(fileName) != std::string::npos ? text : start + text);
  }
}
