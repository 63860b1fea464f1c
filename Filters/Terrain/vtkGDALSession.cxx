// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGDALSession.h"

#include <cpl_error.h>

namespace relevo
{
namespace
{
void CPL_STDCALL Collect(CPLErr severity, CPLErrorNum, const char* message)
{
  auto* text = static_cast<std::string*>(CPLGetErrorHandlerUserData());
  if (severity >= CE_Failure && text->find(message) == std::string::npos)
  {
    *text += (text->empty() ? "" : "; ") + std::string(message);
  }
}
}

GDALSession::GDALSession()
{
  static const bool registered = (GDALAllRegister(), true);
  static_cast<void>(registered);
  CPLPushErrorHandlerEx(&Collect, &this->Text);
}

GDALSession::~GDALSession()
{
  CPLPopErrorHandler();
}

std::string GDALSession::Messages(const std::string& fallback) const
{
  return this->Text.empty() ? fallback : this->Text;
}
}
