// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Text/StandardError.h"

#include "Text/PrintableText.h"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace
{
// The program's stderr, which is a duplicate while libraries are muted. Signal handlers read it.
std::atomic<int> OwnError{ STDERR_FILENO };

std::string& GetOwnName()
{
  static std::string name = "relevo-view";
  return name;
}
}

//------------------------------------------------------------------------------
void SetProgramName(const std::string& name)
{
  GetOwnName() = name;
}

//------------------------------------------------------------------------------
const std::string& GetProgramName()
{
  return GetOwnName();
}

//------------------------------------------------------------------------------
void WriteMessage(const std::string& kind, const std::string& text)
{
  const std::string line = GetProgramName() + ": " + kind + ": " + ToPrintable(text) + "\n";
  WriteToStandardError(line.data(), line.size());
}

//------------------------------------------------------------------------------
void WriteToStandardError(const char* text, std::size_t length)
{
  while (length > 0)
  {
    const ssize_t written = write(OwnError, text, length);
    if (written < 0 && errno != EINTR)
    {
      return;
    }
    text += written > 0 ? written : 0;
    length -= written > 0 ? static_cast<std::size_t>(written) : 0;
  }
}

//------------------------------------------------------------------------------
StandardErrorMute::StandardErrorMute()
{
  const int own = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (own >= 0 && nothing >= 0 && OwnError == STDERR_FILENO)
  {
    OwnError = own;
    dup2(nothing, STDERR_FILENO);
  }
  else if (own >= 0)
  {
    close(own);
  }
  if (nothing >= 0)
  {
    close(nothing);
  }
}

//------------------------------------------------------------------------------
StandardErrorMute::~StandardErrorMute()
{
  const int own = OwnError;
  if (own != STDERR_FILENO)
  {
    dup2(own, STDERR_FILENO);
    OwnError = STDERR_FILENO;
    close(own);
  }
}
