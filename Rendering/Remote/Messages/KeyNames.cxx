// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages/KeyNames.h"

#include <cctype>
#include <map>

namespace relevo
{
namespace
{
const std::map<std::string, WindowKey>& GetNamedKeys()
{
  static const std::map<std::string, WindowKey> keys = {
    { "Alt", { 0, "Alt_L" } },
    { "AltGraph", { 0, "ISO_Level3_Shift" } },
    { "ArrowDown", { 0, "Down" } },
    { "ArrowLeft", { 0, "Left" } },
    { "ArrowRight", { 0, "Right" } },
    { "ArrowUp", { 0, "Up" } },
    { "Backspace", { 8, "BackSpace" } },
    { "CapsLock", { 0, "Caps_Lock" } },
    { "Control", { 0, "Control_L" } },
    { "Delete", { 127, "Delete" } },
    { "Enter", { 13, "Return" } },
    { "Escape", { 27, "Escape" } },
    { "Meta", { 0, "Super_L" } },
    { "PageDown", { 0, "Next" } },
    { "PageUp", { 0, "Prior" } },
    { "Shift", { 0, "Shift_L" } },
    { "Tab", { 9, "Tab" } },
  };
  return keys;
}

const std::map<char, std::string>& GetPunctuation()
{
  static const std::map<char, std::string> names = { { ' ', "space" }, { '!', "exclam" },
    { '"', "quotedbl" }, { '#', "numbersign" }, { '$', "dollar" }, { '%', "percent" },
    { '&', "ampersand" }, { '\'', "apostrophe" }, { '(', "parenleft" }, { ')', "parenright" },
    { '*', "asterisk" }, { '+', "plus" }, { ',', "comma" }, { '-', "minus" }, { '.', "period" },
    { '/', "slash" }, { ':', "colon" }, { ';', "semicolon" }, { '<', "less" }, { '=', "equal" },
    { '>', "greater" }, { '?', "question" }, { '@', "at" }, { '[', "bracketleft" },
    { '\\', "backslash" }, { ']', "bracketright" }, { '^', "asciicircum" }, { '_', "underscore" },
    { '`', "grave" }, { '{', "braceleft" }, { '|', "bar" }, { '}', "braceright" },
    { '~', "asciitilde" } };
  return names;
}
}

//------------------------------------------------------------------------------
WindowKey FindKey(const std::string& name, bool hasControl)
{
  const auto named = GetNamedKeys().find(name);
  if (named != GetNamedKeys().end())
  {
    return named->second;
  }
  if (name.size() != 1)
  {
    return { 0, name };
  }
  const char character = name[0];
  const auto mark = GetPunctuation().find(character);
  WindowKey key{ character, mark != GetPunctuation().end() ? mark->second : name };
  // X11 and terminals send Ctrl+A as 1.
  if (hasControl && std::isalpha(static_cast<unsigned char>(character)))
  {
    key.Code = static_cast<char>(character & 31);
  }
  return key;
}
}
