// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ActiveCells.h"

#include "Passes/ScreenPass.h"
#include "View/RayView.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPixelBufferObject.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <numeric>
#include <tuple> // for sizes of arrays

namespace relevo
{
namespace
{
constexpr size_t CellsPerRow = 4096;
constexpr std::uint32_t MaximumFacesPerCell = 6;
constexpr size_t NumberOfBuckets = 1024; // of depths
constexpr size_t BitsPerWord = 32;

// Draw a pixel for each cell and read the pixels. Return false if there are too many.
template <typename Texel>
bool ReadCells(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, size_t numberOfCells,
  const RenderTarget::Format& format, std::vector<Texel>& texels)
{
  RenderTarget target;
  const size_t rows = (numberOfCells + CellsPerRow - 1) / CellsPerRow;
  if (rows > CellsPerRow || !target.Begin(window, CellsPerRow, static_cast<int>(rows), { format }))
  {
    return false;
  }
  program->SetUniformi("cellsPerRow", static_cast<int>(CellsPerRow));
  program->SetUniformi("numberOfCells", static_cast<int>(numberOfCells));
  target.Draw(BlendOperation::Add, &ScreenPass::DrawTriangle);
  target.End();
  vtkTextureObject* drawn = target.GetTexture();
  unsigned int size[2] = { drawn->GetWidth(), drawn->GetHeight() };
  texels.resize(static_cast<size_t>(size[0]) * size[1]);
  vtkIdType increments[2] = { 0, 0 };
  vtkSmartPointer<vtkPixelBufferObject> pixels;
  pixels.TakeReference(drawn->Download());
  pixels->Download2D(
    format.Type, texels.data(), size, static_cast<int>(std::tuple_size<Texel>::value), increments);
  target.ReleaseGraphicsResources(window);
  texels.resize(numberOfCells);
  return true;
}
}

bool ActiveCells::FindRanges(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, size_t numberOfCells)
{
  this->NumberOfCells = numberOfCells;
  return ReadCells(window, program, numberOfCells, { 2, VTK_FLOAT }, this->Ranges);
}

// Return a bit for each cell.
std::vector<std::uint32_t> ActiveCells::FindActive(
  const std::vector<float>& values, float margin) const
{
  std::vector<std::uint32_t> cells(this->NumberOfCells / BitsPerWord + 1);
  vtkSMPTools::For(0, static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (size_t word = static_cast<size_t>(first); word < static_cast<size_t>(last); ++word)
      {
        const size_t begin = word * BitsPerWord;
        const size_t end = std::min(begin + BitsPerWord, this->NumberOfCells);
        for (size_t cell = begin; cell < end; ++cell)
        {
          const float low = this->Ranges[cell][0] - margin;
          const float high = this->Ranges[cell][1] + margin;
          const bool isActive = std::any_of(values.begin(), values.end(),
            [=](float value) { return value >= low && value <= high; });
          cells[word] |= static_cast<std::uint32_t>(isActive) << (cell - begin);
        }
      }
    });
  return cells;
}

bool ActiveCells::Mark(vtkOpenGLRenderWindow* window, vtkShaderProgram* program,
  const std::vector<float>& values, float margin)
{
  this->MarkedFaces.clear();
  this->Sorted = dmat4(0.0);
  const std::vector<std::uint32_t> cells = this->FindActive(values, margin);
  std::vector<std::uint32_t> list;
  for (size_t word = 0; word < cells.size(); ++word)
  {
    for (size_t bit = 0; bit < BitsPerWord && cells[word] >> bit != 0; ++bit)
    {
      if ((cells[word] >> bit & 1) != 0)
      {
        list.push_back(static_cast<std::uint32_t>(word * BitsPerWord + bit));
      }
    }
  }
  this->NumberOfActiveCells = list.size();
  if (!this->Cells.Upload(window, cells) || !this->List.Upload(window, list))
  {
    return false;
  }
  std::vector<std::array<unsigned char, 4>> texels;
  this->Cells.Activate(program, "activeCells");
  this->List.Activate(program, "listedCells");
  const bool isDrawn =
    list.empty() || ReadCells(window, program, list.size(), { 4, VTK_UNSIGNED_CHAR }, texels);
  this->List.Deactivate();
  this->Cells.Deactivate();
  for (size_t i = 0; i < texels.size(); ++i)
  {
    const std::array<unsigned char, 4>& texel = texels[i];
    for (std::uint32_t face = 0; face < MaximumFacesPerCell; ++face)
    {
      if ((texel[0] >> face & 1) != 0)
      {
        this->MarkedFaces.push_back({ 8 * list[i] + face, { { texel[1], texel[2], texel[3] } } });
      }
    }
  }
  return isDrawn;
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
  this->Ranges = {};
  this->List.ReleaseGraphicsResources(window);
  this->Cells.ReleaseGraphicsResources(window);
  this->Faces.ReleaseGraphicsResources(window);
  this->MarkedFaces.clear();
  this->Sorted = dmat4(0.0);
}
}
