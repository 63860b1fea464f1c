// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Small meshes with whole coordinates, and whether their triangles intersect. Uses separating axes
// in integers, which is another algorithm than the module's.
#ifndef RelevoTrianglePairs_h
#define RelevoTrianglePairs_h

#include "RelevoDice.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <vector>

using RelevoWholePoint = std::array<std::int64_t, 3>;

struct RelevoWholeMesh
{
  std::vector<RelevoWholePoint> Points; // all different
  std::vector<std::array<int, 3>> Triangles;

  // Triangles between random points with coordinates from 0 to side - 1. All have an area.
  RelevoWholeMesh(RelevoDice& dice, int side, int numberOfPoints, int numberOfTriangles);

  vtkSmartPointer<vtkPolyData> NewPolyData() const;
  std::vector<RelevoWholePoint> GetCorners(int triangle) const;
};

// Whether the convex hulls of up to three points each intersect.
bool RelevoMeet(const std::vector<RelevoWholePoint>& a, const std::vector<RelevoWholePoint>& b);

// Whether the interiors of two triangles intersect without being coplanar. They still do after a
// small motion.
bool RelevoCross(const std::vector<RelevoWholePoint>& a, const std::vector<RelevoWholePoint>& b);

// Whether two triangles of a mesh intersect outside the corner or edge that they share.
bool RelevoMeetBeyond(const RelevoWholeMesh& mesh, int first, int second);

#endif
