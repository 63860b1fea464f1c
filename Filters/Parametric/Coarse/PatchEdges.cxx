// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Coarse/PatchEdges.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <tuple>

namespace relevo
{
namespace
{
struct BorderCurve
{
  std::array<vtkIdType, 2> Ends;
  std::uint64_t Hash; // of the control points
  std::size_t Patch;
  int Border;
  bool IsReversed;
  bool IsCollapsed;

  auto GetKey() const { return std::tie(this->Ends, this->Hash, this->Patch, this->Border); }
  bool IsSameCurve(const BorderCurve& other) const
  {
    return this->Ends == other.Ends && this->Hash == other.Hash;
  }
};

ControlPoints GetBorderPoints(
  const FacePatch& patch, int border, const ControlPoints& controlPoints)
{
  ControlPoints points;
  for (int point : patch.GetBorder(border))
  {
    points.push_back(controlPoints[patch.FirstPoint + point] + dvec4(0.0)); // replaces -0 by 0
  }
  return points;
}

bool IsBefore(const dvec4& a, const dvec4& b)
{
  return std::tie(a.x, a.y, a.z, a.w) < std::tie(b.x, b.y, b.z, b.w);
}

std::uint64_t GetHash(const ControlPoints& points)
{
  std::uint64_t hash = points.size();
  for (const dvec4& point : points)
  {
    for (int c = 0; c < 4; ++c)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &point[c], sizeof bits);
      // The finalizer of MurmurHash3.
      hash ^= bits + 0x9e3779b97f4a7c15U + (hash << 6) + (hash >> 2);
      hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdU;
      hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53U;
      hash ^= hash >> 33;
    }
  }
  return hash;
}

BorderCurve DescribeBorder(const FacePatch& patch, const ControlPoints& controlPoints,
  const CornerPoints& places, std::size_t index, int border)
{
  const vtkIdType start = places[border];
  const vtkIdType end = places[(border + 1) % patch.GetNumberOfCorners()];
  ControlPoints points = GetBorderPoints(patch, border, controlPoints);
  const ControlPoints reversed(points.rbegin(), points.rend());
  BorderCurve curve{ { std::min(start, end), std::max(start, end) }, 0, index, border, start > end,
    false };
  if (start == end)
  {
    curve.IsCollapsed = std::all_of(points.begin(), points.end(),
      [&](const dvec4& point) { return dvec3(point) == dvec3(points[0]); });
    curve.IsReversed = std::lexicographical_compare(
      reversed.begin(), reversed.end(), points.begin(), points.end(), IsBefore);
  }
  curve.Hash = GetHash(curve.IsReversed ? reversed : points);
  return curve;
}

std::vector<BorderCurve> DescribeBorders(const std::vector<FacePatch>& patches,
  const ControlPoints& controlPoints, const std::vector<CornerPoints>& places)
{
  std::vector<std::size_t> firsts(patches.size());
  std::size_t number = 0;
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    firsts[i] = number;
    number += patches[i].GetNumberOfCorners();
  }
  std::vector<BorderCurve> curves(number);
  vtkSMPTools::For(0, static_cast<vtkIdType>(patches.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType i = first; i < end; ++i)
      {
        for (int border = 0; border < patches[i].GetNumberOfCorners(); ++border)
        {
          curves[firsts[i] + border] =
            DescribeBorder(patches[i], controlPoints, places[i], i, border);
        }
      }
    });
  vtkSMPTools::Sort(curves.begin(), curves.end(),
    [](const BorderCurve& a, const BorderCurve& b) { return a.GetKey() < b.GetKey(); });
  return curves;
}

// Closed edges are split into four pieces. Edges whose ends another edge connects are split into
// two.
void ChoosePieces(std::vector<PatchEdge>& edges, int least)
{
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    PatchEdge& edge = edges[i];
    const bool isClosed = edge.Ends[0] == edge.Ends[1];
    const bool hasTwin = (i > 0 && edges[i - 1].Ends == edge.Ends) ||
      (i + 1 < edges.size() && edges[i + 1].Ends == edge.Ends);
    edge.Pieces = edge.IsCollapsed ? 1 : (isClosed ? 4 : (hasTwin ? 2 : least));
  }
}
}

bool PatchEdges::AreJoined(const std::array<vtkIdType, 2>& ends) const
{
  const auto edge = std::lower_bound(this->Edges.begin(), this->Edges.end(), ends,
    [](const PatchEdge& a, const std::array<vtkIdType, 2>& b) { return a.Ends < b; });
  return edge != this->Edges.end() && edge->Ends == ends;
}

PatchEdges FindPatchEdges(const std::vector<FacePatch>& patches, const ControlPoints& controlPoints,
  const std::vector<CornerPoints>& places, int minimumPieces)
{
  PatchEdges result;
  result.Borders.resize(patches.size());
  const std::vector<BorderCurve> curves = DescribeBorders(patches, controlPoints, places);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const BorderCurve& curve = curves[i];
    if (i == 0 || !curve.IsSameCurve(curves[i - 1]))
    {
      result.Edges.push_back(
        { curve.Ends, curve.IsCollapsed, 1, curve.Patch, curve.Border, curve.IsReversed });
    }
    result.Borders[curve.Patch][curve.Border] = { static_cast<int>(result.Edges.size()) - 1,
      curve.IsReversed };
  }
  ChoosePieces(result.Edges, minimumPieces);
  return result;
}

ControlPoints GetCurve(
  const PatchEdge& edge, const std::vector<FacePatch>& patches, const ControlPoints& controlPoints)
{
  ControlPoints points = GetBorderPoints(patches[edge.Patch], edge.Border, controlPoints);
  if (edge.IsReversed)
  {
    std::reverse(points.begin(), points.end());
  }
  return points;
}
}
