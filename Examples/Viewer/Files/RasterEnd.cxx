// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/RasterEnd.h"

#include "FileEnd.h"
#include "Files/ViewerFile.h"
#include "Text/ViewerMessages.h"

//------------------------------------------------------------------------------
void CheckRasterEnd(const std::string& fileName, ViewerMessages& messages)
{
  try
  {
    if (CanRead(fileName))
    {
      CheckFileEnd(fileName, [&messages](const std::string& text) { messages.Warn(text); });
    }
  }
  catch (const ViewerError& error)
  {
    throw ViewerError("cannot read " + fileName + ": " + error.what());
  }
}
