// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MicroMesh.h"

namespace relevo
{
dvec3 MicroMesh::Displace(const Face& face, const dvec3& weights, int sample) const
{
  dvec3 point(0.0);
  dvec3 direction(0.0);
  for (int c = 0; c < 3; ++c)
  {
    const auto corner = static_cast<std::size_t>(face.Corners[c]);
    point += weights[c] * this->Points[corner];
    direction += weights[c] * dvec3(this->Directions[corner]);
  }
  return sample < 0 ? point
                    : point + direction * double(this->Samples[static_cast<std::size_t>(sample)]);
}

int MicroMesh::GetSampleIndex(const Face& face, const GridPoint& point) const
{
  const int n = 1 << face.Level;
  const int e = GetGridEdge(point);
  if (e < 0)
  {
    return face.FirstInner + GetInnerIndex(n, point);
  }
  const Edge& edge = this->Edges[static_cast<std::size_t>(face.Edges[e] >> 1)];
  const int stride = n >> edge.Level;
  const int place = (face.Edges[e] & 1) != 0 ? point[e] : point[(e + 1) % 3];
  return place % stride == 0 ? edge.First + place / stride - 1 : -1;
}

dvec3 MicroMesh::GetPosition(const Face& face, const GridPoint& point) const
{
  const int n = 1 << face.Level;
  for (int c = 0; c < 3; ++c)
  {
    if (point[c] == n)
    {
      return this->Points[static_cast<std::size_t>(face.Corners[c])];
    }
  }
  const dvec3 weights = dvec3(point[0], point[1], point[2]) / double(n);
  const int sample = this->GetSampleIndex(face, point);
  if (sample >= 0)
  {
    return this->Displace(face, weights, sample);
  }
  // Interpolate between two samples of the edge, or its ends.
  const int e = GetGridEdge(point);
  const int next = (e + 1) % 3;
  const int stride = n >> this->Edges[static_cast<std::size_t>(face.Edges[e] >> 1)].Level;
  const int before = point[next] / stride * stride;
  GridPoint ends[2] = {};
  for (int i = 0; i < 2; ++i)
  {
    ends[i][next] = before + i * stride;
    ends[i][e] = n - ends[i][next];
  }
  const double share = double(point[next] - before) / double(stride);
  return (1.0 - share) * this->GetPosition(face, ends[0]) +
    share * this->GetPosition(face, ends[1]);
}

std::vector<dvec3> MicroMesh::GetPositions(const Face& face) const
{
  const int n = 1 << face.Level;
  std::vector<dvec3> positions;
  positions.reserve(static_cast<std::size_t>(GetNumberOfGridPoints(n)));
  ForEachGridPoint(
    n, [&](const GridPoint& point) { positions.push_back(this->GetPosition(face, point)); });
  return positions;
}
}
