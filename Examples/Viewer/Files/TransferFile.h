// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads transfer functions from text files
 */
#ifndef TransferFile_h
#define TransferFile_h

#include <array>
#include <string>
#include <vector>

struct TransferNode
{
  double Value;
  std::array<double, 3> Color; // red, green, blue, 0 to 1
  double Opacity;              // 0 to 1
};

/// Reads one node per line, `value red green blue opacity`, with increasing values. Text after #
/// and empty lines are ignored. A name with semicolons is not that of a file, but the lines
/// themselves, separated by semicolons. Throws ViewerError with the line's number.
std::vector<TransferNode> ReadTransferFile(const std::string& fileName);

#endif
