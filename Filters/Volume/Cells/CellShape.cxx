// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellShape.h"

#include "Mesh/FaceTable.h"
#include "vtkCellType.h"
#include "vtkHexahedron.h"
#include "vtkPyramid.h"
#include "vtkQuadraticTetra.h"
#include "vtkWedge.h"

#include <algorithm>

namespace relevo
{
namespace
{
double GetOutsideCube(const dvec3& p)
{
  const dvec3 outside = max(-p, p - 1.0);
  return std::max({ outside.x, outside.y, outside.z });
}

double GetOutsideWedge(const dvec3& p)
{
  return std::max({ -p.x, -p.y, p.x + p.y - 1.0, -p.z, p.z - 1.0 });
}

double GetOutsideTetrahedron(const dvec3& p)
{
  return std::max({ -p.x, -p.y, -p.z, p.x + p.y + p.z - 1.0 });
}

// Triangles repeat the last corner.
std::vector<std::array<int, 4>> GetFaces(int type)
{
  const FaceTable table = FindFaceTable(type);
  std::vector<std::array<int, 4>> faces(table.Faces, table.Faces + table.NumberOfFaces);
  for (std::array<int, 4>& face : faces)
  {
    face[3] = face[3] < 0 ? face[2] : face[3];
  }
  return faces;
}
}

const CellShape* FindCellShape(int type)
{
  static const CellShape hexahedron = { 8, dvec3(0.5), vtkHexahedron::InterpolationFunctions,
    vtkHexahedron::InterpolationDerivs, GetOutsideCube, GetFaces(VTK_HEXAHEDRON), {}, 1.0 };
  static const CellShape wedge = { 6, dvec3(1.0 / 3.0, 1.0 / 3.0, 0.5),
    vtkWedge::InterpolationFunctions, vtkWedge::InterpolationDerivs, GetOutsideWedge,
    GetFaces(VTK_WEDGE), {}, 0.5 };
  static const CellShape pyramid = { 5, dvec3(0.5, 0.5, 0.2), vtkPyramid::InterpolationFunctions,
    vtkPyramid::InterpolationDerivs, GetOutsideCube, GetFaces(VTK_PYRAMID), {}, 1.0 / 1.92 };
  static const CellShape quadraticTetrahedron = { 10, dvec3(0.25),
    vtkQuadraticTetra::InterpolationFunctions, vtkQuadraticTetra::InterpolationDerivs,
    GetOutsideTetrahedron, {},
    { { { 0, 1, 3, 4, 8, 7 } }, { { 1, 2, 3, 5, 9, 8 } }, { { 2, 0, 3, 6, 7, 9 } },
      { { 0, 2, 1, 6, 5, 4 } } },
    1.0 / 6.0 };
  switch (type)
  {
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
      return &hexahedron;
    case VTK_WEDGE:
      return &wedge;
    case VTK_PYRAMID:
      return &pyramid;
    case VTK_QUADRATIC_TETRA:
      return &quadraticTetrahedron;
    default:
      return nullptr;
  }
}

int GetCorner(int type, int corner)
{
  constexpr std::array<int, 8> voxel = { { 0, 1, 3, 2, 4, 5, 7, 6 } };
  return type == VTK_VOXEL ? voxel[corner] : corner;
}
}
