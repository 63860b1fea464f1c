// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/NumberText.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <sstream>

namespace
{
const std::size_t Columns = 100;
}

//------------------------------------------------------------------------------
std::string WriteNumber(double number)
{
  std::array<char, 64> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  std::string text(digits.data(), end);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

//------------------------------------------------------------------------------
std::string Quote(const std::string& text)
{
  std::string quoted = "\"";
  for (const char sign : text)
  {
    if (sign == '"' || sign == '\\')
    {
      quoted += std::string("\\") + sign;
    }
    else if (sign == '\n')
    {
      quoted += "\\n";
    }
    else if (static_cast<unsigned char>(sign) < ' ')
    {
      std::array<char, 8> octal; // three digits end an escape in both languages
      std::snprintf(octal.data(), octal.size(), "\\%03o", static_cast<unsigned>(sign));
      quoted += octal.data();
    }
    else
    {
      quoted += sign;
    }
  }
  return quoted + "\"";
}

//------------------------------------------------------------------------------
std::string WrapComment(const std::string& text, const std::string& start)
{
  std::istringstream words(text);
  std::string lines;
  std::string line = start;
  std::string word;
  while (words >> word)
  {
    if (line != start && line.size() + 1 + word.size() > Columns)
    {
      lines += line + "\n";
      line = start;
    }
    line += (line == start ? "" : " ") + word;
  }
  return lines + line + "\n";
}
