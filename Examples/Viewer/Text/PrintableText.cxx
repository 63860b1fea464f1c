// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Text/PrintableText.h"

#include <cstdint>
#include <cstdio>

namespace
{
struct Character
{
  std::uint32_t Code = 0;
  std::size_t Length = 0; // in bytes; 0 for invalid UTF-8
};

Character Decode(const std::string& text, std::size_t place)
{
  const auto byte = [&](std::size_t i)
  { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned int first = byte(place);
  if (first < 0x80)
  {
    return { first, 1 };
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4)
  {
    return {};
  }
  std::uint32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(place + i) & 0xC0U) != 0x80)
    {
      return {};
    }
    code = code << 6 | (byte(place + i) & 0x3FU);
  }
  const std::uint32_t lowest = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
  const bool isSurrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < lowest || code > 0x10FFFF || isSurrogate ? Character() : Character{ code, length };
}

bool IsPrintable(std::uint32_t code)
{
  const bool isControl = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool isSeparator = code == 0x2028 || code == 0x2029;
  const bool isDirection = code == 0x200E || code == 0x200F || code == 0x061C ||
    (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return !isControl && !isSeparator && !isDirection;
}

std::string Escape(std::uint32_t code)
{
  switch (code)
  {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      break;
  }
  char text[12];
  std::snprintf(text, sizeof(text), code < 0x100 ? "\\x%02x" : "\\u%04x", code);
  return text;
}
}

//------------------------------------------------------------------------------
std::string ToPrintable(const std::string& text)
{
  std::string printable;
  for (std::size_t place = 0; place < text.size();)
  {
    const Character character = Decode(text, place);
    if (character.Length == 0)
    {
      printable += Escape(static_cast<unsigned char>(text[place++]));
      continue;
    }
    printable +=
      IsPrintable(character.Code) ? text.substr(place, character.Length) : Escape(character.Code);
    place += character.Length;
  }
  return printable;
}
