// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks by geometry that cells are in the order in which rays pass through them.
#ifndef RelevoVisibility_h
#define RelevoVisibility_h

#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoVolumes.h"

#include "vtkVisibilitySort.h"

#include <array>
#include <string>
#include <vector>

// All cells of a traversal.
std::vector<vtkIdType> Traverse(vtkVisibilitySort* sort);

// Whether these are exactly the 3D cells of a mesh, each once.
bool IsEachOnce(vtkDataSet* mesh, const std::vector<vtkIdType>& cells);

// Number of pairs of consecutive cells along rays, and how many are in the wrong order.
struct RelevoPairs
{
  vtkIdType All = 0;
  vtkIdType Wrong = 0;
};

// Convex 3D cells with flat faces, represented by planes.
class RelevoConvexCells
{
public:
  explicit RelevoConvexCells(vtkDataSet* mesh);

  // Casts random rays through the mesh's bounds. The eye is (x, y, z, 1), or (x, y, z, 0) at
  // infinity, in the mesh's coordinates. Cells are ordered back to front.
  RelevoPairs Compare(const std::vector<vtkIdType>& cells, const std::array<double, 4>& eye,
    int numberOfRays, RelevoDice& dice) const;

private:
  struct Cell
  {
    std::array<double, 3> Center;
    double Radius;
    std::vector<std::array<double, 4>> Planes; // positive inside
  };
  struct Part
  {
    double Begin;
    double End;
    vtkIdType Cell;
  };
  std::vector<Part> Cross(const RelevoPoint& begin, const RelevoPoint& end) const;

  std::vector<Cell> Cells; // cells of other dimensions have no planes
  RelevoPoint Low;
  RelevoPoint High;
  double Diagonal;
};

// Views a mesh of such cells from several sides, counts and prints. vtkMeshVisibilitySort must
// return each cell once and find no cycles.
RelevoPairs CountPairs(RelevoCheck& check, const std::string& name, vtkUnstructuredGrid* mesh,
  RelevoDice& dice, int numberOfRays);

#endif
