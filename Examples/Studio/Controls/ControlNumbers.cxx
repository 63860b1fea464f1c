// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Controls/ControlNumbers.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace
{
const double Epsilon = 1e-12; // of components across an axis
}

//------------------------------------------------------------------------------
std::vector<double> ParseNumbers(const std::string& text)
{
  std::vector<double> numbers;
  const char* position = text.c_str();
  while (*position != '\0')
  {
    char* end = nullptr;
    numbers.push_back(std::strtod(position, &end));
    if (end == position)
    {
      return {};
    }
    position = *end == ',' ? end + 1 : end;
    if (*end != ',' && *end != '\0')
    {
      return {};
    }
  }
  return numbers;
}

//------------------------------------------------------------------------------
std::string WriteNumbers(const std::vector<double>& numbers)
{
  std::string text;
  for (double number : numbers)
  {
    std::array<char, 64> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    text += (text.empty() ? "" : ",") + std::string(digits.data(), end);
  }
  return text;
}

//------------------------------------------------------------------------------
int FindPlaneDirection(const std::vector<double>& plane)
{
  if (plane.size() != 6)
  {
    return 0;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = plane[3 + (axis + 1) % 3];
    const double b = plane[3 + (axis + 2) % 3];
    if (std::abs(a) < Epsilon && std::abs(b) < Epsilon)
    {
      return 1 + 2 * axis + (plane[3 + axis] > 0.0 ? 0 : 1);
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
std::vector<double> TurnPlane(
  const std::vector<double>& plane, const std::array<double, 6>& bounds, int direction)
{
  std::vector<double> turned(6, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    turned[i] = plane.size() == 6 ? plane[i] : 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
  }
  if (direction > 0)
  {
    turned[3 + (direction - 1) / 2] = direction % 2 == 1 ? 1.0 : -1.0;
  }
  return turned;
}
