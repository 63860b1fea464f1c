// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bezier/PiecePoints.h"

#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr size_t NoEntry = std::numeric_limits<size_t>::max();
}

PiecePoints::PiecePoints(
  PlaceSet& places, const Scalars& same, std::vector<dvec3>& positions, ScalarTable& values)
  : Places(places)
  , Same(same)
  , Positions(positions)
  , Values(values)
{
}

vtkIdType PiecePoints::Search(size_t place, const Scalars& values) const
{
  size_t entry = place < this->Firsts.size() ? this->Firsts[place] : NoEntry;
  while (entry != NoEntry)
  {
    const vtkIdType point = this->Entries[entry].Point;
    const Scalars known = this->Values[point];
    bool isSame = true;
    for (size_t c = 0; c < values.size(); ++c)
    {
      isSame = isSame && std::abs(known[c] - values[c]) <= this->Same[c];
    }
    if (isSame)
    {
      return point;
    }
    entry = this->Entries[entry].Next;
  }
  return -1;
}

void PiecePoints::Append(size_t place, vtkIdType point)
{
  this->Firsts.resize(this->Places.GetNumberOfPlaces(), NoEntry);
  this->Entries.push_back({ point, this->Firsts[place] });
  this->Firsts[place] = this->Entries.size() - 1;
}

void PiecePoints::Reuse(vtkIdType point)
{
  const size_t place = this->Places.Find(this->Positions[point]);
  if (this->Places.GetPosition(place) == this->Positions[point] &&
    this->Search(place, this->Values[point]) < 0)
  {
    this->Append(place, point);
  }
}

vtkIdType PiecePoints::Find(const BezierPoint& point)
{
  const size_t place = this->Places.Find(point.Position);
  const vtkIdType old = this->Search(place, point.Values);
  if (old >= 0)
  {
    return old;
  }
  const vtkIdType added = this->Add({ this->Places.GetPosition(place), point.Values });
  this->Append(place, added);
  return added;
}

vtkIdType PiecePoints::Add(const BezierPoint& point)
{
  this->Positions.push_back(point.Position);
  this->Values.push_back(point.Values);
  return static_cast<vtkIdType>(this->Positions.size()) - 1;
}
}
