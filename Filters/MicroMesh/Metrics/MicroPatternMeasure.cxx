// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MicroPatternMeasure.h"

#include "Mathematics/CornerOrder.h"
#include "Patterns/FacePattern.h"
#include "Patterns/RefinementPattern.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
class PatternOnGrid
{
public:
  PatternOnGrid(const MicroMesh& mesh, const MicroMesh::Face& face, const std::array<int, 3>& order,
    const FacePattern& facePattern)
    : Pattern(*facePattern.Pattern)
    , Order(order)
    , Segments(1 << face.Level)
    , Positions(mesh.GetPositions(face))
  {
    const int number = this->Pattern.GetNumberOfVertices();
    for (int i = 0; i < number; ++i)
    {
      float sorted[3];
      facePattern.GetWeights(i, sorted);
      Vertex vertex{};
      for (int s = 0; s < 3; ++s)
      {
        vertex.Weights[order[s]] = sorted[s];
      }
      vertex.Position = this->GetPosition(vertex.Weights);
      this->Vertices.push_back(vertex);
    }
  }

  FaceDeviations Measure()
  {
    for (std::size_t i = 0; i < this->Pattern.Lines.size(); i += 2)
    {
      this->MeasureLine(
        this->GetVertex(this->Pattern.Lines[i]), this->GetVertex(this->Pattern.Lines[i + 1]));
    }
    for (std::size_t t = 0; t < this->Pattern.Triangles.size(); t += 3)
    {
      this->MeasureTriangle(&this->Pattern.Triangles[t]);
    }
    FaceDeviations deviations;
    for (int e = 0; e < 3; ++e)
    {
      deviations.Edges[e] = static_cast<float>(this->Largest[e]);
    }
    deviations.Inside = static_cast<float>(this->Largest[3]);
    return deviations;
  }

private:
  struct Vertex
  {
    std::array<double, 3> Weights;
    dvec3 Position;
  };

  const Vertex& GetVertex(unsigned int i) const { return this->Vertices[i]; }

  dvec3 GetPosition(const std::array<double, 3>& weights) const
  {
    const GridPlace place = FindGridPlace(this->Segments, weights);
    dvec3 sum(0.0);
    for (int c = 0; c < 3; ++c)
    {
      sum += place.Weights[c] *
        this->Positions[static_cast<std::size_t>(GetGridIndex(this->Segments, place.Corners[c]))];
    }
    return sum;
  }

  // The sorted edge that has both vertices, or 3.
  int FindEdge(const Vertex& a, const Vertex& b) const
  {
    for (int e = 0; e < 3; ++e)
    {
      const int lacking = this->Order[3 - EdgeCorners[e][0] - EdgeCorners[e][1]];
      if (a.Weights[lacking] == 0.0 && b.Weights[lacking] == 0.0)
      {
        return e;
      }
    }
    return 3;
  }

  void MeasureLine(const Vertex& a, const Vertex& b)
  {
    double& largest = this->Largest[this->FindEdge(a, b)];
    const double n = this->Segments;
    for (int c = 0; c < 3; ++c)
    {
      const double from = std::min(a.Weights[c], b.Weights[c]);
      const double to = std::max(a.Weights[c], b.Weights[c]);
      for (double line = std::floor(from * n) + 1.0; line < to * n; line += 1.0)
      {
        const double share = (line / n - a.Weights[c]) / (b.Weights[c] - a.Weights[c]);
        std::array<double, 3> weights{};
        for (int i = 0; i < 3; ++i)
        {
          weights[i] = (1.0 - share) * a.Weights[i] + share * b.Weights[i];
        }
        const dvec3 position = (1.0 - share) * a.Position + share * b.Position;
        largest = std::max(largest, length(position - this->GetPosition(weights)));
      }
    }
  }

  void MeasureTriangle(const unsigned int* corners)
  {
    const Vertex* v[3];
    int low[2] = { this->Segments, this->Segments };
    int high[2] = { 0, 0 };
    for (int i = 0; i < 3; ++i)
    {
      v[i] = &this->GetVertex(corners[i]);
      for (int c = 0; c < 2; ++c)
      {
        const double place = v[i]->Weights[c] * this->Segments;
        low[c] = std::min(low[c], static_cast<int>(std::ceil(place)));
        high[c] = std::max(high[c], static_cast<int>(std::floor(place)));
      }
    }
    const auto cross2 =
      [](const std::array<double, 3>& a, const std::array<double, 3>& b, double x, double y)
    { return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]); };
    const double area = cross2(v[0]->Weights, v[1]->Weights, v[2]->Weights[0], v[2]->Weights[1]);
    if (area == 0.0)
    {
      return;
    }
    for (int i = low[0]; i <= high[0]; ++i)
    {
      for (int j = low[1]; j <= std::min(high[1], this->Segments - i); ++j)
      {
        const double x = double(i) / this->Segments;
        const double y = double(j) / this->Segments;
        dvec3 position(0.0);
        bool isInside = true;
        for (int c = 0; c < 3; ++c)
        {
          const double share =
            cross2(v[(c + 1) % 3]->Weights, v[(c + 2) % 3]->Weights, x, y) / area;
          isInside = isInside && share >= 0.0;
          position += share * v[c]->Position;
        }
        if (isInside)
        {
          const dvec3& there = this->Positions[static_cast<std::size_t>(
            GetGridIndex(this->Segments, { { i, j, this->Segments - i - j } }))];
          this->Largest[3] = std::max(this->Largest[3], length(position - there));
        }
      }
    }
  }

  const RefinementPattern& Pattern;
  std::array<int, 3> Order;
  int Segments;
  std::vector<dvec3> Positions;
  std::vector<Vertex> Vertices;
  double Largest[4] = { 0.0, 0.0, 0.0, 0.0 }; // on the sorted edges and inside
};
}

FaceDeviations MeasureMicroPattern(const MicroMesh& mesh, const MicroMesh::Face& face,
  const std::array<int, 3>& order, const FacePattern& pattern)
{
  return PatternOnGrid(mesh, face, order, pattern).Measure();
}
}
