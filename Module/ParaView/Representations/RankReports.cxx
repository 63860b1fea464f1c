// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankReports.h"

#include <algorithm>
#include <utility>

namespace relevo
{
namespace
{
// A report is a letter and the text up to a zero.
Bytes PackReports(const std::vector<RankReport>& reports)
{
  Bytes bytes;
  for (const RankReport& report : reports)
  {
    bytes.push_back(report.IsError ? 'E' : 'W');
    bytes.insert(bytes.end(), report.Text.begin(), report.Text.end());
    bytes.push_back(0);
  }
  return bytes;
}

std::vector<RankReport> UnpackReports(const Bytes& bytes)
{
  std::vector<RankReport> reports;
  for (auto from = bytes.begin(); from != bytes.end();)
  {
    const auto end = std::find(from, bytes.end(), 0);
    reports.push_back({ *from == 'E', std::string(from + 1, end) });
    from = end + 1;
  }
  return reports;
}

// "Rank 2: " or "Ranks 0, 3: ".
std::string NameRanks(const std::vector<int>& ranks)
{
  std::string names = ranks.size() == 1 ? "Rank " : "Ranks ";
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    names += (i == 0 ? "" : ", ") + std::to_string(ranks[i]);
  }
  return names + ": ";
}
}

std::vector<RankReport> RankReports::Gather(const RankExchange& ranks)
{
  const std::vector<Bytes> messages = ranks.Gather(PackReports(this->Own));
  this->Own.clear();
  std::vector<std::pair<RankReport, std::vector<int>>> found;
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    for (const RankReport& report : UnpackReports(messages[rank]))
    {
      auto same = std::find_if(
        found.begin(), found.end(), [&](const auto& each) { return each.first == report; });
      if (same == found.end())
      {
        same = found.insert(found.end(), { report, {} });
      }
      if (same->second.empty() || same->second.back() != static_cast<int>(rank))
      {
        same->second.push_back(static_cast<int>(rank));
      }
    }
  }
  std::vector<RankReport> reports;
  for (const auto& each : found)
  {
    const bool isOfAll = each.second.size() == messages.size();
    reports.push_back(
      { each.first.IsError, (isOfAll ? "" : NameRanks(each.second)) + each.first.Text });
  }
  return reports;
}
}
