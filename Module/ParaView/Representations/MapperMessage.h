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

#include "vtkMultiProcessController.h"

#include <string>
#include <utility>
#include <vector>

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

/// Words of a mapper, and those of ParaView that replace them.
using MapperWords = std::vector<std::pair<const char*, const char*>>;

/// Words about cell arrays, and those of ParaView.
constexpr std::pair<const char*, const char*> CellDataWords = {
  "Convert it with vtkCellDataToPointData", "Convert it with Cell Data to Point Data"
};

/// Words about meshes that are too large for OpenGL, and those of ParaView.
constexpr std::pair<const char*, const char*> TooLargeWords = {
  "; draw it as several blocks of a vtkMultiBlockDataSet", "; use more ranks"
};

/// Return the message in ParaView's words.
inline std::string ReadMapperMessage(const void* text, const MapperWords& words)
{
  std::string message = ReadMapperMessage(text);
  for (const auto& word : words)
  {
    const std::string from = word.first;
    const std::size_t at = message.find(from);
    if (at != std::string::npos)
    {
      message.replace(at, from.size(), word.second);
    }
  }
  return message;
}

/// Return the message of a rank about its own piece. It begins with the rank, except on rank 0.
inline std::string NameOwnRank(const std::string& message)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int rank = controller ? controller->GetLocalProcessId() : 0;
  return rank > 0 ? "Rank " + std::to_string(rank) + ": " + message : message;
}
}

#endif
