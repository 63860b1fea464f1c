// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedSurface
 * @brief   the surface that a recipe makes of a mesh, refined where it is wanted
 *
 * Each coarse face has a box that all its refined points are in, so that it can be told where the
 * surface may meet another before any of it is refined. Faces that are wanted are then refined by
 * the recipe's patterns until their triangles are as near to the surface as is asked; the others
 * follow where they share an edge. The recipe's metric does not count.
 *
 * Private to the module's own sources.
 */
#ifndef CurvedSurface_h
#define CurvedSurface_h

#include "Intersection/RefinedSurface.h"
#include "Mesh/BoxTree.h"
#include "Mesh/Motion.h"
#include "Mesh/RefinementMesh.h"
#include "Refined/ToleranceSteps.h"
#include "vtkSmartPointer.h" // for members

#include <memory>  // for members
#include <string>  // for errors
#include <utility> // for std::pair
#include <vector>  // for members

class vtkAdaptiveRefinement;
class vtkPolyData;

namespace relevo
{
class CurvedSurface
{
public:
  CurvedSurface();
  ~CurvedSurface();

  /// Take a mesh and its recipe; what has not changed since the last call is kept. False, with a
  /// sentence to show the user, where it cannot be refined; a warning may be filled either way.
  bool Take(
    vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, std::string& error, std::string& warning);

  /// Move the boxes of faces, which are the items of the tree.
  void Move(const Motion& motion);
  const BoxTree& GetTree() const { return this->Tree; }

  /// Refine those faces, a byte for each, whose deviation is more than the tolerance, a length of
  /// the mesh; see ToleranceSteps::Choose().
  std::pair<vtkIdType, double> Refine(
    const std::vector<unsigned char>& areWanted, double tolerance);

  /// The triangles of all faces, not moved; another object when they have changed. Those over
  /// no-data, and those with a point that is not finite or two that are one, are left out.
  vtkPolyData* GetTriangles() const { return this->Triangles; }
  /// The ids of the cells that they are of.
  const std::vector<vtkIdType>& GetCells() const { return this->Cells; }

private:
  void BuildTriangles();
  void BuildPoints(const std::vector<vtkIdType>& firstPoints, std::vector<double>& points) const;

  struct Sources;
  std::unique_ptr<Sources> Taken; // nullptr where nothing is
  RefinementMesh Mesh;
  RefinedSurface Surface;
  ToleranceSteps Steps;

  Motion Current;
  bool IsMoved = false;
  BoxTree Tree;

  std::vector<unsigned char> EdgeSteps; // of the triangles
  vtkSmartPointer<vtkPolyData> Triangles;
  std::vector<vtkIdType> Cells;
};
}

#endif
