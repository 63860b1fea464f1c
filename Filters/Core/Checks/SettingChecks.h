// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   setters that report an error and keep the old value if a value is out of range
 */
#ifndef SettingChecks_h
#define SettingChecks_h

#include "vtkObject.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>

namespace relevo
{
constexpr double LargestDouble = std::numeric_limits<double>::max();

/// "must be in [0, 1]", "must be at least 0", "must be a finite number".
template <typename T>
std::string DescribeRange(T lowest, T highest)
{
  std::ostringstream text;
  if (highest < std::numeric_limits<T>::max())
  {
    text << "must be in [" << lowest << ", " << highest << "]";
  }
  else if (lowest == std::numeric_limits<T>::lowest())
  {
    text << "must be a finite number";
  }
  else
  {
    text << "must be at least " << lowest
         << (std::is_floating_point<T>::value ? " and finite" : "");
  }
  return text.str();
}

/**
 * Return whether the value is in [lowest, highest], which is false for NaN. Otherwise reports an
 * error of the object. `hint` is a sentence that follows the message.
 */
template <typename T>
bool CheckRange(
  vtkObject* object, const char* name, T value, T lowest, T highest, const char* hint = "")
{
  const bool isInRange = value >= lowest && value <= highest;
  if (!isInRange)
  {
    vtkErrorWithObjectMacro(
      object, << name << " " << DescribeRange(lowest, highest) << ", got " << value << "." << hint);
  }
  return isInRange;
}

template <typename T>
void SetInRange(vtkObject* object, const char* name, T& setting, T value, T lowest, T highest,
  const char* hint = "")
{
  if (CheckRange(object, name, value, lowest, highest, hint) && setting != value)
  {
    setting = value;
    object->Modified();
  }
}

/// "must be one of HOLE (0), FILL (1)", from the names of 0, 1 and so on.
inline std::string DescribeChoices(std::initializer_list<const char*> names)
{
  std::ostringstream text;
  int value = 0;
  for (const char* name : names)
  {
    text << (value == 0 ? "must be one of " : ", ") << name << " (" << value << ")";
    ++value;
  }
  return text.str();
}

/**
 * Return whether the value is a choice: 0, 1 and so on, in the order of `names`. Otherwise reports
 * an error.
 */
inline bool CheckChoice(
  vtkObject* object, const char* name, int value, std::initializer_list<const char*> names)
{
  const bool isChoice = value >= 0 && value < static_cast<int>(names.size());
  if (!isChoice)
  {
    vtkErrorWithObjectMacro(
      object, << name << " " << DescribeChoices(names) << ", got " << value << ".");
  }
  return isChoice;
}

inline void SetChoice(vtkObject* object, const char* name, int& setting, int value,
  std::initializer_list<const char*> names)
{
  if (CheckChoice(object, name, value, names) && setting != value)
  {
    setting = value;
    object->Modified();
  }
}

/**
 * Return whether all components are in [lowest, highest]. Otherwise reports one error.
 */
template <std::size_t Size>
bool CheckVector(vtkObject* object, const char* name, const std::array<double, Size>& values,
  double lowest, double highest)
{
  const bool isInRange = std::all_of(values.begin(), values.end(),
    [=](double value) { return value >= lowest && value <= highest; });
  if (!isInRange)
  {
    std::ostringstream text;
    for (double value : values)
    {
      text << (text.tellp() > 0 ? ", " : "(") << value;
    }
    vtkErrorWithObjectMacro(object, << "Each component of " << name << " "
                                    << DescribeRange(lowest, highest) << ", got " << text.str()
                                    << ").");
  }
  return isInRange;
}

template <std::size_t Size>
void SetVector(vtkObject* object, const char* name, double (&setting)[Size],
  const std::array<double, Size>& values, double lowest, double highest)
{
  if (CheckVector(object, name, values, lowest, highest) &&
    !std::equal(values.begin(), values.end(), setting))
  {
    std::copy(values.begin(), values.end(), setting);
    object->Modified();
  }
}

/**
 * Set the width and height of an image in pixels, each at least 1.
 */
inline void SetPixelSize(
  vtkObject* object, const char* name, int (&setting)[2], int width, int height)
{
  if (width < 1 || height < 1)
  {
    vtkErrorWithObjectMacro(
      object, << name << " must be at least 1 x 1 pixels, got " << width << " x " << height << ".");
  }
  else if (setting[0] != width || setting[1] != height)
  {
    setting[0] = width;
    setting[1] = height;
    object->Modified();
  }
}

/**
 * Set the magnitude at and above which numbers are missing values. It must be positive; infinity
 * turns this off.
 */
inline void SetNoDataMagnitude(vtkObject* object, double& setting, double magnitude)
{
  if (!(magnitude > 0.0))
  {
    vtkErrorWithObjectMacro(
      object, << "NoDataMagnitude must be more than 0, got " << magnitude << ".");
  }
  else if (setting != magnitude)
  {
    setting = magnitude;
    object->Modified();
  }
}
}

#endif
