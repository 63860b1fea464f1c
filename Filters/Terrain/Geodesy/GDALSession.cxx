// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/GDALSession.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>

#include <algorithm>

namespace relevo
{
namespace
{
// These are set to NO.
constexpr std::array<const char*, 2> OptionNames = { { "GDAL_ONE_BIG_READ", "VRT_SHARED_SOURCE" } };

// These are set unless the user has set them.
struct DefaultOption
{
  const char* Name;
  const char* Value;
};
constexpr std::array<DefaultOption, 5> Defaults = { {
  { "GDAL_HTTP_CONNECTTIMEOUT", "20" },                                       // seconds
  { "GDAL_HTTP_LOW_SPEED_TIME", "20" }, { "GDAL_HTTP_LOW_SPEED_LIMIT", "1" }, // bytes per second
  { "GDAL_HTTP_MAX_RETRY", "2" }, { "GDAL_HTTP_RETRY_DELAY", "0.5" } // seconds; GDAL doubles them
} };

// libjpeg issues this warning and fills missing parts with grey. GDAL appends advice on how to turn
// it into an error.
constexpr char CutShort[] = "Premature end of JPEG file";
constexpr char Advice[] = " (this warning can be turned";

// Each layer of GDAL reports the same failure with more context. A message that quotes earlier ones
// replaces them.
void CPL_STDCALL Collect(CPLErr severity, CPLErrorNum number, const char* text)
{
  std::string message(text);
  const bool isCutShort = message.find(CutShort) != std::string::npos;
  if (severity < CE_Failure && !isCutShort)
  {
    return;
  }
  message.erase(std::min(message.find(Advice), message.size()));
  while (!message.empty() && (message.back() == '.' || message.back() == '\n'))
  {
    message.pop_back();
  }
  auto* errors = static_cast<GDALSession::Collection*>(CPLGetErrorHandlerUserData());
  errors->HasFileErrors = errors->HasFileErrors || number == CPLE_FileIO || isCutShort;
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
  for (std::size_t i = 0; i < OptionNames.size(); ++i)
  {
    if (const char* value = CPLGetThreadLocalConfigOption(OptionNames[i], nullptr))
    {
      this->PreviousValues[i] = value;
    }
    CPLSetThreadLocalConfigOption(OptionNames[i], "NO");
  }
  for (std::size_t i = 0; i < Defaults.size(); ++i)
  {
    this->IsDefault[i] = CPLGetConfigOption(Defaults[i].Name, nullptr) == nullptr;
    if (this->IsDefault[i])
    {
      CPLSetThreadLocalConfigOption(Defaults[i].Name, Defaults[i].Value);
    }
  }
}

GDALSession::~GDALSession()
{
  for (std::size_t i = 0; i < OptionNames.size(); ++i)
  {
    const std::optional<std::string>& value = this->PreviousValues[i];
    CPLSetThreadLocalConfigOption(OptionNames[i], value ? value->c_str() : nullptr);
  }
  for (std::size_t i = 0; i < Defaults.size(); ++i)
  {
    if (this->IsDefault[i])
    {
      CPLSetThreadLocalConfigOption(Defaults[i].Name, nullptr);
    }
  }
  CPLPopErrorHandler();
}

void GDALSession::ForgetFile(const std::string& fileName)
{
  if (IsVirtual(fileName))
  {
    VSICurlPartialClearCache(fileName.c_str());
  }
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
