// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/SurfaceCaster.h"

#include "Shaders/VolumePrograms.h"
#include "Stages/CellRanges.h"
#include "Stages/FeatureSelector.h"
#include "Stages/FunctionLoader.h"
#include "Stages/MeshLoader.h"
#include "Stages/VolumeFrame.h"
#include "Targets/RenderTarget.h"
#include "View/OpaqueDepth.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace relevo
{
namespace
{
// Scalars are from 0 to 1. This is more than the rounding errors inside a cell.
constexpr float IsoMargin = 1e-5f;
constexpr size_t NumberOfBuckets = 1024; // of depths

// Return the faces from front to back, so that most hidden faces are not shaded.
std::vector<std::uint32_t> SortByDepth(
  const std::vector<ActiveCells::Face>& all, const RayView& view, double scale)
{
  std::vector<std::uint32_t> buckets;
  buckets.reserve(all.size());
  std::array<size_t, NumberOfBuckets + 1> begins = {};
  for (const ActiveCells::Face& face : all)
  {
    const auto& at = face.Nearby;
    const dvec3 point = dvec3(at[0], at[1], at[2]) * (2.0 / 255.0) - dvec3(1.0);
    const double share = 0.5 + 0.5 * scale * view.GetDepth(point);
    const double bucket = std::clamp(share * NumberOfBuckets, 0.0, NumberOfBuckets - 1.0);
    buckets.push_back(static_cast<std::uint32_t>(bucket));
    ++begins[buckets.back() + 1];
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<std::uint32_t> faces(all.size());
  for (size_t i = 0; i < faces.size(); ++i)
  {
    faces[begins[buckets[i]]++] = all[i].Number;
  }
  return faces;
}
}

bool SurfaceCaster::IsReady(const VolumeFrame& frame, CellRanges& ranges)
{
  const VolumeShaderOptions& options = frame.Features.Options;
  // Rays in tangled quadratic cells depend on where they come from.
  const bool isTangled = options.HasQuadraticCells && frame.Mesh.HasTangledCells;
  this->CanDraw = options.Blending == BlendMode::IsoSurface && !options.HasCellScalars &&
    !isTangled && !options.HasTables && frame.Functions.Surfaces.AreOpaque() &&
    frame.Passes.IsEmpty() && frame.View.IsInFront(frame.Mesh.Layout.HalfSize) &&
    ranges.Update(frame) && this->MarkCells(frame, ranges);
  return this->CanDraw;
}

bool SurfaceCaster::MarkCells(const VolumeFrame& frame, const CellRanges& ranges)
{
  const SurfaceBuffer& surfaces = frame.Functions.Surfaces;
  if (this->Marked.Update(
        Dependencies::On(frame.Mesh.Buffers.GetNumberOfUploads(), frame.Functions.Version)))
  {
    this->Sorted = dmat4(0.0);
    std::vector<ActiveCells::Interval> values;
    for (const float value : surfaces.GetScaledValues())
    {
      values.push_back({ { value, value } });
    }
    this->AreMarked =
      ranges.Mark(frame, values, std::max(IsoMargin, 2.0f * surfaces.GetSame()), this->Cells);
  }
  return this->AreMarked;
}

// Upload the faces in the order of depth.
bool SurfaceCaster::SortFaces(const VolumeFrame& frame)
{
  const dmat4& view = frame.View.GetMeshToClip();
  if (view == this->Sorted)
  {
    return true;
  }
  this->Sorted = view;
  return this->Cells.UploadFaces(frame.Window,
    SortByDepth(this->Cells.GetMarkedFaces(), frame.View,
      frame.View.GetDepthScale(frame.Mesh.Layout.HalfSize)));
}

std::string SurfaceCaster::Draw(const VolumeFrame& frame, const std::array<int, 2>& size)
{
  VolumeShaderOptions options = frame.Features.Options;
  options.HasActiveCells = true;
  const RayView view = frame.GetView({ { 0, 0, size[0], size[1] } });
  if (!this->SortFaces(frame) || !this->Outlines.Find(frame, options, view, this->Cells))
  {
    return "The faces of cells with isosurfaces do not fit into a texture.";
  }
  vtkShaderProgram* program = frame.Programs.Ready(frame.Window, VolumeShader::Nearest, options);
  if (!program)
  {
    return VolumePrograms::Error;
  }
  view.SetUniforms(program);
  frame.Activate(program);
  this->Cells.Activate(program);
  this->Outlines.Activate(program);
  const bool isDrawn = frame.Target.Begin(frame.Window, size[0], size[1], { {} }, true);
  if (isDrawn)
  {
    frame.Target.Draw(
      BlendOperation::Nearest, [this] { this->Faces.Draw(this->Cells.GetNumberOfFaces()); });
    frame.Target.End();
  }
  this->Outlines.Deactivate();
  this->Cells.Deactivate();
  frame.Deactivate();
  return isDrawn ? "" : VolumeFrame::DescribeTooLarge(size);
}

void SurfaceCaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Cells.ReleaseGraphicsResources(window);
  this->Outlines.ReleaseGraphicsResources(window);
  this->Faces.ReleaseGraphicsResources();
  this->Marked.Clear();
  this->Sorted = dmat4(0.0);
}
}
