// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Messages of browsers to vtkWindowServer, separated by line ends.
#include "RelevoFuzzAssert.h"

#include "Messages/ClientMessage.h"

#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  using relevo::ClientMessage;
  std::istringstream text(std::string(reinterpret_cast<const char*>(bytes), size));
  for (std::string line; std::getline(text, line);)
  {
    const std::optional<ClientMessage> message = relevo::ParseMessage(line.data(), line.size());
    if (!message)
    {
      continue;
    }
    FUZZ_ASSERT(message->What != ClientMessage::Type::Gone);
    FUZZ_ASSERT(line.size() <= ClientMessage::LargestSize);
    FUZZ_ASSERT(message->Button >= 0 && message->Button <= 2);
    FUZZ_ASSERT(std::abs(message->Notches) <= 100);
    FUZZ_ASSERT(message->Modifiers >= 0 && message->Modifiers <= 7);
    FUZZ_ASSERT(message->Width >= 0 && message->Width <= ClientMessage::LargestWindow);
    FUZZ_ASSERT(message->Height >= 0 && message->Height <= ClientMessage::LargestWindow);
    FUZZ_ASSERT(message->Key.size() <= 32);
  }
  return 0;
}
