// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefTable
 * @brief   reads the table of a database of reliefs
 *
 * Private to the module.
 */
#ifndef ReliefTable_h
#define ReliefTable_h

#include "Database/CSVFile.h"

#include <optional>
#include <string>
#include <vector>

namespace relevo
{
class ReliefTable
{
public:
  /// Reads the table, given the name of its folder or of the table.
  explicit ReliefTable(const std::string& fileName);

  const std::string& GetFileName() const { return this->FileName; }
  /// Returns why the table cannot be read, as a sentence that begins with its name, or "".
  const std::string& GetError() const { return this->Error; }

  std::size_t GetNumberOfRows() const { return this->Rows.size(); }
  int GetLine(std::size_t row) const { return this->Rows[row].Line; }
  /// Returns the name of the relief in a row, or "".
  std::string GetName(std::size_t row) const;
  /// Returns the path of the .vti file in a row. `error` returns why there is none, or "".
  std::string FindFile(std::size_t row, std::string& error) const;

  /// Returns the distinct times of all rows, sorted; empty if no column has times.
  std::vector<double> GetTimes() const;
  /// Whether a row belongs to this time or to all times.
  bool IsOfTime(std::size_t row, double time) const;

private:
  void Read();
  std::string GetField(std::size_t row, std::size_t column) const;
  std::vector<std::optional<double>> FindTimes() const;

  std::string FileName;
  std::string Error;
  std::vector<std::string> Names;
  std::vector<CSVRow> Rows;
  std::vector<std::optional<double>> Times; // one per row, or empty
};
}

#endif
