// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Legend/LegendText.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
const int MaximumDigits = 15; // significant digits of a double
const char* const Ellipsis = "...";

std::string ToText(double value, int decimals)
{
  // Avoids -0 and rounding noise close to zero.
  const double shown = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << shown;
  return text.str();
}

// Whether the values keep their accuracy with fewer decimals.
bool IsExact(const std::vector<double>& values, int decimals, double largest)
{
  const double unit = std::pow(10.0, -decimals);
  return std::all_of(values.begin(), values.end(),
    [=](double value)
    { return std::abs(value - unit * std::round(value / unit)) <= 1e-9 * largest; });
}

// Each word includes the space after it.
std::vector<std::string> SplitIntoWords(const std::string& text)
{
  std::vector<std::string> words(1);
  for (const char sign : text)
  {
    words.back() += sign;
    if (sign == ' ')
    {
      words.emplace_back();
    }
  }
  return words;
}

std::string TrimEnd(const std::string& text)
{
  const std::size_t last = text.find_last_not_of(' ');
  return last == std::string::npos ? "" : text.substr(0, last + 1);
}

// The length of a UTF-8 text without its last character.
std::size_t GetShorterLength(const std::string& text)
{
  std::size_t length = text.size() - 1;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
  {
    --length;
  }
  return length;
}
}

//------------------------------------------------------------------------------
LegendLabels MakeLegendLabels(const double range[2], int number)
{
  const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
  const int exponent = largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
  const bool isPlain = exponent >= -3 && exponent <= 5;
  LegendLabels legend;
  if (!isPlain)
  {
    legend.Factor = "\u00d7 1e" + std::to_string(exponent);
  }
  const double scale = isPlain ? 1.0 : std::pow(10.0, exponent);
  if (!(range[1] > range[0]))
  {
    std::ostringstream text;
    text << std::setprecision(6) << range[0] / scale;
    legend.Labels.push_back({ range[0], text.str() });
    return legend;
  }
  // Labels have three digits, and neighbours differ in at least two of them.
  const double step = (range[1] - range[0]) / (number - 1);
  const int first = isPlain ? exponent : 0;
  int decimals = std::max(2 - first, static_cast<int>(std::ceil(1.0 - std::log10(step / scale))));
  decimals = std::min(std::max(decimals, 0), MaximumDigits - 1 - first);
  std::vector<double> values(number);
  for (int i = 0; i < number; ++i)
  {
    values[i] = (range[0] + i * step) / scale;
  }
  while (decimals > 0 && IsExact(values, decimals - 1, largest / scale))
  {
    --decimals;
  }
  for (double value : values)
  {
    legend.Labels.push_back({ value * scale, ToText(value, decimals) });
  }
  return legend;
}

//------------------------------------------------------------------------------
LegendLabels MakeLogLegendLabels(const double range[2], int most)
{
  const auto label = [](double value)
  {
    std::ostringstream digits;
    digits << std::setprecision(3) << value;
    std::ostringstream text; // 1000 instead of 1e+03
    text << std::stod(digits.str());
    return LegendLabel{ value, text.str() };
  };
  LegendLabels legend;
  legend.Labels.push_back(label(range[0]));
  if (!(range[1] > range[0]))
  {
    return legend;
  }
  const double length = std::log10(range[1] / range[0]);
  // Keeps the labels of the ends free.
  const double margin = length / std::max(most - 1, 1);
  const auto first = static_cast<int>(std::ceil(std::log10(range[0]) + margin - 1e-9));
  const auto last = static_cast<int>(std::floor(std::log10(range[1]) - margin + 1e-9));
  const int step = std::max(static_cast<int>(std::ceil(margin - 1e-9)), 1);
  for (int exponent = first; exponent <= last; exponent += step)
  {
    legend.Labels.push_back(label(std::pow(10.0, exponent)));
  }
  legend.Labels.push_back(label(range[1]));
  return legend;
}

//------------------------------------------------------------------------------
std::string MakeLegendTitle(const std::string& name, const std::string& unit)
{
  const bool hasUnit =
    unit.empty() || (!name.empty() && (name.back() == ']' || name.back() == ')'));
  return hasUnit ? name : name + " [" + unit + "]";
}

//------------------------------------------------------------------------------
WrappedText WrapText(const std::string& text, double limit, int most,
  const std::function<double(const std::string&)>& getWidth)
{
  std::vector<std::string> lines(1);
  bool isAtWords = true;
  for (std::string word : SplitIntoWords(text))
  {
    if (!lines.back().empty() && getWidth(TrimEnd(lines.back() + word)) > limit)
    {
      lines.emplace_back();
    }
    while (lines.back().empty() && getWidth(TrimEnd(word)) > limit)
    {
      std::string part = word;
      while (GetShorterLength(part) > 0 && getWidth(part) > limit)
      {
        part.resize(GetShorterLength(part));
      }
      // Prefers to break after joining characters.
      const std::size_t joint = part.find_last_of("_-/:;,.");
      isAtWords = isAtWords && joint != std::string::npos;
      part.resize(joint == std::string::npos ? part.size() : joint + 1);
      lines.back() = part;
      if (part.size() == word.size())
      {
        word.clear();
        break;
      }
      word.erase(0, part.size());
      lines.emplace_back();
    }
    lines.back() += word;
  }
  if (lines.size() > static_cast<std::size_t>(most))
  {
    isAtWords = false;
    lines.resize(most);
    std::string& last = lines.back();
    while (!last.empty() && getWidth(last + Ellipsis) > limit)
    {
      last.resize(GetShorterLength(last));
    }
    last = TrimEnd(last) + Ellipsis;
  }
  WrappedText wrapped;
  for (const std::string& line : lines)
  {
    wrapped.Text += (wrapped.Text.empty() ? "" : "\n") + TrimEnd(line);
  }
  wrapped.IsAtWords = isAtWords;
  return wrapped;
}
