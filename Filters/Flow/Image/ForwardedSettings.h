// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   macros for the setters of classes with a member LICSettings
 *
 * Private to the modules.
 */
#ifndef ForwardedSettings_h
#define ForwardedSettings_h

#include "Checks/SettingChecks.h"
#include "vtkLICSettings.h"
#include "vtkSmartPointer.h"

/// Defines the setter and getter of the settings object.
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

/// Defines the setter and getter of a setting. `holder` reports the errors.
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

/// Defines SetEnhanceContrast() and its getter for a class without colours.
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
