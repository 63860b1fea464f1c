// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SettingChecks
 * @brief   what a setter does with a value that is out of range: an ErrorEvent, and the old value
 *          is kept
 *
 * Private to Relevo's own sources.
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
/// Of what can be sent to a shader.
constexpr double LargestFloat = VTK_FLOAT_MAX;

/// "in [0, 1]", "at least 0", "a finite float": the rest of a sentence that begins "NAME must be".
template <typename T>
std::string DescribeRange(T lowest, T highest)
{
  const bool isUnlimited = highest == std::numeric_limits<T>::max();
  const bool isFloat = std::is_floating_point<T>::value && highest == static_cast<T>(LargestFloat);
  std::ostringstream text;
  if (std::is_floating_point<T>::value && (isUnlimited || isFloat))
  {
    text << (isFloat ? "a finite float" : "a finite number");
    if (lowest != -highest)
    {
      text << " of at least " << lowest;
    }
  }
  else if (isUnlimited)
  {
    text << "at least " << lowest;
  }
  else
  {
    text << "in [" << lowest << ", " << highest << "]";
  }
  return text.str();
}

/**
 * Whether the value is in [lowest, highest], which NaN never is; else an ErrorEvent of the object.
 */
template <typename T>
bool CheckRange(vtkObject* object, const char* name, T value, T lowest, T highest)
{
  const bool isInRange = value >= lowest && value <= highest;
  if (!isInRange)
  {
    vtkErrorWithObjectMacro(
      object, << name << " must be " << DescribeRange(lowest, highest) << ", got " << value << ".");
  }
  return isInRange;
}

template <typename T>
void SetInRange(vtkObject* object, const char* name, T& setting, T value, T lowest, T highest)
{
  if (CheckRange(object, name, value, lowest, highest) && setting != value)
  {
    setting = value;
    object->Modified();
  }
}

/// "HOLE (0) or FILL (1)", by the names of 0, 1 and so on.
inline std::string DescribeChoices(std::initializer_list<const char*> names)
{
  std::ostringstream text;
  std::size_t value = 0;
  for (const char* name : names)
  {
    text << (value == 0                     ? ""
                : value + 1 == names.size() ? " or "
                                            : ", ")
         << name << " (" << value << ")";
    ++value;
  }
  return text.str();
}

/**
 * Whether the value is one of 0, 1 and so on, which have these names; else an ErrorEvent.
 */
inline bool CheckChoice(
  vtkObject* object, const char* name, int value, std::initializer_list<const char*> names)
{
  const bool isChoice = value >= 0 && value < static_cast<int>(names.size());
  if (!isChoice)
  {
    vtkErrorWithObjectMacro(
      object, << name << " must be " << DescribeChoices(names) << ", got " << value << ".");
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
 * Whether all components are in [lowest, highest]; else one ErrorEvent.
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
    vtkErrorWithObjectMacro(object, << "Each component of " << name << " must be "
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
 * Width and height of a picture in pixels, at least 1 each.
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
 * A magnitude from which on a number stands for "no data": more than 0, infinity for none.
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
