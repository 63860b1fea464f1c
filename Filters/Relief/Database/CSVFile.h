// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   comma separated values, as RFC 4180 has them
 *
 * Private to the module's own sources.
 */
#ifndef CSVFile_h
#define CSVFile_h

#include <string>
#include <vector>

namespace relevo
{
struct CSVRow
{
  int Line = 1; ///< of the text, where the row begins
  std::vector<std::string> Fields;
};

/// The rows of a text, without empty lines. Lines end with LF, CR LF or CR. Fields in quotes may
/// have commas, line ends and doubled quotes. The fault says what is wrong, and in which line, or
/// is "".
std::vector<CSVRow> ParseCSV(const std::string& text, std::string& error);

/// A row with its line end; fields are quoted where they have to be.
std::string FormatCSV(const std::vector<std::string>& fields);

/// A short text that is read as the same number, whatever the locale.
std::string FormatNumber(double number);
}

#endif
