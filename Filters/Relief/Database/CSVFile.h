// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reading and writing of comma-separated values according to RFC 4180
 *
 * Private to the module.
 */
#ifndef CSVFile_h
#define CSVFile_h

#include <string>
#include <vector>

namespace relevo
{
struct CSVRow
{
  int Line = 1; ///< line of the text where the row begins
  std::vector<std::string> Fields;
};

/// Parses the rows of a text, without empty lines. Lines end with LF, CR LF or CR. Quoted fields
/// may contain commas, line ends and doubled quotes. `error` is a message with the line, or "".
std::vector<CSVRow> ParseCSV(const std::string& text, std::string& error);

/// Formats a row with its line end, and quotes fields if necessary.
std::string FormatCSV(const std::vector<std::string>& fields);

/// Formats a number so that it is read back exactly, independent of the locale.
std::string FormatNumber(double number);
}

#endif
