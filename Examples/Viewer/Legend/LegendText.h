// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the labels and titles of a legend
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
  std::string Factor;              // common factor of the labels, "" for 1
};

/// Evenly spaced numbers of a range with equal numbers of decimals. Returns one label if the range
/// is a point.
LegendLabels MakeLegendLabels(const double range[2], int number);

/// The ends of a range above 0, and powers of ten between them: all, or every second, third and so
/// on, so that there are at most `most` labels.
LegendLabels MakeLogLegendLabels(const double range[2], int most);

/// The title with its unit, if it is known and the title does not already end with one.
std::string MakeLegendTitle(const std::string& name, const std::string& unit);

/**
 * Lines of a text no wider than a limit, broken between words if possible, otherwise within words.
 * After `most` lines the rest is replaced by an ellipsis.
 */
struct WrappedText
{
  std::string Text; // the lines
  bool IsAtWords;   // no word was broken, and nothing was omitted
};
WrappedText WrapText(const std::string& text, double limit, int most,
  const std::function<double(const std::string&)>& getWidth);

#endif
