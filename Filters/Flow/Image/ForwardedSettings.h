// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the setters of a class that has vtkLICSettings as a member LICSettings
 *
 * Private to the modules' own sources.
 */
#ifndef ForwardedSettings_h
#define ForwardedSettings_h

#include "Checks/SettingChecks.h"
#include "vtkLICSettings.h"
#include "vtkSmartPointer.h"

/// Have settings.
#define relevoLICSettingsMacro(holder)                                                        \
  void holder::SetLICSettings(vtkLICSettings* settings)                                       \
  {                                                                                           \
    if (!settings || settings != this->LICSettings)                                           \
    {                                                                                         \
      this->LICSettings = settings ? settings : vtkSmartPointer<vtkLICSettings>::New().Get(); \
      this->Modified();                                                                       \
    }                                                                                         \
  }                                                                                           \
  vtkLICSettings* holder::GetLICSettings() const                                              \
  {                                                                                           \
    return this->LICSettings;                                                                 \
  }

/// Set and get one of the settings. An error is that of the object that was asked.
#define relevoForwardMacro(holder, name, type)                                 \
  void holder::Set##name(type value)                                           \
  {                                                                            \
    this->LICSettings->ChangeFor(                                              \
      this, [value](vtkLICSettings& settings) { settings.Set##name(value); }); \
  }                                                                            \
  type holder::Get##name()                                                     \
  {                                                                            \
    return static_cast<type>(this->LICSettings->Get##name());                  \
  }

/// EnhanceContrast of a class that has no colours.
#define relevoForwardGreyContrastMacro(holder)                                \
  void holder::SetEnhanceContrast(int mode)                                   \
  {                                                                           \
    if (relevo::CheckChoice(this, "EnhanceContrast", mode, { "OFF", "LIC" })) \
    {                                                                         \
      this->LICSettings->SetEnhanceContrast(mode);                            \
    }                                                                         \
  }                                                                           \
  int holder::GetEnhanceContrast()                                            \
  {                                                                           \
    return this->LICSettings->GetEnhanceContrast();                           \
  }

#endif
