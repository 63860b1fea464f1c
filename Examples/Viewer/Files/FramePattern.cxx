// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FramePattern.h"

#include <vtksys/RegularExpression.hxx>

//------------------------------------------------------------------------------
bool IsFramePattern(const std::string& name)
{
  vtksys::RegularExpression pattern("^[^%]*%(0[1-9])?d[^%/]*$");
  return pattern.find(name);
}

//------------------------------------------------------------------------------
std::string MakeFrameName(const std::string& pattern, std::size_t number)
{
  const std::size_t begin = pattern.find('%');
  const std::size_t end = pattern.find('d', begin);
  const std::string width = pattern.substr(begin + 1, end - begin - 1);
  std::string digits = std::to_string(number);
  const std::size_t length = width.empty() ? 0 : std::stoul(width);
  digits.insert(0, length > digits.size() ? length - digits.size() : 0, '0');
  return pattern.substr(0, begin) + digits + pattern.substr(end + 1);
}
