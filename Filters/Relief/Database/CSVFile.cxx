// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Database/CSVFile.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace relevo
{
namespace
{
class Parser
{
public:
  explicit Parser(const std::string& text)
    : Text(text)
    , Place(text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0) // skips a byte order mark
  {
  }

  std::vector<CSVRow> Parse(std::string& error)
  {
    const std::size_t zero = this->Text.find('\0');
    if (zero != std::string::npos)
    {
      error = "byte " + std::to_string(zero) + " is NUL: it is not a text file.";
      return {};
    }
    std::vector<CSVRow> rows;
    while (this->Place < this->Text.size() && this->Error.empty())
    {
      CSVRow row = this->ParseRow();
      if (row.Fields.size() > 1 || !row.Fields[0].empty())
      {
        rows.push_back(row);
      }
    }
    error = this->Error;
    return rows;
  }

private:
  CSVRow ParseRow()
  {
    CSVRow row;
    row.Line = this->Line;
    while (true)
    {
      row.Fields.push_back(this->ParseField());
      if (this->Place >= this->Text.size() || this->Text[this->Place++] != ',')
      {
        ++this->Line;
        return row;
      }
    }
  }

  // Parses up to the next comma or line end.
  std::string ParseField()
  {
    std::string field;
    bool isQuoted = false;
    int quoteLine = 0;
    for (; this->Place < this->Text.size(); ++this->Place)
    {
      const char c = this->Text[this->Place];
      const char next = this->Place + 1 < this->Text.size() ? this->Text[this->Place + 1] : '\n';
      if (c == '"' && isQuoted && next == '"')
      {
        field += c;
        ++this->Place;
      }
      else if (c == '"')
      {
        isQuoted = !isQuoted;
        quoteLine = this->Line;
      }
      else if (!isQuoted && (c == ',' || c == '\n' || (c == '\r' && next != '\n')))
      {
        break;
      }
      else if (isQuoted || c != '\r')
      {
        this->Line += c == '\n' || (c == '\r' && next != '\n') ? 1 : 0;
        field += c;
      }
    }
    if (isQuoted)
    {
      this->Error = "line " + std::to_string(quoteLine) + ": the quotation mark is not closed.";
    }
    return field;
  }

  const std::string& Text;
  std::size_t Place;
  int Line = 1;
  std::string Error;
};
}

std::vector<CSVRow> ParseCSV(const std::string& text, std::string& error)
{
  return Parser(text).Parse(error);
}

std::string FormatCSV(const std::vector<std::string>& fields)
{
  std::string row;
  for (const std::string& field : fields)
  {
    row += &field == &fields.front() ? "" : ",";
    if (field.find_first_of(",\"\r\n") == std::string::npos)
    {
      row += field;
      continue;
    }
    row += '"';
    for (char c : field)
    {
      row += c == '"' ? "\"\"" : std::string(1, c);
    }
    row += '"';
  }
  return row + "\n";
}

std::string FormatNumber(double number)
{
  if (std::isnan(number))
  {
    return "nan";
  }
  std::string text;
  for (int digits : { 6, 9, 15, 17 })
  {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << number;
    text = out.str();
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    double back = 0.0;
    in >> back;
    if (back == number)
    {
      break;
    }
  }
  return text;
}
}
