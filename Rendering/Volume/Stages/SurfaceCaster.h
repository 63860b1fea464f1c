// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceCaster
 * @brief   the stage that draws opaque isosurfaces alone, from the cells that contain them
 *
 * Rays do not walk through the whole mesh. They start at the faces of active cells, and the depth
 * test keeps the nearest surface. Private to the module.
 */
#ifndef SurfaceCaster_h
#define SurfaceCaster_h

#include "Buffers/ActiveCells.h"
#include "Changes/Dependencies.h"
#include "View/QuadBatches.h"

#include <array>
#include <string>

namespace relevo
{
struct VolumeFrame;

class SurfaceCaster
{
public:
  /// Return whether this stage can draw the frame: there are isosurfaces alone, they are opaque and
  /// do not depend on gradients, the whole mesh is in front of the eye, and quadratic tetrahedra
  /// have flat faces. Otherwise rays must walk through the mesh. The active cells are found if they
  /// are out of date.
  bool IsReady(const VolumeFrame& frame);

  /// Draw into the frame's target. Return the error, or "".
  std::string Draw(const VolumeFrame& frame, const std::array<int, 2>& size);

  /// Return the number of cells without isosurfaces; 0 if IsReady() has returned false.
  size_t GetNumberOfSkippedCells() const
  {
    return this->CanDraw ? this->Cells.GetNumberOfSkippedCells() : 0;
  }

  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTypeInt64 GetMemorySize() const { return this->Cells.GetMemorySize(); }

private:
  bool FindRanges(const VolumeFrame& frame);
  bool MarkCells(const VolumeFrame& frame);

  ActiveCells Cells;
  QuadBatches Faces;
  Dependencies Ranged; // of the ranges
  bool HasRanges = false;
  Dependencies Marked; // of the active cells
  bool AreMarked = false;
  bool CanDraw = false; // the last frame
};
}

#endif
