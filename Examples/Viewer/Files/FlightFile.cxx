// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FlightFile.h"

#include "Files/ViewerFile.h"
#include "Text/ViewerMessages.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
struct Column
{
  const char* Name;
  double Lowest;
  double Highest;
};

const std::array<Column, 5> Columns = { { { "longitude", -180.0, 360.0 },
  { "latitude", -90.0, 90.0 }, { "height", -1e9, 1e9 }, { "heading", -360.0, 360.0 },
  { "pitch", -90.0, 90.0 } } };

const char* const FlightHeader = "longitude,latitude,height,heading,pitch";

std::string Trim(const std::string& text)
{
  const char* const blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string> SplitLine(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line + ",");
  for (std::string cell; std::getline(stream, cell, ',');)
  {
    cells.push_back(Trim(cell));
  }
  return cells;
}

std::string JoinCells(const std::vector<std::string>& cells)
{
  std::string text;
  for (const std::string& cell : cells)
  {
    text += (text.empty() ? "" : ",") + cell;
  }
  return text;
}

// `place` is the start of messages: file and line.
FlightPosition ReadPosition(const std::string& line, const std::string& place)
{
  const std::vector<std::string> cells = SplitLine(line);
  if (cells.size() != Columns.size())
  {
    throw ViewerError(place + ": there are " + std::to_string(cells.size()) +
      " columns instead of 5: " + FlightHeader);
  }
  std::array<double, 5> values;
  for (std::size_t i = 0; i < Columns.size(); ++i)
  {
    const Column& column = Columns[i];
    char* end = nullptr;
    values[i] = std::strtod(cells[i].c_str(), &end);
    const bool isNumber = !cells[i].empty() && *end == '\0' && std::isfinite(values[i]);
    if (!isNumber || values[i] < column.Lowest || values[i] > column.Highest)
    {
      std::ostringstream text;
      text << place << ", column " << i + 1 << " (" << column.Name << "): '" << cells[i]
           << "' is not a number";
      if (isNumber)
      {
        text << " from " << column.Lowest << " to " << column.Highest;
      }
      throw ViewerError(text.str());
    }
  }
  return { values[0], values[1], values[2], values[3], values[4], 0 };
}
}

//------------------------------------------------------------------------------
std::vector<FlightPosition> ReadFlightFile(const std::string& fileName)
{
  CheckFile(fileName);
  std::vector<FlightPosition> positions;
  std::ifstream file(fileName);
  std::string line;
  bool hasHeader = false;
  for (int number = 1; std::getline(file, line); ++number)
  {
    const std::string byteOrderMark = "\xEF\xBB\xBF";
    if (number == 1 && line.compare(0, byteOrderMark.size(), byteOrderMark) == 0)
    {
      line.erase(0, byteOrderMark.size());
    }
    if (Trim(line).empty())
    {
      continue;
    }
    const std::string place = fileName + ", line " + std::to_string(number);
    if (!hasHeader)
    {
      if (JoinCells(SplitLine(line)) != FlightHeader)
      {
        throw ViewerError(
          place + ": the header must be " + FlightHeader + ", not '" + Trim(line) + "'");
      }
      hasHeader = true;
      continue;
    }
    positions.push_back(ReadPosition(line, place));
    positions.back().Line = number;
  }
  if (positions.empty())
  {
    throw ViewerError(fileName + " has no positions below the header " + FlightHeader);
  }
  return positions;
}
