// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Levels/TriangleTags.h"

#include "Mesh/SurfaceEdges.h"
#include "Mesh/SurfaceTriangles.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace relevo
{
void TagPointsByTriangles(const SurfaceTriangles& surface, const float* levels, vtkFloatArray* tags)
{
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(surface.GetNumberOfPoints());
  vtkSMPTools::For(0, surface.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        float level = 0.0f;
        surface.ForEachTriangleIndex(
          surface.GetMergedPoint(point), [&](vtkIdType t) { level = std::max(level, levels[t]); });
        tags->SetValue(point, level);
      }
    });
  tags->Modified();
}

void TagEdgesByTriangles(const SurfaceEdges& edges, const float* levels, vtkFloatArray* tags)
{
  TagEdges(edges, tags,
    [&](int edge)
    {
      float level = 0.0f;
      edges.ForEachSides(edge,
        [&](int i)
        {
          for (int t : edges.GetSides()[i].Triangles)
          {
            level = t < 0 ? level : std::max(level, levels[t]);
          }
        });
      return level;
    });
}
}
