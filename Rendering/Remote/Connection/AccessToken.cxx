// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connection/AccessToken.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

namespace relevo
{
//------------------------------------------------------------------------------
std::string MakeToken()
{
  std::array<char, 16> bytes = {};
  std::ifstream source("/dev/urandom", std::ios::binary);
  if (!source.read(bytes.data(), bytes.size()))
  {
    return "";
  }
  const std::string digits = "0123456789abcdef";
  std::string token;
  for (const char byte : bytes)
  {
    const auto value = static_cast<unsigned char>(byte);
    token += digits[value >> 4];
    token += digits[value & 15];
  }
  return token;
}

//------------------------------------------------------------------------------
bool IsToken(const std::string& text)
{
  return !text.empty() &&
    std::all_of(text.begin(), text.end(),
      [](unsigned char character)
      {
        return character < 128 &&
          (std::isalnum(character) ||
            std::string("-._~").find(static_cast<char>(character)) != std::string::npos);
      });
}

//------------------------------------------------------------------------------
bool AreEqualTokens(const std::string& given, const std::string& expected)
{
  if (expected.empty())
  {
    return false;
  }
  unsigned int difference = given.size() == expected.size() ? 0u : 1u;
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    difference |= static_cast<unsigned char>(given[i]) ^
      static_cast<unsigned char>(expected[i % expected.size()]);
  }
  return difference == 0;
}
}
