// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Small meshes of whole coordinates, and whether their triangles meet, by separating axes in whole
// numbers: another way than that of the module.
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
  std::vector<RelevoWholePoint> Points; // no two the same
  std::vector<std::array<int, 3>> Triangles;

  // Triangles of random points with coordinates from 0 to side - 1; all have an area.
  RelevoWholeMesh(RelevoDice& dice, int side, int numberOfPoints, int numberOfTriangles);

  vtkSmartPointer<vtkPolyData> NewPolyData() const;
  std::vector<RelevoWholePoint> GetCorners(int triangle) const;
};

// Whether the convex hulls of up to three points have a point in common.
bool RelevoMeet(const std::vector<RelevoWholePoint>& a, const std::vector<RelevoWholePoint>& b);

// Whether the insides of two triangles meet, and not in one plane: they still do after any motion
// that is small enough.
bool RelevoCross(const std::vector<RelevoWholePoint>& a, const std::vector<RelevoWholePoint>& b);

// Whether two triangles of a mesh meet beyond the corner or the edge that they share.
bool RelevoMeetBeyond(const RelevoWholeMesh& mesh, int first, int second);

#endif
