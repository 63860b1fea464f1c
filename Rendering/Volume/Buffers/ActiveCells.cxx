// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ActiveCells.h"

#include "Passes/ScreenPass.h"
#include "View/RayView.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPixelBufferObject.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <numeric>

namespace relevo
{
namespace
{
constexpr size_t CellsPerRow = 4096;
constexpr size_t MaximumFacesPerCell = 6;
constexpr size_t NumberOfBuckets = 1024; // of depths
}

bool ActiveCells::FindRanges(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, size_t numberOfCells)
{
  this->NumberOfCells = numberOfCells;
  const size_t rows = (numberOfCells + CellsPerRow - 1) / CellsPerRow;
  this->RangesSize = static_cast<vtkTypeInt64>(rows * CellsPerRow * 2 * sizeof(float));
  return this->Draw(window, program, this->Ranges, { 2, VTK_FLOAT });
}

// A pixel for each cell.
bool ActiveCells::Draw(vtkOpenGLRenderWindow* window, vtkShaderProgram* program,
  RenderTarget& target, const RenderTarget::Format& format)
{
  const size_t rows = (this->NumberOfCells + CellsPerRow - 1) / CellsPerRow;
  if (rows > CellsPerRow || !target.Begin(window, CellsPerRow, static_cast<int>(rows), { format }))
  {
    return false;
  }
  program->SetUniformi("cellsPerRow", static_cast<int>(CellsPerRow));
  program->SetUniformi("numberOfCells", static_cast<int>(this->NumberOfCells));
  target.Draw(BlendOperation::Add, &ScreenPass::DrawTriangle);
  target.End();
  return true;
}

bool ActiveCells::Mark(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  RenderTarget target;
  this->Ranges.Activate(program, "cellRanges");
  const bool isDrawn = this->Draw(window, program, target, { 4, VTK_UNSIGNED_CHAR });
  this->Ranges.Deactivate();
  if (!isDrawn)
  {
    return false;
  }
  vtkTextureObject* marks = target.GetTexture();
  unsigned int size[2] = { marks->GetWidth(), marks->GetHeight() };
  std::vector<std::array<unsigned char, 4>> texels(static_cast<size_t>(size[0]) * size[1]);
  vtkIdType increments[2] = { 0, 0 };
  vtkSmartPointer<vtkPixelBufferObject> pixels;
  pixels.TakeReference(marks->Download());
  pixels->Download2D(VTK_UNSIGNED_CHAR, texels.data(), size, 4, increments);
  target.ReleaseGraphicsResources(window);
  std::vector<std::uint32_t> cells(this->NumberOfCells / 32 + 1);
  this->MarkedFaces.clear();
  this->Sorted = dmat4(0.0);
  this->NumberOfActiveCells = 0;
  for (size_t cell = 0; cell < this->NumberOfCells; ++cell)
  {
    const std::array<unsigned char, 4>& texel = texels[cell];
    if (texel[0] == 0)
    {
      continue;
    }
    ++this->NumberOfActiveCells;
    cells[cell / 32] |= std::uint32_t(1) << cell % 32;
    for (size_t face = 0; face < MaximumFacesPerCell; ++face)
    {
      if ((texel[0] >> face & 1) != 0)
      {
        this->MarkedFaces.push_back(
          { static_cast<std::uint32_t>(8 * cell + face), { { texel[1], texel[2], texel[3] } } });
      }
    }
  }
  return this->Cells.Upload(window, cells);
}

bool ActiveCells::Sort(vtkOpenGLRenderWindow* window, const RayView& view, const dvec3& half)
{
  if (view.GetMeshToClip() == this->Sorted)
  {
    return true;
  }
  this->Sorted = view.GetMeshToClip();
  const double scale = view.GetDepthScale(half);
  std::vector<std::uint32_t> buckets;
  buckets.reserve(this->MarkedFaces.size());
  std::array<size_t, NumberOfBuckets + 1> begins = {};
  for (const MarkedFace& marked : this->MarkedFaces)
  {
    const auto& at = marked.Nearby;
    const dvec3 point = dvec3(at[0], at[1], at[2]) * (2.0 / 255.0) - dvec3(1.0);
    const double share = 0.5 + 0.5 * scale * view.GetDepth(point);
    const double bucket = std::clamp(share * NumberOfBuckets, 0.0, NumberOfBuckets - 1.0);
    buckets.push_back(static_cast<std::uint32_t>(bucket));
    ++begins[buckets.back() + 1];
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<std::uint32_t> faces(this->MarkedFaces.size());
  for (size_t i = 0; i < faces.size(); ++i)
  {
    faces[begins[buckets[i]]++] = this->MarkedFaces[i].Face;
  }
  return this->Faces.Upload(window, faces);
}

void ActiveCells::Activate(vtkShaderProgram* program)
{
  this->Cells.Activate(program, "activeCells");
  this->Faces.Activate(program, "startFaces");
}

void ActiveCells::Deactivate()
{
  this->Cells.Deactivate();
  this->Faces.Deactivate();
}

void ActiveCells::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Ranges.ReleaseGraphicsResources(window);
  this->RangesSize = 0;
  this->Cells.ReleaseGraphicsResources(window);
  this->Faces.ReleaseGraphicsResources(window);
  this->MarkedFaces.clear();
  this->Sorted = dmat4(0.0);
}
}
