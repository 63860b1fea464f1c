// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ReliefSides.h"

#include "Data/Relief.h"

#include "vtkSMPTools.h"

namespace relevo
{
namespace
{
class Sides
{
public:
  Sides(const Relief& relief, double maximumStretch)
    : TheRelief(relief)
    , Stretch(maximumStretch)
  {
  }

  bool AreJoined(int column, int row, int right, int up) const
  {
    const double first = this->TheRelief.GetTexelHeight(column, row);
    const double second = this->TheRelief.GetTexelHeight(column + right, row + up);
    if (!(first == first && second == second)) // one is NaN
    {
      return false;
    }
    // Depth increases away from the viewer, the height of a perspective towards the viewer.
    const double nearer = this->TheRelief.IsPerspective() ? max(first, second) : min(first, second);
    const auto point = [&](int steps, double height)
    { return this->TheRelief.GetWorldPoint(column + steps * right, row + steps * up, height); };
    const double width = distance(point(0, nearer), point(1, nearer));
    return distance(point(0, first), point(1, second)) <= this->Stretch * width;
  }

private:
  const Relief& TheRelief;
  const double Stretch;
};
}

std::vector<unsigned char> FindReliefSides(const Relief& relief, double maximumStretch)
{
  const int width = relief.GetWidth();
  const int height = relief.GetHeight();
  std::vector<unsigned char> result(relief.GetNumberOfTexels(), 0);
  const Sides sides(relief, maximumStretch);
  const auto at = [&](int column, int row) -> unsigned char&
  { return result[static_cast<size_t>(row) * width + column]; };
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        for (int column = 0; column < width; ++column)
        {
          const bool right = column + 1 < width && sides.AreJoined(column, row, 1, 0);
          const bool upper = row + 1 < height && sides.AreJoined(column, row, 0, 1);
          at(column, row) =
            static_cast<unsigned char>((right ? RightSide : 0) | (upper ? UpperSide : 0));
        }
      }
    });
  for (int row = 0; row + 1 < height; ++row)
  {
    for (int column = 0; column + 1 < width; ++column)
    {
      constexpr int both = RightSide | UpperSide;
      if ((at(column, row) & both) == both && (at(column, row + 1) & RightSide) &&
        (at(column + 1, row) & UpperSide))
      {
        at(column, row) |= Quad;
      }
    }
  }
  return result;
}
}
