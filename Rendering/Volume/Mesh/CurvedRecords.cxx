// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CurvedRecords.h"

#include "vtkCellType.h"

#include <algorithm>

namespace relevo
{
const std::vector<int>& GetRecord(const CellShape* shape, bool isMirrored)
{
  static const std::vector<int> hexahedron[2] = { { 0, 1, 2, 3, 4, 5, 6, 7 },
    { 4, 5, 6, 7, 0, 1, 2, 3 } };
  static const std::vector<int> wedge[2] = { { 0, 1, 2, 2, 3, 4, 5, 5 },
    { 3, 4, 5, 5, 0, 1, 2, 2 } };
  static const std::vector<int> pyramid[2] = { { 0, 1, 2, 3, 4, 4, 4, 4 },
    { 0, 3, 2, 1, 4, 4, 4, 4 } };
  static const std::vector<int> tetrahedron[2] = { { 0, 1, 2, 2, 3, 3, 3, 3 },
    { 0, 2, 1, 1, 3, 3, 3, 3 } };
  static const std::vector<int> quadratic[2] = { { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 },
    { 1, 0, 2, 3, 4, 6, 5, 8, 7, 9 } };
  switch (shape ? shape->NumberOfCorners : 4)
  {
    case 4:
      return tetrahedron[isMirrored];
    case 5:
      return pyramid[isMirrored];
    case 6:
      return wedge[isMirrored];
    case 8:
      return hexahedron[isMirrored];
    default:
      return quadratic[isMirrored];
  }
}

const std::vector<std::array<int, 4>>& GetRecordFaces(bool isQuadratic)
{
  const auto find = [](int type)
  {
    const CellShape& shape = *FindCellShape(type);
    std::vector<std::array<int, 4>> faces = shape.Faces;
    for (const auto& face : shape.QuadraticFaces)
    {
      faces.push_back({ { face[0], face[1], face[2], face[2] } });
    }
    return faces;
  };
  static const std::vector<std::array<int, 4>> faces[2] = { find(VTK_HEXAHEDRON),
    find(VTK_QUADRATIC_TETRA) };
  return faces[isQuadratic];
}

// windHexahedron() uses the same order.
std::array<int, 2> GetRecordEdge(int edge)
{
  const int i = edge % 4;
  const int next = (i + 1) % 4;
  return edge < 4 ? std::array<int, 2>{ { i, next } }
    : edge < 8    ? std::array<int, 2>{ { i + 4, next + 4 } }
                  : std::array<int, 2>{ { i, i + 4 } };
}

bool IsFace(std::array<int, 4> face)
{
  std::sort(face.begin(), face.end());
  const auto corners = std::unique(face.begin(), face.end()) - face.begin();
  return corners - (face[0] < 0 ? 1 : 0) >= 3;
}
}
