// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReport.h"

#include <cassert>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
std::string Quote(const std::string& text)
{
  std::ostringstream os;
  os << '"';
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      os << '\\' << c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      os << "\\u" << std::hex << std::setw(4) << std::setfill('0') << static_cast<int>(c)
         << std::dec;
    }
    else
    {
      os << c;
    }
  }
  os << '"';
  return os.str();
}

std::string FormatNumber(double number, int decimals)
{
  if (!std::isfinite(number))
  {
    return "–";
  }
  std::ostringstream os;
  os << std::fixed << std::setprecision(decimals) << number;
  return os.str();
}

std::string FormatJson(const BenchmarkTable::Value& value)
{
  if (const auto* text = std::get_if<std::string>(&value))
  {
    return Quote(*text);
  }
  const double number = std::get<double>(value);
  if (!std::isfinite(number))
  {
    return "null";
  }
  std::ostringstream os;
  os << std::setprecision(10) << number;
  return os.str();
}
}

BenchmarkTable::BenchmarkTable(std::string name, std::string title, std::vector<Column> columns)
  : Name(std::move(name))
  , Title(std::move(title))
  , Columns(std::move(columns))
{
}

void BenchmarkTable::AddRow(std::vector<Value> row)
{
  assert(row.size() == this->Columns.size());
  this->Rows.push_back(std::move(row));
}

void BenchmarkTable::WriteMarkdown(std::ostream& os) const
{
  os << "## " << this->Title << "\n\n|";
  for (const Column& column : this->Columns)
  {
    os << ' ' << column.Heading << " |";
  }
  os << "\n|";
  for (size_t c = 0; c < this->Columns.size(); ++c)
  {
    const bool isText =
      !this->Rows.empty() && std::holds_alternative<std::string>(this->Rows[0][c]);
    os << (isText ? "---|" : "---:|");
  }
  os << '\n';
  for (const auto& row : this->Rows)
  {
    os << '|';
    for (size_t c = 0; c < row.size(); ++c)
    {
      const auto* text = std::get_if<std::string>(&row[c]);
      os << ' '
         << (text ? *text : FormatNumber(std::get<double>(row[c]), this->Columns[c].Decimals))
         << " |";
    }
    os << '\n';
  }
  os << '\n';
  for (const std::string& note : this->Notes)
  {
    os << note << "\n\n";
  }
}

void BenchmarkTable::WriteJson(std::ostream& os) const
{
  os << "    {\n      \"name\": " << Quote(this->Name)
     << ",\n      \"title\": " << Quote(this->Title) << ",\n      \"rows\": [";
  for (size_t r = 0; r < this->Rows.size(); ++r)
  {
    os << (r == 0 ? "" : ",") << "\n        {";
    for (size_t c = 0; c < this->Columns.size(); ++c)
    {
      os << (c == 0 ? "" : ", ") << Quote(this->Columns[c].Key) << ": "
         << FormatJson(this->Rows[r][c]);
    }
    os << '}';
  }
  os << "\n      ],\n      \"notes\": [";
  for (size_t n = 0; n < this->Notes.size(); ++n)
  {
    os << (n == 0 ? "" : ", ") << Quote(this->Notes[n]);
  }
  os << "]\n    }";
}

void BenchmarkReport::AddFact(const std::string& name, const std::string& value)
{
  this->Facts.emplace_back(name, value);
}

void BenchmarkReport::WriteFacts(std::ostream& os) const
{
  os << "# Relevo benchmark\n\n";
  for (const auto& fact : this->Facts)
  {
    os << "- " << fact.first << ": " << fact.second << '\n';
  }
  os << std::endl;
}

void BenchmarkReport::Add(const BenchmarkTable& table, std::ostream& os)
{
  this->Tables.push_back(table);
  table.WriteMarkdown(os);
  os.flush();
}

void BenchmarkReport::WriteJson(std::ostream& os) const
{
  os << "{\n  \"facts\": {";
  for (size_t f = 0; f < this->Facts.size(); ++f)
  {
    os << (f == 0 ? "" : ",") << "\n    " << Quote(this->Facts[f].first) << ": "
       << Quote(this->Facts[f].second);
  }
  os << "\n  },\n  \"tables\": [\n";
  for (size_t t = 0; t < this->Tables.size(); ++t)
  {
    os << (t == 0 ? "" : ",\n");
    this->Tables[t].WriteJson(os);
  }
  os << "\n  ]\n}\n";
}
