// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ClosedSurface.h"

#include "Mathematics/DisjointSets.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/RefinementMesh.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
// A side of a face between two merged points.
struct Side
{
  int Low;
  int High;
  int Face;
  bool Forwards; // whether the face runs from the lower point to the higher

  bool operator<(const Side& other) const
  {
    return this->Low != other.Low ? this->Low < other.Low : this->High < other.High;
  }
};

std::vector<Side> GetSortedSides(const RefinementMesh& mesh)
{
  std::vector<Side> sides(3 * mesh.Faces.size());
  for (size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const RefinementFace& face = mesh.Faces[f];
    for (size_t e = 0; e < 3; ++e)
    {
      // If the sorted corners 0 1 2 are in the order of the cell, edges 0 1 and 1 2 are forwards, 0
      // 2 is backwards.
      sides[3 * f + e] = { mesh.GetMergedPoint(face.Corners[EdgeCorners[e][0]]),
        mesh.GetMergedPoint(face.Corners[EdgeCorners[e][1]]), static_cast<int>(f),
        (e < 2) != face.IsTurned() };
    }
  }
  vtkSMPTools::Sort(sides.begin(), sides.end());
  return sides;
}
}

bool IsClosedOutwards(const RefinementMesh& mesh)
{
  const std::vector<Side> sides = GetSortedSides(mesh);
  DisjointSets parts(static_cast<vtkIdType>(mesh.Faces.size()));
  for (size_t i = 0; i < sides.size(); i += 2)
  {
    const bool two = i + 1 < sides.size() && !(sides[i] < sides[i + 1]) &&
      (i + 2 == sides.size() || sides[i] < sides[i + 2]);
    if (!two || sides[i].Forwards == sides[i + 1].Forwards)
    {
      return false;
    }
    parts.Unite(sides[i].Face, sides[i + 1].Face);
  }
  std::vector<double> volumes(mesh.Faces.size(), 0.0);
  for (size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const RefinementFace& face = mesh.Faces[f];
    dvec3 x[3];
    for (int i = 0; i < 3; ++i)
    {
      const float* point = &mesh.Points[3 * static_cast<size_t>(face.Corners[i])];
      x[i] = dvec3(point[0], point[1], point[2]);
    }
    volumes[parts.Find(static_cast<vtkIdType>(f))] +=
      dot(x[0], cross(x[1], x[2])) * (face.IsTurned() ? -1.0 : 1.0);
  }
  for (size_t f = 0; f < volumes.size(); ++f)
  {
    const auto face = static_cast<vtkIdType>(f);
    if (parts.Find(face) == face && !(volumes[f] > 0.0))
    {
      return false;
    }
  }
  return !mesh.Faces.empty();
}
}
