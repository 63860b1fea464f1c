// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/VisibleCells.h"

#include "Buffers/VisibleIntervals.h"
#include "Shaders/VolumePrograms.h"
#include "Stages/CellRanges.h"
#include "Stages/FeatureSelector.h"
#include "Stages/FunctionLoader.h"
#include "Stages/MeshLoader.h"
#include "Stages/VolumeFrame.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Scalars are from 0 to 1. This is more than the rounding errors inside a cell.
constexpr float VisibleMargin = 1e-5f;
// Rounding of depths, as a share of the mesh.
constexpr double DepthMargin = 1e-6;
// The passes over faces take longer than they save if fewer cells are transparent, or if there are
// more faces for each cell. A small number of faces takes no time.
constexpr double LeastSkipped = 0.25;
constexpr double MostFaces = 0.25;
constexpr double FewFaces = 1000.0;

bool AreSupported(const VolumeFrame& frame)
{
  const VolumeShaderOptions& options = frame.Features.Options;
  const bool isIntegrated =
    options.Blending == BlendMode::Composite || options.Blending == BlendMode::Additive;
  // Rays in tangled quadratic cells depend on where they come from.
  const bool isTangled = options.HasQuadraticCells && frame.Mesh.HasTangledCells;
  return isIntegrated && options.PreIntegrated == 0 && options.NumberOfCurves == 1 &&
    !options.AreDependent && !options.HasTables && !options.HasSurfaces && !isTangled &&
    options.Segments == SegmentOutput::None && frame.Passes.IsEmpty() &&
    options.FirstComponent == frame.Functions.Surfaces.GetComponent() &&
    frame.View.IsInFront(frame.Mesh.Layout.HalfSize);
}
}

bool VisibleCells::IsReady(const VolumeFrame& frame, CellRanges& ranges)
{
  this->CanShorten = false;
  const Dependencies now =
    Dependencies::On(frame.Mesh.Buffers.GetNumberOfUploads(), frame.Functions.Version);
  if (this->Seen.Update(now) || !AreSupported(frame))
  {
    return false;
  }
  if (this->Marked.Update(now))
  {
    this->AreMarked = this->MarkCells(frame, ranges);
  }
  this->CanShorten = this->AreMarked;
  return this->CanShorten;
}

bool VisibleCells::MarkCells(const VolumeFrame& frame, CellRanges& ranges)
{
  const TransferFunctions::Curve& curve = frame.Functions.Functions.GetCurves().front();
  const RayCastMesh& layout = frame.Mesh.Layout;
  const std::vector<ActiveCells::Interval> visible = FindVisibleIntervals(
    curve.Pieces, layout.ScalarLow[curve.Component], layout.ScalarSize[curve.Component]);
  const bool areAllVisible = visible.size() == 1 && visible.front()[0] <= 0.0f &&
    visible.front()[1] >= 1.0f; // scalars are from 0 to 1
  const bool isReady = !areAllVisible && ranges.Update(frame) &&
    ranges.Mark(frame, visible, VisibleMargin, this->Cells) && this->AreWorthwhile() &&
    this->Cells.UploadFaces(frame.Window, this->Cells.GetMarkedNumbers());
  if (!isReady)
  {
    this->Cells.ReleaseGraphicsResources(frame.Window);
  }
  return isReady;
}

bool VisibleCells::AreWorthwhile() const
{
  const double skipped = static_cast<double>(this->Cells.GetNumberOfSkippedCells());
  const double all = skipped + static_cast<double>(this->Cells.GetNumberOfActiveCells());
  return skipped >= LeastSkipped * all &&
    this->Cells.GetNumberOfFaces() <= std::max(MostFaces * all, FewFaces);
}

bool VisibleCells::Find(const VolumeFrame& frame, const std::array<int, 2>& size)
{
  VolumeShaderOptions options = frame.Features.Options;
  options.HasActiveCells = true;
  options.HasVisibleCells = true;
  return this->Outlines.Find(
           frame, options, frame.GetView({ { 0, 0, size[0], size[1] } }), this->Cells) &&
    this->DrawFaces(frame, size, false) && this->DrawFaces(frame, size, true);
}

// Find the first face where a ray enters or, among all faces, the farthest corner.
bool VisibleCells::DrawFaces(
  const VolumeFrame& frame, const std::array<int, 2>& size, bool hasAllFaces)
{
  VolumeShaderOptions options = frame.Features.Options;
  options.HasActiveCells = true;
  vtkShaderProgram* program = frame.Programs.Ready(
    frame.Window, hasAllFaces ? VolumeShader::LastVisible : VolumeShader::FirstVisible, options);
  RenderTarget& target = hasAllFaces ? this->Ends : this->Begins;
  if (!program || !target.Begin(frame.Window, size[0], size[1], { { 1 } }, true))
  {
    return false;
  }
  const RayView view = frame.GetView({ { 0, 0, size[0], size[1] } });
  view.SetUniforms(program);
  program->SetUniformi("hasAllFaces", hasAllFaces ? 1 : 0);
  program->SetUniformf(
    "depthScale", static_cast<float>(view.GetDepthScale(frame.Mesh.Layout.HalfSize)));
  frame.Mesh.Buffers.Activate(program);
  this->Cells.Activate(program);
  this->Outlines.Activate(program);
  target.Draw(hasAllFaces ? BlendOperation::Maximum : BlendOperation::Nearest,
    [this] { this->Faces.Draw(this->Cells.GetNumberOfFaces()); });
  target.End();
  this->Outlines.Deactivate();
  this->Cells.Deactivate();
  frame.Mesh.Buffers.Deactivate();
  return true;
}

void VisibleCells::Activate(const VolumeFrame& frame, vtkShaderProgram* program)
{
  this->Cells.Activate(program);
  this->Begins.Activate(program, "visibleBegins");
  this->Ends.Activate(program, "visibleEnds");
  program->SetUniformf("visibleMargin",
    static_cast<float>(DepthMargin / frame.View.GetDepthScale(frame.Mesh.Layout.HalfSize)));
}

void VisibleCells::Deactivate()
{
  this->Ends.Deactivate();
  this->Begins.Deactivate();
  this->Cells.Deactivate();
}

void VisibleCells::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Cells.ReleaseGraphicsResources(window);
  this->Outlines.ReleaseGraphicsResources(window);
  this->Faces.ReleaseGraphicsResources();
  this->Begins.ReleaseGraphicsResources(window);
  this->Ends.ReleaseGraphicsResources(window);
  this->Marked.Clear();
}
}
