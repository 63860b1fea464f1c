// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ActiveCells
 * @brief   the cells that contain isosurfaces, and the faces where rays enter them
 *
 * The graphics card finds the ranges of all cells, which are read back once. For each set of
 * isovalues, the CPU finds the active cells, and the graphics card marks the faces of these cells
 * only. Private to the module.
 */
#ifndef ActiveCells_h
#define ActiveCells_h

#include "Buffers/BufferTexture.h"
#include "Mathematics/RefinementMathematics.h"
#include "Targets/RenderTarget.h"

#include <array>
#include <cstdint>
#include <vector>

namespace relevo
{
class RayView;

class ActiveCells
{
public:
  /// Find the ranges of all cells with the program of MakeRangesShader(), whose mesh is active.
  /// Return false if there are too many cells.
  bool FindRanges(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, size_t numberOfCells);

  /// Find the cells with one of these isovalues in their range, widened by a margin.
  /// Mark their faces with the program of MakeActiveShader(), whose mesh is active, and read the
  /// marks. Return false if there is not enough memory.
  bool Mark(vtkOpenGLRenderWindow* window, vtkShaderProgram* program,
    const std::vector<float>& values, float margin);

  /// Upload the faces from front to back, so that most hidden faces are not shaded. Return false if
  /// they do not fit.
  bool Sort(vtkOpenGLRenderWindow* window, const RayView& view, const dvec3& half);

  /// Activate cells and faces.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  int GetNumberOfFaces() const { return static_cast<int>(this->MarkedFaces.size()); }
  /// Return the number of the other cells.
  size_t GetNumberOfSkippedCells() const { return this->NumberOfCells - this->NumberOfActiveCells; }
  vtkTypeInt64 GetMemorySize() const
  {
    return this->Cells.GetMemorySize() + this->List.GetMemorySize() + this->Faces.GetMemorySize();
  }

private:
  std::vector<std::uint32_t> FindActive(const std::vector<float>& values, float margin) const;

  std::vector<std::array<float, 2>> Ranges; // of all cells
  BufferTexture Cells;                      // a bit for each
  BufferTexture List;                       // of active cells
  BufferTexture Faces;
  size_t NumberOfCells = 0;
  size_t NumberOfActiveCells = 0;
  struct MarkedFace
  {
    std::uint32_t Face;                  // 8 * cell + the index of the face
    std::array<unsigned char, 3> Nearby; // a point, from -1 to 1
  };
  std::vector<MarkedFace> MarkedFaces;
  dmat4 Sorted = dmat4(0.0); // the view for which faces have been uploaded
};
}

#endif
