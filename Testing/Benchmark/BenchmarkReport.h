// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkReport
 * @brief   tables of results: Markdown for each complete table, JSON for all
 */
#ifndef BenchmarkReport_h
#define BenchmarkReport_h

#include <ostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

class BenchmarkTable
{
public:
  /// A number or text. NaN means "not measured": a dash in Markdown, null in JSON.
  using Value = std::variant<double, std::string>;

  struct Column
  {
    std::string Key;     // in JSON
    std::string Heading; // in Markdown
    int Decimals;
  };

  BenchmarkTable(std::string name, std::string title, std::vector<Column> columns);

  /// The row must have one value per column.
  void AddRow(std::vector<Value> row);
  size_t GetNumberOfRows() const { return this->Rows.size(); }
  /// Adds a remark below the table.
  void AddNote(std::string note) { this->Notes.push_back(std::move(note)); }

  void WriteMarkdown(std::ostream& os) const;
  void WriteJson(std::ostream& os) const;

private:
  std::string Name;
  std::string Title;
  std::vector<Column> Columns;
  std::vector<std::vector<Value>> Rows;
  std::vector<std::string> Notes;
};

class BenchmarkReport
{
public:
  /// Adds a fact about the machine or the build.
  void AddFact(const std::string& name, const std::string& value);
  void WriteFacts(std::ostream& os) const;

  /// Stores a complete table and prints it.
  void Add(const BenchmarkTable& table, std::ostream& os);

  void WriteJson(std::ostream& os) const;

private:
  std::vector<std::pair<std::string, std::string>> Facts;
  std::vector<BenchmarkTable> Tables;
};

#endif
