// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether cells come in the order in which rays cross them, by geometry alone.
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

// Whether these are all 3D cells of a mesh, each once, and no others.
bool IsEachOnce(vtkDataSet* mesh, const std::vector<vtkIdType>& cells);

// Cells that follow each other along rays, and how many of them are in the wrong order.
struct RelevoPairs
{
  vtkIdType All = 0;
  vtkIdType Wrong = 0;
};

// Convex 3D cells with flat faces, as pieces of space between planes.
class RelevoConvexCells
{
public:
  explicit RelevoConvexCells(vtkDataSet* mesh);

  // Random rays through the mesh's bounds. The eye is (x, y, z, 1), or (x, y, z, 0) far away in
  // this direction, in the mesh's coordinates; cells are from back to front.
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

  std::vector<Cell> Cells; // of other dimensions: without planes
  RelevoPoint Low;
  RelevoPoint High;
  double Diagonal;
};

// Looks at a mesh of such cells from several sides, counts and prints. There, vtkMeshVisibilitySort
// returns each cell once, and finds no circles.
RelevoPairs CountPairs(RelevoCheck& check, const std::string& name, vtkUnstructuredGrid* mesh,
  RelevoDice& dice, int numberOfRays);

#endif
