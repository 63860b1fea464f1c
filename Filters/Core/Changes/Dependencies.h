// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Dependencies
 * @brief   what something was made from, to tell whether it has to be made anew
 *
 * A list of numbers, texts, and objects with the time of what matters of them. What asks "has it
 * changed?" compares the list of now with the list of then, or, where it depends on a single time
 * stamp, compares that as it is. Objects are compared, never read.
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
  /// On nothing, as what has not been made yet.
  Dependencies() = default;

  /// On these, see Add().
  template <typename... T>
  static Dependencies On(const T&... values)
  {
    Dependencies dependencies;
    (dependencies.Add(values), ...);
    return dependencies;
  }

  //@{
  /**
   * Add a number, as a time, a flag or an enumerator, by its bits; or a text.
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

  /// Add which object it is, or nullptr for none, and when what matters of it changed.
  void AddObject(const void* object, vtkMTimeType time)
  {
    this->Add(reinterpret_cast<std::size_t>(object));
    this->Add(time);
  }

  /// Add an object, or nullptr for none, all of which matters.
  template <typename T>
  void AddObject(T* object)
  {
    this->AddObject(object, object ? object->GetMTime() : 0);
  }

  /// Become those of now. Returns whether they are others; writes nothing where they are the same.
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
