// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the columns of a database of reliefs, as Cinema's Spec D has them
 *
 * Private to the module's own sources.
 */
#ifndef ReliefColumns_h
#define ReliefColumns_h

#include <string>
#include <utility>
#include <vector>

namespace relevo
{
struct ReliefBlock;

/// The table of a database, in its folder.
constexpr const char* DatabaseTable = "data.csv";
/// What the names of columns with files begin with.
constexpr const char* FileColumn = "FILE";

/// Names of columns and what a relief has there, in their order.
using ReliefParameters = std::vector<std::pair<std::string, std::string>>;

/**
 * name; projection, 0 or 1; columns and rows; the share of texels with a surface; position, the eye
 * or the middle of the relief's plane; direction, that it looks in, and up, along its columns; and
 * each field array of one number or text. None is of files.
 */
ReliefParameters GetReliefParameters(const ReliefBlock& block);

/// The names of all columns, those of files last, and then a row for each relief.
std::vector<std::vector<std::string>> MakeTable(const std::vector<ReliefParameters>& reliefs);

/// The column of a row whose name begins with FILE and that has the name of a .vti file, or -1.
int FindReliefFile(const std::vector<std::string>& names, const std::vector<std::string>& row);

/// The folder of a database that is named by its folder or its table.
std::string GetDatabaseFolder(const std::string& fileName);
}

#endif
