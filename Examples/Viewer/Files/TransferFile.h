// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   transfer functions in text files
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

/// A node on each line, `value red green blue opacity`, by rising values; after # and on empty
/// lines there is none. Throws ViewerError, with the line's number.
std::vector<TransferNode> ReadTransferFile(const std::string& fileName);

#endif
