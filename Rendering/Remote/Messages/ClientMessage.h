// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ClientMessage
 * @brief   a message of a browser: an event of the mouse or the keyboard, or a request
 */
#ifndef ClientMessage_h
#define ClientMessage_h

#include "RelevoRenderingRemoteModule.h" // for export macro

#include <cstddef>
#include <optional>
#include <string>

namespace relevo
{
struct ClientMessage
{
  enum class Type
  {
    Move,    // X Y MODIFIERS
    Press,   // BUTTON X Y MODIFIERS CLICKS
    Release, // BUTTON X Y MODIFIERS
    Wheel,   // NOTCHES X Y MODIFIERS
    Enter,   // X Y MODIFIERS
    Leave,   // X Y MODIFIERS
    KeyDown, // MODIFIERS KEY
    KeyUp,   // MODIFIERS KEY
    Resize,  // WIDTH HEIGHT PERCENT
    Shown,   // the client has shown a picture
    Gone     // the client has disconnected; clients cannot send this
  };
  enum Modifier
  {
    Control = 1,
    Shift = 2,
    Alt = 4
  };
  /// The largest message in bytes.
  static constexpr std::size_t LargestSize = 256;
  static constexpr int LargestWindow = 8192; // pixels along a side

  Type What = Type::Shown;
  int Button = 0; // 0 for left, 1 for middle, 2 for right
  int X = 0;      // pixels from the left
  int Y = 0;      // pixels from the top
  int Modifiers = 0;
  int Clicks = 1;  // 2 for the second click of a double click
  int Notches = 0; // positive to the front
  int Width = 0;
  int Height = 0;
  int Percent = 100; // device pixels per CSS pixel
  std::string Key;   // as in KeyboardEvent.key
};

/**
 * Parses a message: a word, and numbers separated by spaces. Returns nothing if it is malformed or
 * a number is out of range.
 */
RELEVORENDERINGREMOTE_EXPORT std::optional<ClientMessage> ParseMessage(
  const char* data, std::size_t size);
}

#endif
