// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Tiles/PixelCells.h"

#include "View/WorldView.h"
#include "vtkCamera.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace relevo
{
namespace
{
constexpr double PixelMargin = 0.01;
// Relative to world coordinates; more than the rounding errors of projections.
constexpr double ProjectionRounding = 1e-14;

int ClampPixel(double position, int size)
{
  return static_cast<int>(std::clamp(position, -1.0, static_cast<double>(size)));
}
}

PixelCells::PixelCells(const VolumeCells& cells, vtkCamera* camera, int width, int height)
  : Cells(cells)
  , Width(width)
  , Height(height)
  , Columns((width + TileSize - 1) / TileSize)
  , Rows((height + TileSize - 1) / TileSize)
{
  dmat4 toMiddle(1.0);
  toMiddle[3] = dvec4(cells.GetMiddle(), 1.0);
  const dmat4 toView = MakeMatrix(camera->GetViewTransformMatrix());
  const dmat4 toClip = MakeMatrix(
    camera->GetProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0));
  this->ToClip = toClip * (toView * toMiddle);
  dvec3 eye;
  camera->GetPosition(&eye.x);
  const double size = length(eye) + length(cells.GetMiddle()) + cells.GetDiagonal();
  const double nearest =
    camera->GetParallelProjection() ? 1.0 : std::abs(camera->GetClippingRange()[0]);
  const double pixels = 0.5 * std::max(width * std::abs(toClip[0][0]), height * toClip[1][1]);
  const double rounding = ProjectionRounding * size * pixels / nearest;
  this->Margin = PixelMargin + (std::isfinite(rounding) ? rounding : 0.0);
  this->FindPoints();
  this->FillTiles();
}

PixelCells::Tile PixelCells::GetTile(int tile) const
{
  const int left = tile % this->Columns * TileSize;
  const int bottom = tile / this->Columns * TileSize;
  return { left, std::min(left + TileSize, this->Width), bottom,
    std::min(bottom + TileSize, this->Height) };
}

dvec4 PixelCells::Project(const dvec3& point) const
{
  return this->ToClip * dvec4(point, 1.0);
}

dvec2 PixelCells::FindPixel(const dvec4& clip) const
{
  return dvec2((0.5 * clip.x / clip.w + 0.5) * this->Width - 0.5,
    (0.5 * clip.y / clip.w + 0.5) * this->Height - 0.5);
}

void PixelCells::FindPoints()
{
  const std::vector<dvec3>& points = this->Cells.GetPoints();
  this->Points.resize(points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const dvec4 clip = this->Project(points[i]);
        this->Points[i] = { this->FindPixel(clip), clip.z + clip.w };
      }
    });
}

// Calls add(point, projected) for points whose hull contains the cell. `projected` is null if they
// are not points of the mesh.
template <typename Add>
void PixelCells::VisitHull(int cell, const Add& add) const
{
  const VolumeCellList& cells = this->Cells.GetCells();
  const size_t number = static_cast<size_t>(cell);
  const VolumeCells::Cell whole = number < cells.size() ? cells[number] : VolumeCells::Cell();
  dvec3 low;
  dvec3 high;
  if (number >= cells.size())
  {
    this->Cells.GetCurvedParts()[number - cells.size()].Shape.FindBounds(low, high);
  }
  else if (whole.Shape && !whole.Shape->QuadraticFaces.empty())
  {
    this->Cells.GetCurved(whole).FindBounds(low, high);
  }
  else
  {
    for (int i = 0; i < this->Cells.GetNumberOfCorners(whole); ++i)
    {
      const size_t id = static_cast<size_t>(this->Cells.GetCornerId(whole, i));
      add(this->Cells.GetPoints()[id], &this->Points[id]);
    }
    return;
  }
  for (int i = 0; i < 8; ++i)
  {
    add(dvec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z), nullptr);
  }
}

// Lines between points on both sides of the near plane are clipped.
void PixelCells::FindOutline(int cell, CellOutline& outline) const
{
  outline.Clear();
  bool isClipped = false;
  this->VisitHull(cell,
    [&](const dvec3& point, const Point* projected)
    {
      if (projected)
      {
        isClipped = isClipped || !(projected->Depth >= 0.0);
        outline.Add(projected->Pixel);
        return;
      }
      const dvec4 clip = this->Project(point);
      isClipped = isClipped || !(clip.z + clip.w >= 0.0);
      outline.Add(this->FindPixel(clip));
    });
  if (!isClipped)
  {
    outline.Close(this->Margin);
    return;
  }
  std::vector<dvec4> clips;
  this->VisitHull(
    cell, [&](const dvec3& point, const Point*) { clips.push_back(this->Project(point)); });
  outline.Clear();
  for (size_t i = 0; i < clips.size(); ++i)
  {
    const double height = clips[i].z + clips[i].w;
    if (height >= 0.0)
    {
      outline.Add(this->FindPixel(clips[i]));
    }
    for (size_t j = 0; j < i; ++j)
    {
      const double other = clips[j].z + clips[j].w;
      if ((height < 0.0) != (other < 0.0))
      {
        outline.Add(this->FindPixel((height * clips[j] - other * clips[i]) / (height - other)));
      }
    }
  }
  outline.Close(this->Margin);
}

PixelCells::PixelBox PixelCells::FindBox(int cell, CellOutline& outline) const
{
  // Most cells are not clipped and need no hull.
  dvec2 low(std::numeric_limits<double>::max());
  dvec2 high = -low;
  bool isSimple = true;
  this->VisitHull(cell,
    [&](const dvec3&, const Point* projected)
    {
      isSimple = isSimple && projected && projected->Depth >= 0.0;
      low = projected ? min(low, projected->Pixel) : low;
      high = projected ? max(high, projected->Pixel) : high;
    });
  if (!isSimple)
  {
    this->FindOutline(cell, outline);
    low = outline.GetLow();
    high = outline.GetHigh();
  }
  const dvec2 margin(this->Margin);
  low = ceil(low - margin);
  high = floor(high + margin);
  return { { std::max(ClampPixel(low.x, this->Width), 0),
    std::min(ClampPixel(high.x, this->Width), this->Width - 1),
    std::max(ClampPixel(low.y, this->Height), 0),
    std::min(ClampPixel(high.y, this->Height), this->Height - 1) } };
}

void PixelCells::FillTiles()
{
  const size_t count = this->Cells.GetCells().size() + this->Cells.GetCurvedParts().size();
  std::vector<PixelBox> boxes(count);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count),
    [&](vtkIdType first, vtkIdType last)
    {
      CellOutline outline;
      for (vtkIdType i = first; i < last; ++i)
      {
        boxes[i] = this->FindBox(static_cast<int>(i), outline);
      }
    });
  const auto visit = [&](const PixelBox& box, const auto& visitTile)
  {
    if (box[0] > box[1])
    {
      return;
    }
    for (int row = box[2] / TileSize; row <= box[3] / TileSize && box[2] <= box[3]; ++row)
    {
      for (int column = box[0] / TileSize; column <= box[1] / TileSize; ++column)
      {
        visitTile(static_cast<size_t>(row * this->Columns + column));
      }
    }
  };
  this->Firsts.assign(static_cast<size_t>(this->GetNumberOfTiles()) + 1, 0);
  for (const PixelBox& box : boxes)
  {
    visit(box, [&](size_t tile) { ++this->Firsts[tile + 1]; });
  }
  for (size_t tile = 1; tile < this->Firsts.size(); ++tile)
  {
    this->Firsts[tile] += this->Firsts[tile - 1];
  }
  this->Items.resize(this->Firsts.back());
  std::vector<size_t> next = this->Firsts;
  for (size_t i = 0; i < count; ++i)
  {
    visit(boxes[i], [&](size_t tile) { this->Items[next[tile]++] = static_cast<int>(i); });
  }
}

double PixelCells::FindDepth(int cell) const
{
  double sum = 0.0;
  int count = 0;
  this->VisitHull(cell,
    [&](const dvec3& point, const Point* projected)
    {
      const dvec4 clip = projected ? dvec4(0.0) : this->Project(point);
      sum += projected ? projected->Depth : clip.z + clip.w;
      ++count;
    });
  return sum / count;
}

std::vector<int> PixelCells::FindCells(int tile) const
{
  std::vector<std::pair<double, int>> sorted;
  for (size_t i = this->Firsts[tile]; i < this->Firsts[tile + 1]; ++i)
  {
    sorted.emplace_back(this->FindDepth(this->Items[i]), this->Items[i]);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> cells;
  cells.reserve(sorted.size());
  for (const auto& cell : sorted)
  {
    cells.push_back(cell.second);
  }
  return cells;
}
}
