// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ViewerFile.h"

#include "Files/AtomicFile.h"
#include "Text/ViewerMessages.h"

#include <filesystem>
#include <fstream>

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
