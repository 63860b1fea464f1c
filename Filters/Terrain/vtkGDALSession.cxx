// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGDALSession.h"

#include <cpl_error.h>

#include <algorithm>

namespace relevo
{
namespace
{
// Each level of GDAL reports the same failure with more context: a message replaces what it quotes.
void CPL_STDCALL Collect(CPLErr severity, CPLErrorNum, const char* text)
{
  if (severity < CE_Failure)
  {
    return;
  }
  std::string message(text);
  while (!message.empty() && (message.back() == '.' || message.back() == '\n'))
  {
    message.pop_back();
  }
  auto* messages = static_cast<std::vector<std::string>*>(CPLGetErrorHandlerUserData());
  messages->erase(
    std::remove_if(messages->begin(), messages->end(),
      [&](const std::string& earlier) { return message.find(earlier) != std::string::npos; }),
    messages->end());
  messages->push_back(message);
}
}

GDALSession::GDALSession()
{
  static const bool registered = (GDALAllRegister(), true);
  static_cast<void>(registered);
  CPLPushErrorHandlerEx(&Collect, &this->Collected);
}

GDALSession::~GDALSession()
{
  CPLPopErrorHandler();
}

std::string GDALSession::Messages(const std::string& fallback) const
{
  std::string text;
  for (const std::string& message : this->Collected)
  {
    text += (text.empty() ? "" : "; ") + message;
  }
  return text.empty() ? fallback : text;
}
}
