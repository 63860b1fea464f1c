// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ActiveCells
 * @brief   the cells with scalars in some intervals, and the faces where rays enter them
 *
 * The CPU selects the cells by their ranges, and the graphics card marks the faces of these cells
 * only. Private to the module.
 */
#ifndef ActiveCells_h
#define ActiveCells_h

#include "Buffers/BufferTexture.h"

#include <array>
#include <cstdint>
#include <vector>

namespace relevo
{
class ActiveCells
{
public:
  using Interval = std::array<float, 2>; // lowest and highest scalar

  struct Face
  {
    std::uint32_t Number;                // 8 * cell + the index of the face
    std::array<unsigned char, 3> Nearby; // a point, from -1 to 1
  };

  /// Select the cells whose ranges, widened by a margin, meet an interval.
  void Select(
    const std::vector<Interval>& ranges, const std::vector<Interval>& intervals, float margin);

  /// Mark the faces of the selected cells with the program of MakeActiveShader(), whose mesh is
  /// active, and read the marks. Return false if there is not enough memory.
  bool Mark(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);

  /// Upload numbers of marked faces in another order. Return false if they do not fit.
  bool UploadFaces(vtkOpenGLRenderWindow* window, const std::vector<std::uint32_t>& faces)
  {
    return this->Faces.Upload(window, faces);
  }

  /// Activate cells and faces.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  const std::vector<Face>& GetMarkedFaces() const { return this->MarkedFaces; }
  std::vector<std::uint32_t> GetMarkedNumbers() const;
  int GetNumberOfFaces() const { return static_cast<int>(this->MarkedFaces.size()); }
  size_t GetNumberOfActiveCells() const { return this->Active.size(); }
  /// Return the number of the other cells.
  size_t GetNumberOfSkippedCells() const { return this->NumberOfCells - this->Active.size(); }
  vtkTypeInt64 GetMemorySize() const
  {
    return this->Cells.GetMemorySize() + this->List.GetMemorySize() + this->Faces.GetMemorySize();
  }

private:
  BufferTexture Cells; // a bit for each
  BufferTexture List;  // of active cells
  BufferTexture Faces;
  size_t NumberOfCells = 0;
  std::vector<std::uint32_t> Bits;   // of all cells
  std::vector<std::uint32_t> Active; // the selected cells
  std::vector<Face> MarkedFaces;
};
}

#endif
