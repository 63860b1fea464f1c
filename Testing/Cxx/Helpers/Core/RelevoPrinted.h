// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Prints values for failed checks. Values that are not numbers, strings, pointers or ranges of
// these are printed as "?". The source file does the formatting, so that checks compile fast.
#ifndef RelevoPrinted_h
#define RelevoPrinted_h

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace relevoPrinted
{
std::string Signed(long long value);
std::string Unsigned(unsigned long long value);
// Prints the fewest digits that identify the number.
std::string Number(double value);
std::string Text(const std::string& value);
std::string Text(const char* value);
std::string Pointer(const void* value);
std::string Range(const std::vector<std::string>& values, std::size_t size);

constexpr std::size_t MaximumValues = 16;

template <class T, class = void>
struct IsRange : std::false_type
{
};

template <class T>
struct IsRange<T,
  std::void_t<decltype(std::begin(std::declval<const T&>())),
    decltype(std::size(std::declval<const T&>()))>> : std::true_type
{
};
}

template <class T>
std::string RelevoPrint(const T& value)
{
  if constexpr (std::is_same<T, bool>::value)
  {
    return value ? "true" : "false";
  }
  else if constexpr (std::is_enum<T>::value)
  {
    return relevoPrinted::Signed(static_cast<long long>(value));
  }
  else if constexpr (std::is_integral<T>::value && std::is_signed<T>::value)
  {
    return relevoPrinted::Signed(value);
  }
  else if constexpr (std::is_integral<T>::value)
  {
    return relevoPrinted::Unsigned(value);
  }
  else if constexpr (std::is_floating_point<T>::value)
  {
    return relevoPrinted::Number(static_cast<double>(value));
  }
  else if constexpr (std::is_convertible<const T&, const char*>::value ||
    std::is_convertible<const T&, std::string>::value)
  {
    return relevoPrinted::Text(value);
  }
  else if constexpr (std::is_convertible<const T&, const void*>::value)
  {
    return relevoPrinted::Pointer(value);
  }
  else if constexpr (relevoPrinted::IsRange<T>::value)
  {
    std::vector<std::string> values;
    for (const auto& each : value)
    {
      if (values.size() < relevoPrinted::MaximumValues)
      {
        values.push_back(RelevoPrint(each));
      }
    }
    return relevoPrinted::Range(values, std::size(value));
  }
  else
  {
    return "?";
  }
}

#endif
