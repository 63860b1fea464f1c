// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveRows.h"

#include "Curves/CurveFrames.h"
#include "Curves/CurveMesh.h"

#include <unordered_map>

namespace relevo
{
CurveRows::CurveRows(
  const CurveMesh& mesh, const std::vector<int>& segments, int width, const CurveFrames* frames)
  : Segments(segments)
  , Width(width)
  , Places(mesh.GetCurves().size())
{
  if (width == 1)
  {
    this->ShareEnds(mesh);
    return;
  }
  vtkIdType next = 0;
  for (std::size_t c = 0; c < this->Places.size(); ++c)
  {
    Place& place = this->Places[c];
    place.Ends = { next, next + segments[c] * width };
    place.Inner = next + width;
    place.Caps = { -1, -1 };
    place.IsOwn = { true, true };
    next = place.Ends[1] + width;
    if (frames)
    {
      const CurveFrames::Stations& stations = frames->GetStations()[c];
      const std::array<bool, 2> isOpen{ stations.IsStartOpen, stations.IsEndOpen };
      for (int end = 0; end < 2; ++end)
      {
        if (isOpen[end])
        {
          place.Caps[end] = next;
          next += width;
        }
      }
    }
  }
  this->NumberOfPoints = next;
}

void CurveRows::ShareEnds(const CurveMesh& mesh)
{
  std::unordered_map<vtkIdType, vtkIdType> points;
  points.reserve(2 * this->Places.size() + 1);
  vtkIdType next = 0;
  for (std::size_t c = 0; c < this->Places.size(); ++c)
  {
    const CurveMesh::Curve& curve = mesh.GetCurves()[c];
    Place& place = this->Places[c];
    place.Caps = { -1, -1 };
    for (int end = 0; end < 2; ++end)
    {
      const vtkIdType node = mesh.GetNodes()[curve.FirstPoint + end * curve.Degree];
      const auto [point, isNew] = points.insert({ node, next });
      place.Ends[end] = point->second;
      place.IsOwn[end] = isNew;
      next += isNew ? 1 : 0;
    }
    place.Inner = next;
    next += this->Segments[c] - 1;
  }
  this->NumberOfPoints = next;
}
}
