// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VisibleCells
 * @brief   the stage that finds where rays enter the first visible cell, and leave the last one
 *
 * Cells are visible if the opacity function is not 0 throughout their range. Rays walk only between
 * the first and the last of them. Private to the module.
 */
#ifndef VisibleCells_h
#define VisibleCells_h

#include "Buffers/ActiveCells.h"
#include "Changes/Dependencies.h"
#include "Stages/FaceOutlines.h"
#include "Targets/RenderTarget.h"
#include "View/QuadBatches.h"

#include <array>

class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class CellRanges;
struct VolumeFrame;

class VisibleCells
{
public:
  /// Return whether this stage can shorten the rays of the frame: a single function of the values
  /// is integrated exactly, it is 0 in enough cells, and the whole mesh is in front of the eye. The
  /// visible cells are found in the second frame with the same mesh and functions, so that edits
  /// and time steps need not wait.
  bool IsReady(const VolumeFrame& frame, CellRanges& ranges);

  /// Find where the rays through a number of pixels begin and end. Return false if there is not
  /// enough memory.
  bool Find(const VolumeFrame& frame, const std::array<int, 2>& size);

  //@{
  /// Bind the results to a program of rays.
  void Activate(const VolumeFrame& frame, vtkShaderProgram* program);
  void Deactivate();
  //@}

  /// Return the number of transparent cells; 0 if IsReady() has returned false.
  size_t GetNumberOfSkippedCells() const
  {
    return this->CanShorten ? this->Cells.GetNumberOfSkippedCells() : 0;
  }

  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTypeInt64 GetMemorySize() const { return this->Cells.GetMemorySize(); }

private:
  bool MarkCells(const VolumeFrame& frame, CellRanges& ranges);
  bool AreWorthwhile() const;
  bool DrawFaces(const VolumeFrame& frame, const std::array<int, 2>& size, bool hasAllFaces);

  ActiveCells Cells;
  FaceOutlines Outlines;
  QuadBatches Faces;
  RenderTarget Begins;
  RenderTarget Ends;
  Dependencies Seen;   // of the last frame
  Dependencies Marked; // of the visible cells
  bool AreMarked = false;
  bool CanShorten = false; // the last frame
};
}

#endif
