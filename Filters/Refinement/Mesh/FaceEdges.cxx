// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceEdges.h"

#include "Mathematics/CornerOrder.h"
#include "Mesh/RefinementMesh.h"
#include "Mesh/SurfaceEdges.h"
#include "vtkSMPTools.h"

namespace relevo
{
std::vector<int> FindFaceEdges(const RefinementMesh& mesh, const SurfaceEdges& edges)
{
  std::vector<int> faceEdges(3 * mesh.Faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        const int* corners = mesh.Faces[f].Corners;
        for (int e = 0; e < 3; ++e)
        {
          const int a = mesh.GetMergedPoint(corners[EdgeCorners[e][0]]);
          const int b = mesh.GetMergedPoint(corners[EdgeCorners[e][1]]);
          // A degenerate edge has the level of the edges at its point.
          const int other =
            a != b ? b : mesh.GetMergedPoint(corners[3 - EdgeCorners[e][0] - EdgeCorners[e][1]]);
          faceEdges[3 * f + e] = static_cast<int>(edges.FindEdge(a, other));
        }
      }
    });
  return faceEdges;
}
}
