// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceTable.h"

#include "vtkCellType.h"

namespace relevo
{
namespace
{
using Face = std::array<int, 4>;
}

FaceTable FindFaceTable(int type)
{
  static const Face tetrahedron[] = { { { 0, 1, 3, -1 } }, { { 1, 2, 3, -1 } }, { { 2, 0, 3, -1 } },
    { { 0, 2, 1, -1 } } };
  static const Face hexahedron[] = { { { 0, 4, 7, 3 } }, { { 1, 2, 6, 5 } }, { { 0, 1, 5, 4 } },
    { { 3, 7, 6, 2 } }, { { 0, 3, 2, 1 } }, { { 4, 5, 6, 7 } } };
  static const Face voxel[] = { { { 0, 4, 6, 2 } }, { { 1, 3, 7, 5 } }, { { 0, 1, 5, 4 } },
    { { 2, 6, 7, 3 } }, { { 0, 2, 3, 1 } }, { { 4, 5, 7, 6 } } };
  static const Face wedge[] = { { { 0, 1, 2, -1 } }, { { 3, 5, 4, -1 } }, { { 0, 3, 4, 1 } },
    { { 1, 4, 5, 2 } }, { { 2, 5, 3, 0 } } };
  static const Face pyramid[] = { { { 0, 3, 2, 1 } }, { { 0, 1, 4, -1 } }, { { 1, 2, 4, -1 } },
    { { 2, 3, 4, -1 } }, { { 3, 0, 4, -1 } } };
  switch (type)
  {
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
      return { tetrahedron, 4 };
    case VTK_HEXAHEDRON:
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
      return { hexahedron, 6 };
    case VTK_VOXEL:
      return { voxel, 6 };
    case VTK_WEDGE:
    case VTK_QUADRATIC_WEDGE:
      return { wedge, 5 };
    case VTK_PYRAMID:
    case VTK_QUADRATIC_PYRAMID:
      return { pyramid, 5 };
    default:
      return { nullptr, 0 };
  }
}
}
