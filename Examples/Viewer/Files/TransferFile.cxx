// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/TransferFile.h"

#include "Files/ViewerFile.h"
#include "Text/ViewerMessages.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
// Reads the node of a line. Returns an error message, or an empty string.
std::string ReadNode(const std::string& line, TransferNode& node)
{
  std::vector<double> numbers;
  std::istringstream words(line);
  for (std::string word; words >> word;)
  {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0' || !std::isfinite(numbers.back()))
    {
      return "'" + word + "' is not a number";
    }
  }
  if (numbers.size() != 5)
  {
    return "there are " + std::to_string(numbers.size()) +
      " numbers instead of 5: value red green blue opacity";
  }
  for (std::size_t i = 1; i < 5; ++i)
  {
    if (numbers[i] < 0.0 || numbers[i] > 1.0)
    {
      return i < 4 ? "colours must be from 0 to 1" : "opacities must be from 0 to 1";
    }
  }
  node = { numbers[0], { { numbers[1], numbers[2], numbers[3] } }, numbers[4] };
  return "";
}

std::vector<TransferNode> ReadNodes(std::istream& stream, const std::string& source)
{
  std::vector<TransferNode> nodes;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
  {
    line.erase(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos)
    {
      continue;
    }
    TransferNode node;
    std::string error = ReadNode(line, node);
    if (error.empty() && !nodes.empty() && node.Value <= nodes.back().Value)
    {
      error = "its value must be greater than that of the line before";
    }
    if (!error.empty())
    {
      throw ViewerError(source + ", line " + std::to_string(number) + ": " + error);
    }
    nodes.push_back(node);
  }
  if (nodes.empty())
  {
    throw ViewerError(source + " has no lines 'value red green blue opacity'");
  }
  return nodes;
}
}

//------------------------------------------------------------------------------
std::vector<TransferNode> ReadTransferFile(const std::string& fileName)
{
  if (fileName.find(';') != std::string::npos)
  {
    std::string lines = fileName;
    std::replace(lines.begin(), lines.end(), ';', '\n');
    std::istringstream stream(lines);
    return ReadNodes(stream, "--transfer");
  }
  CheckFile(fileName);
  std::ifstream stream(fileName);
  return ReadNodes(stream, fileName);
}
