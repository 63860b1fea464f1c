// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedSurface
 * @brief   a moving surface that is refined to a tolerance where it may intersect another one
 *
 * The items of the tree are the boxes of faces, which move with the surface.
 *
 * Private to the module.
 */
#ifndef CurvedSurface_h
#define CurvedSurface_h

#include "Boxes/BoxTree.h"                 // for members
#include "Intersection/ToleranceSurface.h" // for members
#include "Mesh/Motion.h"                   // for members

#include <string> // for errors

namespace relevo
{
class CurvedSurface
{
public:
  /// See ToleranceSurface::Take().
  bool Take(
    vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, std::string& error, std::string& warning);

  /// Moves the boxes of the faces.
  void Move(const Motion& motion);
  const DoubleBoxTree& GetTree() const { return this->Tree; }

  /// Returns the surface without the motion.
  ToleranceSurface& GetSurface() { return this->Surface; }

private:
  ToleranceSurface Surface;
  Motion Current;
  bool IsMoved = false;
  DoubleBoxTree Tree;
};
}

#endif
