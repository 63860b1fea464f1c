// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceEdges
 * @brief   the edges of a mesh's triangles, and point tags from levels of edges
 *
 * Kept between evaluations until the mesh's points or polygons change, as view-dependent metrics
 * need them every frame.
 *
 * Not wrapped: for the modules' own sources.
 */
#ifndef vtkSurfaceEdges_h
#define vtkSurfaceEdges_h

#include "vtkFloatArray.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceTriangles.h"

#include <algorithm> // for std::max
#include <vector>    // for members

class vtkPolyData;

namespace relevo
{
struct SurfaceEdge
{
  enum Types : unsigned char
  {
    INNER,   // of exactly two triangles that wind alike
    FLIPPED, // of exactly two triangles that wind against each other
    OPEN     // of one triangle, or of more than two: an edge for every two that follow each other
  };

  /// Its places, the lower first.
  vtkIdType Points[2];
  /// Indices of triangles; -1 for none.
  vtkIdType Triangles[2];
  Types Type;
};

class SurfaceEdges
{
public:
  /// Follow the mesh.
  void Update(vtkPolyData* mesh);

  const SurfaceTriangles& GetTriangles() const { return this->Triangles; }
  const std::vector<SurfaceEdge>& GetEdges() const { return this->Edges; }

  /// Give every point the largest of f(i), the level of edge i, over the edges at its place,
  /// and 0 where there is none. f is called in parallel.
  template <typename Function>
  void TagPoints(vtkFloatArray* tags, Function&& f) const
  {
    std::vector<float> levels(this->Edges.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(levels.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType edge = begin; edge < end; ++edge)
        {
          levels[edge] = f(edge);
        }
      });
    this->TagPlaces(tags,
      [&](vtkIdType place)
      {
        float level = 0.0f;
        for (vtkIdType i = this->Starts[place]; i < this->Starts[place + 1]; ++i)
        {
          level = std::max(level, levels[this->Uses[i]]);
        }
        return level;
      });
  }

  /// Give every point the level f(place) of its place. f is called in parallel.
  template <typename Function>
  void TagPlaces(vtkFloatArray* tags, Function&& f) const
  {
    const vtkIdType numberOfPoints = this->Triangles.GetNumberOfPoints();
    tags->SetNumberOfComponents(1);
    tags->SetNumberOfTuples(numberOfPoints);
    if (numberOfPoints == 0)
    {
      return;
    }
    float* values = tags->GetPointer(0);
    vtkSMPTools::For(0, numberOfPoints,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType point = begin; point < end; ++point)
        {
          values[point] = this->Triangles.GetPlace(point) == point ? f(point) : 0.0f;
        }
      });
    for (vtkIdType point = 0; point < numberOfPoints; ++point)
    {
      values[point] = values[this->Triangles.GetPlace(point)];
    }
    tags->Modified();
  }

private:
  GeometryStamp Of{};
  SurfaceTriangles Triangles;
  std::vector<SurfaceEdge> Edges;
  std::vector<vtkIdType> Starts; // into Uses, per place
  std::vector<vtkIdType> Uses;   // edges
};
}

#endif
