// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPrinted.h"

#include <cstdio>
#include <cstdlib>

std::string relevoPrinted::Signed(long long value)
{
  return std::to_string(value);
}

std::string relevoPrinted::Unsigned(unsigned long long value)
{
  return std::to_string(value);
}

std::string relevoPrinted::Number(double value)
{
  char text[40] = "";
  for (int digits = 6; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof(text), "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value)
    {
      break;
    }
  }
  return text;
}

std::string relevoPrinted::Text(const std::string& value)
{
  return '"' + value + '"';
}

std::string relevoPrinted::Text(const char* value)
{
  return value ? Text(std::string(value)) : "a null pointer";
}

std::string relevoPrinted::Pointer(const void* value)
{
  char text[40] = "a null pointer";
  if (value)
  {
    std::snprintf(text, sizeof(text), "%p", value);
  }
  return text;
}

std::string relevoPrinted::Range(const std::vector<std::string>& values, std::size_t size)
{
  std::string text = "[";
  for (const std::string& value : values)
  {
    text += (text.size() > 1 ? ", " : "") + value;
  }
  if (values.size() < size)
  {
    text += ", ... of " + std::to_string(size);
  }
  return text + "]";
}
