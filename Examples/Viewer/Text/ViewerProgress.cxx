// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Text/ViewerProgress.h"

#include "Text/StandardError.h"

#include <algorithm>
#include <unistd.h>

//------------------------------------------------------------------------------
ViewerProgress::ViewerProgress()
  : IsTerminal(isatty(STDERR_FILENO) != 0)
{
}

//------------------------------------------------------------------------------
ViewerProgress::~ViewerProgress()
{
  this->Clear();
}

//------------------------------------------------------------------------------
void ViewerProgress::Show(const std::string& work)
{
  this->Work = work;
  this->LastTime = {}; // shows the first share at once
  this->Write(work);
}

//------------------------------------------------------------------------------
void ViewerProgress::Show(const std::string& work, double share)
{
  if (share >= 1.0)
  {
    this->Clear();
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (work != this->Work || now - this->LastTime > std::chrono::milliseconds(100))
  {
    this->Work = work;
    this->LastTime = now;
    this->Write(work + " " + std::to_string(static_cast<int>(100.0 * share)) + " %");
  }
}

//------------------------------------------------------------------------------
void ViewerProgress::Clear()
{
  if (this->Length > 0)
  {
    this->Write("");
    WriteToStandardError("\r", 1);
  }
}

//------------------------------------------------------------------------------
void ViewerProgress::Write(const std::string& line)
{
  if (this->IsTerminal)
  {
    const std::size_t length = std::max(line.size(), this->Length);
    const std::string text = "\r" + line + std::string(length - line.size(), ' ');
    WriteToStandardError(text.data(), text.size());
    this->Length = line.size();
  }
}
