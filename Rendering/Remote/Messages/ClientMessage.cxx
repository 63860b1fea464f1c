// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages/ClientMessage.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>
#include <system_error>
#include <vector>

namespace relevo
{
namespace
{
const int LargestPosition = 32767; // a drag can leave the window
const int LargestWheel = 100;
const std::size_t LongestKey = 32;

struct MessageField
{
  int ClientMessage::*Value;
  int Lowest;
  int Highest;
};

struct MessageForm
{
  ClientMessage::Type What;
  std::vector<MessageField> Fields;
  bool HasKey = false;
};

const std::map<std::string_view, MessageForm>& GetMessageForms()
{
  using Message = ClientMessage;
  using Type = Message::Type;
  const MessageField x = { &Message::X, -LargestPosition, LargestPosition };
  const MessageField y = { &Message::Y, -LargestPosition, LargestPosition };
  const MessageField modifiers = { &Message::Modifiers, 0, 7 };
  const MessageField button = { &Message::Button, 0, 2 };
  static const std::map<std::string_view, MessageForm> forms = {
    { "move", { Type::Move, { x, y, modifiers } } },
    { "press", { Type::Press, { button, x, y, modifiers, { &Message::Clicks, 1, 2 } } } },
    { "release", { Type::Release, { button, x, y, modifiers } } },
    { "wheel",
      { Type::Wheel, { { &Message::Notches, -LargestWheel, LargestWheel }, x, y, modifiers } } },
    { "enter", { Type::Enter, { x, y, modifiers } } },
    { "leave", { Type::Leave, { x, y, modifiers } } },
    { "keydown", { Type::KeyDown, { modifiers }, true } },
    { "keyup", { Type::KeyUp, { modifiers }, true } },
    { "resize",
      { Type::Resize,
        { { &Message::Width, 1, Message::LargestWindow },
          { &Message::Height, 1, Message::LargestWindow }, { &Message::Percent, 25, 800 } } } },
    { "shown", { Type::Shown, {} } },
  };
  return forms;
}

// Returns the text up to the next space, and removes both from the rest.
std::string_view TakeWord(std::string_view& rest)
{
  const std::size_t end = rest.find(' ');
  const std::string_view word = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return word;
}

bool ReadField(std::string_view& rest, const MessageField& field, ClientMessage& message)
{
  const std::string_view word = TakeWord(rest);
  int value = 0;
  const std::from_chars_result result =
    std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec != std::errc() || result.ptr != word.data() + word.size() || value < field.Lowest ||
    value > field.Highest)
  {
    return false;
  }
  message.*field.Value = value;
  return true;
}

bool IsControl(char character)
{
  const auto code = static_cast<unsigned char>(character);
  return code < 32 || code == 127;
}
}

//------------------------------------------------------------------------------
std::optional<ClientMessage> ParseMessage(const char* data, std::size_t size)
{
  if (size > ClientMessage::LargestSize)
  {
    return std::nullopt;
  }
  std::string_view rest(data, size);
  // A space at the end would be an empty word, but the key can be a space.
  const std::size_t words =
    size > 0 ? static_cast<std::size_t>(std::count(rest.begin(), rest.end(), ' ')) : 0;
  const auto form = GetMessageForms().find(TakeWord(rest));
  if (form == GetMessageForms().end())
  {
    return std::nullopt;
  }
  const std::vector<MessageField>& fields = form->second.Fields;
  const bool hasKey = form->second.HasKey;
  if (hasKey ? words < fields.size() + 1 : words != fields.size())
  {
    return std::nullopt;
  }
  ClientMessage message;
  message.What = form->second.What;
  for (const MessageField& field : fields)
  {
    if (!ReadField(rest, field, message))
    {
      return std::nullopt;
    }
  }
  if (hasKey)
  {
    if (rest.empty() || rest.size() > LongestKey ||
      std::any_of(rest.begin(), rest.end(), IsControl))
    {
      return std::nullopt;
    }
    message.Key = std::string(rest);
  }
  return message;
}
}
