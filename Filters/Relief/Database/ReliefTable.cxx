// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Database/ReliefTable.h"

#include "Database/ReliefColumns.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace relevo
{
namespace
{
// Accepts "time" of Cinema's databases and VTK's "TimeValue".
bool IsTimeColumn(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name == "time" || name == "timevalue";
}

std::optional<double> ReadNumber(const std::string& text)
{
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double number = 0.0;
  const bool isNumber = (in >> number) && (in >> std::ws).eof() && std::isfinite(number);
  return isNumber ? std::optional<double>(number) : std::nullopt;
}

bool LeavesFolder(const fs::path& path)
{
  return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}
}

ReliefTable::ReliefTable(const std::string& fileName)
  : FileName((fs::path(GetDatabaseFolder(fileName)) / DatabaseTable).string())
{
  this->Read();
  if (this->Error.empty())
  {
    this->Times = this->FindTimes();
  }
}

void ReliefTable::Read()
{
  std::error_code unknown;
  std::string text;
  if (fs::is_regular_file(this->FileName, unknown))
  {
    std::ifstream file(this->FileName, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(file), {});
  }
  std::string error;
  this->Rows = ParseCSV(text, error);
  if (!error.empty())
  {
    this->Error = this->FileName + ", " + error;
    this->Rows.clear();
  }
  else if (this->Rows.empty())
  {
    this->Error = "The table of reliefs does not exist or is empty: " + this->FileName;
  }
  else if (this->Rows.size() == 1)
  {
    this->Error = this->FileName + " has a header row, but no rows of reliefs.";
    this->Rows.clear();
  }
  else
  {
    this->Names = this->Rows.front().Fields;
    this->Rows.erase(this->Rows.begin());
  }
}

std::string ReliefTable::GetField(std::size_t row, std::size_t column) const
{
  const std::vector<std::string>& fields = this->Rows[row].Fields;
  return column < fields.size() ? fields[column] : "";
}

std::string ReliefTable::GetName(std::size_t row) const
{
  const auto name = std::find(this->Names.begin(), this->Names.end(), "name");
  return this->GetField(row, static_cast<std::size_t>(name - this->Names.begin()));
}

std::string ReliefTable::FindFile(std::size_t row, std::string& error) const
{
  const std::vector<std::string>& fields = this->Rows[row].Fields;
  if (fields.size() != this->Names.size())
  {
    error = "there are " + std::to_string(fields.size()) + " fields, but " +
      std::to_string(this->Names.size()) + " columns.";
    return "";
  }
  const int column = FindReliefFile(this->Names, fields);
  if (column < 0)
  {
    error = "no FILE column has the name of a .vti file.";
    return "";
  }
  if (LeavesFolder(fields[column]))
  {
    error = fields[column] + " is outside the folder of the database.";
    return "";
  }
  return (fs::path(this->FileName).parent_path() / fields[column]).string();
}

std::vector<std::optional<double>> ReliefTable::FindTimes() const
{
  const auto found = std::find_if(this->Names.begin(), this->Names.end(), IsTimeColumn);
  if (found == this->Names.end())
  {
    return {};
  }
  std::vector<std::optional<double>> times;
  for (std::size_t row = 0; row < this->Rows.size(); ++row)
  {
    const std::string text =
      this->GetField(row, static_cast<std::size_t>(found - this->Names.begin()));
    times.push_back(ReadNumber(text));
    if (!text.empty() && !times.back())
    {
      return {}; // other text, such as names of seasons
    }
  }
  return times;
}

std::vector<double> ReliefTable::GetTimes() const
{
  std::set<double> times;
  for (const std::optional<double>& time : this->Times)
  {
    if (time)
    {
      times.insert(*time);
    }
  }
  return std::vector<double>(times.begin(), times.end());
}

bool ReliefTable::IsOfTime(std::size_t row, double time) const
{
  return this->Times.empty() || !this->Times[row] || *this->Times[row] == time;
}
}
