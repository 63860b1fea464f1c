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
#include "Mathematics/RefinementMathematics.h"
#include "Stages/FaceOutlines.h"
#include "View/QuadBatches.h"

#include <array>
#include <string>

namespace relevo
{
class CellRanges;
struct VolumeFrame;

class SurfaceCaster
{
public:
  /// Return whether this stage can draw the frame: there are isosurfaces alone, they are opaque and
  /// do not depend on gradients, the whole mesh is in front of the eye, and no quadratic
  /// tetrahedra are tangled. Otherwise rays must walk through the mesh. The active cells are found
  /// if they are out of date.
  bool IsReady(const VolumeFrame& frame, CellRanges& ranges);

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
  bool MarkCells(const VolumeFrame& frame, const CellRanges& ranges);
  bool SortFaces(const VolumeFrame& frame);

  ActiveCells Cells;
  FaceOutlines Outlines;
  QuadBatches Faces;
  Dependencies Marked; // of the active cells
  bool AreMarked = false;
  dmat4 Sorted = dmat4(0.0); // the view for which faces have been uploaded
  bool CanDraw = false;      // the last frame
};
}

#endif
