// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the messages of mappers that representations report
 *
 * Private to the module.
 */
#ifndef MapperMessage_h
#define MapperMessage_h

#include <string>

namespace relevo
{
/// Return the message in the text of an event, which begins with the file, class and address.
inline std::string ReadMapperMessage(const void* text)
{
  std::string message = text ? static_cast<const char*>(text) : "";
  const std::size_t begin = message.find("): ");
  message = begin == std::string::npos ? message : message.substr(begin + 3);
  message.erase(message.find_last_not_of(" \n") + 1);
  return message;
}
}

#endif
