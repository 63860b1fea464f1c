// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   columns of a database of reliefs, according to Cinema's Spec D
 *
 * Private to the module.
 */
#ifndef ReliefColumns_h
#define ReliefColumns_h

#include <string>
#include <utility>
#include <vector>

namespace relevo
{
struct ReliefBlock;

/// The name of the table in the folder of a database.
constexpr const char* DatabaseTable = "data.csv";
/// The prefix of names of columns with files.
constexpr const char* FileColumn = "FILE";

/// Names of columns with the values of a relief, in order.
using ReliefParameters = std::vector<std::pair<std::string, std::string>>;

/**
 * Returns the columns of a relief that are not files: name; projection, 0 or 1; columns and rows;
 * the fraction of texels with a surface; position, the eye or the middle of the relief's plane;
 * viewing direction; up, the direction of texel columns; and each field array of one number or
 * text.
 */
ReliefParameters GetReliefParameters(const ReliefBlock& block);

/// Returns the names of all columns, with files last, followed by a row for each relief.
std::vector<std::vector<std::string>> MakeTable(const std::vector<ReliefParameters>& reliefs);

/// Returns the first column whose name begins with FILE and that has the name of a .vti file, or
/// -1.
int FindReliefFile(const std::vector<std::string>& names, const std::vector<std::string>& row);

/// Returns the folder of a database, given the name of its folder or table.
std::string GetDatabaseFolder(const std::string& fileName);
}

#endif
