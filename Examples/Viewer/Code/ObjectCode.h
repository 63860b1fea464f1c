// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes the settings of an object that differ from the defaults
 */
#ifndef ObjectCode_h
#define ObjectCode_h

#include "Code/SceneCode.h"

#include "vtkNew.h"

#include <functional>
#include <string>
#include <type_traits>

/// Adds Set<setting>() if the value differs from that of a new object of the class.
template <typename Object, typename Getter>
void AddSetting(
  SceneCode& code, const std::string& name, Object* object, const std::string& setting, Getter get)
{
  const vtkNew<Object> standard;
  const auto value = std::invoke(get, object);
  if (value == std::invoke(get, standard.Get()))
  {
    return;
  }
  if constexpr (std::is_floating_point_v<decltype(value)>)
  {
    code.Call(name, "Set" + setting, { static_cast<double>(value) });
  }
  else
  {
    code.Call(name, "Set" + setting, { static_cast<long long>(value) });
  }
}

/// Adds <flag>On() or <flag>Off() if the value differs from that of a new object of the class.
template <typename Object, typename Getter>
void AddFlag(
  SceneCode& code, const std::string& name, Object* object, const std::string& flag, Getter get)
{
  const vtkNew<Object> standard;
  const bool value = static_cast<bool>(std::invoke(get, object));
  if (value != static_cast<bool>(std::invoke(get, standard.Get())))
  {
    code.Call(name, flag + (value ? "On" : "Off"));
  }
}

#endif
