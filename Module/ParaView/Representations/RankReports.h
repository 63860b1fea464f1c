// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RankReports
 * @brief   errors and warnings of ranks, which the root reports once
 *
 * Private to the module.
 */
#ifndef RankReports_h
#define RankReports_h

#include "RankExchange.h"

#include <functional>
#include <string>
#include <vector>

namespace relevo
{
struct RankReport
{
  bool IsError;
  std::string Text;

  bool operator==(const RankReport& other) const
  {
    return this->IsError == other.IsError && this->Text == other.Text;
  }
};

class RankReports
{
public:
  void Add(bool isError, const std::string& text) { this->Own.push_back({ isError, text }); }

  /// Return the reports of all ranks at the root, and remove those of this rank. Equal texts are
  /// one report. It begins with the ranks, unless all have it. Collective.
  std::vector<RankReport> Gather(const RankExchange& ranks);

private:
  std::vector<RankReport> Own;
};
}

#endif
