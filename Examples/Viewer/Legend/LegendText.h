// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the words and numbers of a legend
 */
#ifndef LegendText_h
#define LegendText_h

#include <functional>
#include <string>
#include <vector>

struct LegendLabel
{
  double Value;
  std::string Text;
};

struct LegendLabels
{
  std::vector<LegendLabel> Labels; // from the lowest value to the highest
  std::string Factor;              // of all labels, "" for 1
};

/// Evenly spaced numbers of a range, all with as many decimals; one if the range is a point.
LegendLabels MakeLegendLabels(const double range[2], int number);

/// The title, with its unit where that is known and the title does not end with one.
std::string MakeLegendTitle(const std::string& name, const std::string& unit);

/**
 * Lines of a text that are no wider than a limit, broken between words if possible and in words if
 * not. Of more lines than `most` the rest is left out, with an ellipsis.
 */
struct WrappedText
{
  std::string Text; // lines
  bool IsAtWords;   // no word was broken, and nothing was left out
};
WrappedText WrapText(const std::string& text, double limit, int most,
  const std::function<double(const std::string&)>& getWidth);

#endif
