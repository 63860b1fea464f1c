// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/GDALSession.h"

#include <cpl_error.h>

#include <algorithm>

namespace relevo
{
namespace
{
// Each level of GDAL reports the same failure with more context: a message replaces what it quotes.
void CPL_STDCALL Collect(CPLErr severity, CPLErrorNum number, const char* text)
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
  auto* errors = static_cast<GDALSession::Collection*>(CPLGetErrorHandlerUserData());
  errors->OfFiles = errors->OfFiles || number == CPLE_FileIO;
  std::vector<std::string>& texts = errors->Texts;
  texts.erase(
    std::remove_if(texts.begin(), texts.end(),
      [&](const std::string& earlier) { return message.find(earlier) != std::string::npos; }),
    texts.end());
  texts.push_back(message);
}
}

GDALSession::GDALSession()
{
  static const bool registered = (GDALAllRegister(), true);
  static_cast<void>(registered);
  CPLPushErrorHandlerEx(&Collect, &this->Errors);
}

GDALSession::~GDALSession()
{
  CPLPopErrorHandler();
}

std::string GDALSession::Messages(const std::string& fallback) const
{
  std::string text;
  for (const std::string& message : this->Errors.Texts)
  {
    text += (text.empty() ? "" : "; ") + message;
  }
  return text.empty() ? fallback : text;
}
}
