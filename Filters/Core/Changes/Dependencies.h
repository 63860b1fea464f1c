// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Dependencies
 * @brief   the values that a result was computed from, to find out whether it is out of date
 *
 * This is a list of numbers, strings and objects with their modification times. To find out whether
 * a result is out of date, compare the list at the time of its computation with the current list. A
 * result that depends on a single time can compare that time directly. Objects are compared by
 * address and never read.
 */
#ifndef Dependencies_h
#define Dependencies_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkTimeStamp.h"            // for times
#include "vtkType.h"                 // for vtkMTimeType

#include <cstddef>     // for size_t
#include <string>      // for texts
#include <type_traits> // for whole numbers
#include <utility>     // for move
#include <vector>      // for members

namespace relevo
{
class RELEVOFILTERSCORE_EXPORT Dependencies
{
public:
  /// Empty: the result has not been computed yet.
  Dependencies() = default;

  /// Create a list with these values, see Add().
  template <typename... T>
  static Dependencies On(const T&... values)
  {
    Dependencies dependencies;
    (dependencies.Add(values), ...);
    return dependencies;
  }

  //@{
  /**
   * Add a number, such as a time, a flag or an enumerator, or a string.
   */
  template <typename T,
    std::enable_if_t<std::is_integral<T>::value || std::is_enum<T>::value, int> = 0>
  void Add(T value)
  {
    this->Values.push_back(static_cast<vtkMTimeType>(value));
  }
  void Add(double value);
  void Add(const vtkTimeStamp& time) { this->Values.push_back(time.GetMTime()); }
  void Add(const std::string& text);
  //@}

  /// Add an object, which may be nullptr, with the time of its latest relevant change.
  void AddObject(const void* object, vtkMTimeType time)
  {
    this->Add(reinterpret_cast<std::size_t>(object));
    this->Add(time);
  }

  /// Add an object, which may be nullptr, with its modification time.
  template <typename T>
  void AddObject(T* object)
  {
    this->AddObject(object, object ? object->GetMTime() : 0);
  }

  /// Replace the list by the current one. Returns whether they differ. If they are equal, nothing
  /// is written.
  bool Update(Dependencies now)
  {
    const bool changed = *this != now;
    if (changed)
    {
      *this = std::move(now);
    }
    return changed;
  }

  bool IsEmpty() const { return this->Values.empty(); }
  void Clear() { this->Values.clear(); }

  bool operator==(const Dependencies& other) const { return this->Values == other.Values; }
  bool operator!=(const Dependencies& other) const { return !(*this == other); }
  bool operator<(const Dependencies& other) const { return this->Values < other.Values; }

private:
  std::vector<vtkMTimeType> Values;
};
}

#endif
