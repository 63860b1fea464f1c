// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions (--transfer) of relevo-view.
#include "Files/TransferFile.h"
#include "RelevoFuzzAssert.h"
#include "RelevoFuzzFolder.h"
#include "Text/ViewerMessages.h"

#include <string>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  static const RelevoFuzzFolder folder;
  const std::string file =
    folder.Write("a.csv", std::string(reinterpret_cast<const char*>(bytes), size));
  try
  {
    FUZZ_ASSERT(!ReadTransferFile(file).empty());
  }
  catch (const ViewerError&)
  {
    return 0; // the only exception that the viewer expects
  }
  return 0;
}
