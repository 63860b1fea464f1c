// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/ActiveCells.h"

#include "Buffers/CellPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr std::uint32_t MaximumFacesPerCell = 6;
constexpr size_t BitsPerWord = 32;

// Return a bit for each cell whose range meets an interval.
std::vector<std::uint32_t> FindActive(const std::vector<ActiveCells::Interval>& ranges,
  const std::vector<ActiveCells::Interval>& intervals, float margin)
{
  std::vector<std::uint32_t> cells(ranges.size() / BitsPerWord + 1);
  vtkSMPTools::For(0, static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (size_t word = static_cast<size_t>(first); word < static_cast<size_t>(last); ++word)
      {
        const size_t begin = word * BitsPerWord;
        const size_t end = std::min(begin + BitsPerWord, ranges.size());
        for (size_t cell = begin; cell < end; ++cell)
        {
          const float low = ranges[cell][0] - margin;
          const float high = ranges[cell][1] + margin;
          const bool isActive = std::any_of(intervals.begin(), intervals.end(),
            [=](const ActiveCells::Interval& interval)
            { return interval[1] >= low && interval[0] <= high; });
          cells[word] |= static_cast<std::uint32_t>(isActive) << (cell - begin);
        }
      }
    });
  return cells;
}
}

void ActiveCells::Select(
  const std::vector<Interval>& ranges, const std::vector<Interval>& intervals, float margin)
{
  this->NumberOfCells = ranges.size();
  this->Bits = FindActive(ranges, intervals, margin);
  this->Active.clear();
  this->MarkedFaces.clear();
  for (size_t word = 0; word < this->Bits.size(); ++word)
  {
    for (size_t bit = 0; bit < BitsPerWord && this->Bits[word] >> bit != 0; ++bit)
    {
      if ((this->Bits[word] >> bit & 1) != 0)
      {
        this->Active.push_back(static_cast<std::uint32_t>(word * BitsPerWord + bit));
      }
    }
  }
}

bool ActiveCells::Mark(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  this->MarkedFaces.clear();
  if (!this->Cells.Upload(window, this->Bits) || !this->List.Upload(window, this->Active))
  {
    return false;
  }
  if (this->Active.empty())
  {
    return true;
  }
  CellPass pass;
  this->Cells.Activate(program, "activeCells");
  this->List.Activate(program, "listedCells");
  const bool isDrawn =
    pass.Draw(window, program, this->Active.size(), { { 4, VTK_UNSIGNED_CHAR } });
  this->List.Deactivate();
  this->Cells.Deactivate();
  if (isDrawn)
  {
    const auto texels = pass.Read<std::array<unsigned char, 4>>(VTK_UNSIGNED_CHAR);
    for (size_t i = 0; i < texels.size(); ++i)
    {
      const std::array<unsigned char, 4>& texel = texels[i];
      for (std::uint32_t face = 0; face < MaximumFacesPerCell; ++face)
      {
        if ((texel[0] >> face & 1) != 0)
        {
          this->MarkedFaces.push_back(
            { 8 * this->Active[i] + face, { { texel[1], texel[2], texel[3] } } });
        }
      }
    }
  }
  pass.ReleaseGraphicsResources(window);
  return isDrawn;
}

std::vector<std::uint32_t> ActiveCells::GetMarkedNumbers() const
{
  std::vector<std::uint32_t> numbers(this->MarkedFaces.size());
  std::transform(this->MarkedFaces.begin(), this->MarkedFaces.end(), numbers.begin(),
    [](const Face& face) { return face.Number; });
  return numbers;
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
  this->List.ReleaseGraphicsResources(window);
  this->Cells.ReleaseGraphicsResources(window);
  this->Faces.ReleaseGraphicsResources(window);
  this->Bits.clear();
  this->Active.clear();
  this->MarkedFaces.clear();
  this->NumberOfCells = 0;
}
}
