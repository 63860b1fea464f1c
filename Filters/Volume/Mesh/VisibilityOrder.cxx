// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/VisibilityOrder.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace relevo
{
namespace
{
// Relative to the distance of the eye, or radians. Faces seen edge-on hide nothing.
constexpr double SideMargin = 1e-12;

enum : unsigned char
{
  New,
  Begun, // some cells behind it are not in the order yet
  Done
};

// Positive in front of a plane, 0 if the plane is seen edge-on.
double GetHeight(const dvec4& plane, const dvec4& eye)
{
  const double height = dot(plane, eye);
  const double reach = length(dvec3(eye)) + std::abs(plane.w * eye.w);
  return std::abs(height) > SideMargin * reach ? height : 0.0;
}

// Returns a value that increases with the distance from the eye.
double GetDepth(const dvec3& point, const dvec4& eye)
{
  const dvec3 towards = dvec3(eye) - point;
  return eye.w > 0.0 ? dot(towards, towards) : -dot(point, dvec3(eye));
}
}

void VisibilityOrder::Build(const std::vector<dvec3>& points, CellFaces cells)
{
  this->FirstSlots.assign(cells.GetNumberOfCells() + 1, 0);
  this->Mesh = LinkCells(points, std::move(cells));
  for (const CellLinks::Link& link : this->Mesh.Links)
  {
    for (int cell : link.Cells)
    {
      this->FirstSlots[cell + 1]++;
    }
  }
  std::partial_sum(this->FirstSlots.begin(), this->FirstSlots.end(), this->FirstSlots.begin());
  this->Hidden.resize(this->FirstSlots.back());
  this->Slots.clear();
  this->Slots.reserve(this->Mesh.Links.size());
  std::vector<int> next = this->FirstSlots;
  for (const CellLinks::Link& link : this->Mesh.Links)
  {
    this->Slots.push_back({ { next[link.Cells[0]]++, next[link.Cells[1]]++ } });
  }
}

// Tests each face once, so that two cells never hide each other across it.
void VisibilityOrder::FindHidden(const dvec4& eye)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Slots.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const CellLinks::Link& link = this->Mesh.Links[i];
        const double height = GetHeight(link.Plane, eye);
        this->Hidden[this->Slots[i][0]] = height < 0.0 ? link.Cells[1] : -1;
        this->Hidden[this->Slots[i][1]] = height > 0.0 ? link.Cells[0] : -1;
      }
    });
}

// Returns cells with border faces that the eye sees, the farthest first.
std::vector<int> VisibilityOrder::FindStarts(const dvec4& eye) const
{
  std::vector<std::pair<double, int>> depths;
  for (const CellLinks::BorderFace& face : this->Mesh.Border)
  {
    const double depth = GetDepth(face.Center, eye);
    if (GetHeight(face.Plane, eye) > 0.0 && std::isfinite(depth))
    {
      depths.emplace_back(-depth, face.Cell);
    }
  }
  std::sort(depths.begin(), depths.end());
  std::vector<int> starts;
  starts.reserve(depths.size());
  for (const auto& depth : depths)
  {
    starts.push_back(depth.second);
  }
  return starts;
}

// Adds a cell after the cells that it hides.
void VisibilityOrder::Visit(int start)
{
  const auto begin = [this](int cell)
  {
    this->Marks[cell] = Begun;
    this->Stack.emplace_back(cell, this->FirstSlots[cell]);
  };
  if (this->Marks[start] == New)
  {
    begin(start);
  }
  while (!this->Stack.empty())
  {
    const int cell = this->Stack.back().first;
    int& slot = this->Stack.back().second;
    const int end = this->FirstSlots[cell + 1];
    int next = -1;
    while (slot < end && next < 0)
    {
      const int hidden = this->Hidden[slot++];
      if (hidden >= 0)
      {
        this->NumberOfCycles += this->Marks[hidden] == Begun ? 1 : 0;
        next = this->Marks[hidden] == New ? hidden : -1;
      }
    }
    if (next >= 0)
    {
      begin(next);
    }
    else
    {
      this->Marks[cell] = Done;
      this->Order.push_back(cell);
      this->Stack.pop_back();
    }
  }
}

const std::vector<int>& VisibilityOrder::Sort(const dvec4& eye)
{
  // Relative to the origin of the mesh, or normalized.
  dvec4 viewer = eye.w == 0.0 ? eye / length(dvec3(eye)) : eye / eye.w;
  viewer -= viewer.w * dvec4(this->Mesh.Origin, 0.0);

  const int numberOfCells = static_cast<int>(this->FirstSlots.size()) - 1;
  this->FindHidden(viewer);
  this->Marks.assign(numberOfCells, New);
  this->Order.clear();
  this->Order.reserve(numberOfCells);
  this->NumberOfCycles = 0;
  for (int start : this->FindStarts(viewer))
  {
    this->Visit(start);
  }
  // Cells around the eye, and cells without a path from the border.
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    this->Visit(cell);
  }
  return this->Order;
}
}
