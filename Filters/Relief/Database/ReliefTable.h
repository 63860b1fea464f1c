// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefTable
 * @brief   the table of a database of reliefs, as it is read
 *
 * Private to the module's own sources.
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
  /// Read the table in the folder of a database, which is named by the folder or the table.
  explicit ReliefTable(const std::string& fileName);

  const std::string& GetFileName() const { return this->FileName; }
  /// Why there is no table, a sentence that begins with its name; or "".
  const std::string& GetError() const { return this->Error; }

  std::size_t GetNumberOfRows() const { return this->Rows.size(); }
  int GetLine(std::size_t row) const { return this->Rows[row].Line; }
  /// The name of a row's relief, or "".
  std::string GetName(std::size_t row) const;
  /// The path of the .vti file of a row. If it has none, the fault says why.
  std::string FindFile(std::size_t row, std::string& error) const;

  /// The times of the rows, each once and sorted; none if no column has times.
  std::vector<double> GetTimes() const;
  /// Whether a row is of this time, or of all.
  bool IsOfTime(std::size_t row, double time) const;

private:
  void Read();
  std::string GetField(std::size_t row, std::size_t column) const;
  std::vector<std::optional<double>> FindTimes() const;

  std::string FileName;
  std::string Error;
  std::vector<std::string> Names;
  std::vector<CSVRow> Rows;
  std::vector<std::optional<double>> Times; // of the rows, or empty
};
}

#endif
