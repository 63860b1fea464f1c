// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapper.h"

#include "Cells/VolumeCells.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Mesh/MeshSimplifier.h"
#include "OpenGL/ContextWatch.h"
#include "OpenGL/RelevoOpenGL.h"
#include "OpenGL/RenderClock.h"
#include "Probe/ProbeRequest.h"
#include "Probe/VolumeSelection.h"
#include "Segments/RaySegments.h"
#include "Shaders/VolumePrograms.h"
#include "Stages/CellProjector.h"
#include "Stages/CellRanges.h"
#include "Stages/Compositor.h"
#include "Stages/FeatureSelector.h"
#include "Stages/FunctionLoader.h"
#include "Stages/MeshLoader.h"
#include "Stages/RayCaster.h"
#include "Stages/SegmentCaster.h"
#include "Stages/SegmentRequest.h"
#include "Stages/SurfaceCaster.h"
#include "Stages/TableLoader.h"
#include "Stages/VisibleCells.h"
#include "Stages/VolumeFrame.h"
#include "View/EventPace.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGridBase.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <string>

namespace
{
// Return whether gradients at points may be needed.
bool IsShaded(vtkVolumeProperty* property)
{
  bool isShaded = false;
  for (int i = 0; i < relevo::MaximumComponents; ++i)
  {
    isShaded = isShaded || property->GetShade(i) != 0;
  }
  return isShaded;
}
}

struct vtkGPUUnstructuredGridVolumeMapper::vtkInternals
{
  // A mesh and what depends on its layout.
  struct Level
  {
    relevo::MeshLoader Mesh;
    relevo::FunctionLoader Functions;
    relevo::FeatureSelector Features;
    relevo::TableLoader Table;
    relevo::CellRanges Ranges;
    relevo::SurfaceCaster Surfaces;
    relevo::VisibleCells Visible;

    vtkTypeInt64 GetMemorySize() const
    {
      const relevo::VolumeMesh& mesh = this->Mesh.GetMesh();
      const relevo::VolumeFunctions& functions = this->Functions.GetFunctions();
      return mesh.Buffers.GetMemorySize() + mesh.Cells.GetMemorySize() +
        functions.Buffers.GetMemorySize() + functions.Surfaces.GetMemorySize() +
        this->Table.GetTable().GetMemorySize() + this->Surfaces.GetMemorySize() +
        this->Visible.GetMemorySize();
    }
    void ReleaseGraphicsResources(vtkWindow* window)
    {
      this->Mesh.ReleaseGraphicsResources(window);
      this->Functions.ReleaseGraphicsResources(window);
      this->Table.ReleaseGraphicsResources(window);
      this->Ranges.Clear();
      this->Surfaces.ReleaseGraphicsResources(window);
      this->Visible.ReleaseGraphicsResources(window);
    }
  };
  Level Full;
  Level Simple;
  Level* Shown = &Full;
  relevo::MeshSimplifier Simplifier;
  relevo::SimplifiedMesh Simplified;

  void TakeSimplified()
  {
    if (const auto result = this->Simplifier.Take())
    {
      this->Simplified = *result;
    }
  }
  void ForgetSimplified()
  {
    if (this->Simplified.Mesh)
    {
      this->Simple.ReleaseGraphicsResources(this->GetWindow());
    }
    this->Simplified = {};
  }
  // The simple mesh has the same messages.
  void Report(const relevo::StageReport& report, vtkObject* object) const
  {
    if (this->Shown == &this->Full)
    {
      report.InvokeEvents(object);
    }
  }

  vtkNew<relevo::ContextWatch> Context;
  vtkOpenGLRenderWindow* GetWindow() const { return this->Context->GetContext(); }
  // Still frames of an interactor have all the time that they need.
  bool IsMoving() const { return this->GetWindow()->GetDesiredUpdateRate() >= 1.0; }

  relevo::VolumePrograms Programs;
  relevo::RayCaster Rays;
  relevo::SegmentCaster Segments;
  relevo::CellProjector Cells;
  relevo::Compositor Compositor;
  relevo::VolumeSelection Selection;

  relevo::RayView View;
  std::array<int, 4> Viewport = { { 0, 0, 0, 0 } }; // of the last render
  std::string DrawError;                            // as reported
  std::string LevelWarning;                         // as reported
  std::string SizeError;                            // as reported
  relevo::RenderClock Clock;
  relevo::EventPace Pace;

  relevo::VolumeFrame MakeFrame(const relevo::RenderPasses& passes)
  {
    return { this->GetWindow(), this->Viewport, this->View, passes,
      this->Shown->Features.GetFeatures(), this->Shown->Mesh.GetMesh(),
      this->Shown->Functions.GetFunctions(), this->Shown->Table.GetTable(), this->Programs,
      this->Compositor.GetDepth(), this->Compositor.GetTarget(), this->Compositor.GetScreen() };
  }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Full.ReleaseGraphicsResources(window);
    this->Simple.ReleaseGraphicsResources(window);
    this->Programs.ReleaseGraphicsResources();
    this->Rays.ReleaseGraphicsResources(window);
    this->Segments.ReleaseGraphicsResources(window);
    this->Cells.ReleaseGraphicsResources(window);
    this->Compositor.ReleaseGraphicsResources(window);
    this->Clock.ReleaseGraphicsResources();
    this->Pace.SetWindow(nullptr);
  }
};

vtkStandardNewMacro(vtkGPUUnstructuredGridVolumeMapper);

vtkGPUUnstructuredGridVolumeMapper::vtkGPUUnstructuredGridVolumeMapper()
  : Internals(std::make_unique<vtkInternals>())
{
  vtkInternals* data = this->Internals.get();
  data->Context->OnRelease = [data](vtkWindow* window) { data->ReleaseGraphicsResources(window); };
}

vtkGPUUnstructuredGridVolumeMapper::~vtkGPUUnstructuredGridVolumeMapper()
{
  this->ReleaseGraphicsResources(nullptr);
  this->Internals->Context->OnRelease = nullptr;
}

void vtkGPUUnstructuredGridVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Context->Release();
  this->Superclass::ReleaseGraphicsResources(window);
}

int vtkGPUUnstructuredGridVolumeMapper::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

double* vtkGPUUnstructuredGridVolumeMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return this->Bounds;
  }
  this->Update();
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    composite->GetBounds(this->Bounds);
  }
  else if (auto* mesh = vtkDataSet::SafeDownCast(input))
  {
    mesh->GetBounds(this->Bounds);
  }
  return this->Bounds;
}

void vtkGPUUnstructuredGridVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  if (renderer->GetSelector())
  {
    relevo::StageReport report;
    relevo::RunWithinMemory(this, "the mesh",
      [&]
      {
        data.Selection.Draw(
          this->MakeProbeRequest(volume->GetProperty()), renderer, volume->GetMatrix(), report);
        return true;
      });
    report.InvokeEvents(this);
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    vtkErrorMacro("The render window is not a vtkOpenGLRenderWindow.");
    return;
  }
  data.Context->SetContext(window);
  data.Pace.SetWindow(this->AutoAdjustSampleDistances ? window : nullptr);
  data.Segments.ReleaseGraphicsResources(window);
  data.Clock.Start();
  const auto draw = [&]
  {
    const bool isReady = this->UpdateMesh(volume) && this->UpdateFunctions(volume) &&
      this->UpdateFeatures(renderer, volume, relevo::SegmentOutput::None) && this->UpdateTable();
    if (isReady)
    {
      this->Draw(volume);
    }
    return isReady;
  };
  relevo::RunWithinMemory(this, "the picture", draw);
  this->TimeToDraw = data.Clock.Stop();
  data.Compositor.SetTime(this->TimeToDraw);
}

relevo::MeshRequest vtkGPUUnstructuredGridVolumeMapper::MakeMeshRequest(
  vtkVolume* volume, const relevo::MeshExtent* whole, bool hasCorners)
{
  vtkVolumeProperty* property = volume->GetProperty();
  return { this->Internals->GetWindow(), this->GetDataObjectInput(),
    this->GetInputPortInformation(0),
    relevo::ChooseScalars(property, this->VectorMode, this->VectorComponent), this->ScalarMode,
    this->ArrayAccessMode, this->ArrayId, this->ArrayName ? this->ArrayName : "",
    property->GetIndependentComponents() != 0, IsShaded(property), hasCorners, this->ShapeTolerance,
    this->FieldTolerance, this->KeepHostData,
    this->BlendMode == ISOSURFACE_BLEND ||
      (this->BlendMode == COMPOSITE_BLEND && this->IsoSurfaces),
    this->LevelOfDetail, whole };
}

bool vtkGPUUnstructuredGridVolumeMapper::UpdateMesh(
  vtkVolume* volume, const relevo::MeshExtent* whole)
{
  vtkInternals& data = *this->Internals;
  const relevo::MeshRequest request =
    this->MakeMeshRequest(volume, whole, !whole && this->Method == CELL_PROJECTION);
  relevo::StageReport report;
  const bool isReady = relevo::RunWithinMemory(
    this, "the mesh", [&] { return data.Full.Mesh.Update(request, report); });
  report.InvokeEvents(this);
  data.Shown = &data.Full;
  if (isReady && !whole)
  {
    this->ChooseLevel(volume);
  }
  return isReady;
}

// Moving views draw the simplified mesh, if there is one.
void vtkGPUUnstructuredGridVolumeMapper::ChooseLevel(vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  if (this->LevelOfDetail == 0.0)
  {
    data.Simplifier.Cancel();
    data.ForgetSimplified();
    return;
  }
  const bool hasOne = data.Full.Mesh.GetMesh().NumberOfComponents == 1;
  const std::string warning =
    hasOne ? "" : "LevelOfDetail supports only one component; moving views draw the full mesh.";
  if (relevo::ShouldReport(data.LevelWarning, warning))
  {
    vtkWarningMacro(<< warning);
  }
  if (auto cells = data.Full.Mesh.TakeCells())
  {
    data.ForgetSimplified();
    data.Simplifier.Start(std::move(cells), this->LevelOfDetail);
  }
  data.TakeSimplified();
  if (!hasOne || !data.Simplified.Mesh || !data.IsMoving())
  {
    return;
  }
  relevo::MeshRequest request =
    this->MakeMeshRequest(volume, nullptr, this->Method == CELL_PROJECTION);
  request.Input = data.Simplified.Mesh;
  request.Choice = {};
  request.ScalarMode = VTK_SCALAR_MODE_USE_POINT_DATA;
  request.KeepsHostData = false;
  request.LevelOfDetail = 0.0;
  relevo::StageReport ignored; // of cells without volume
  const bool isReady = relevo::RunWithinMemory(
    this, "the simplified mesh", [&] { return data.Simple.Mesh.Update(request, ignored); });
  data.Shown = isReady ? &data.Simple : &data.Full;
}

bool vtkGPUUnstructuredGridVolumeMapper::UpdateFunctions(vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  const relevo::VolumeMesh& mesh = data.Shown->Mesh.GetMesh();
  relevo::StageReport report;
  const bool isReady = data.Shown->Functions.Update(
    { data.GetWindow(), volume->GetProperty(), mesh.NumberOfComponents, mesh.Layout }, report);
  data.Report(report, this);
  return isReady;
}

bool vtkGPUUnstructuredGridVolumeMapper::UpdateFeatures(
  vtkRenderer* renderer, vtkVolume* volume, relevo::SegmentOutput segments)
{
  vtkInternals& data = *this->Internals;
  const relevo::VolumeMesh& mesh = data.Shown->Mesh.GetMesh();
  const bool isVisible =
    data.View.Compute(renderer, volume->GetMatrix(), mesh.Layout.Center, mesh.Layout.Radius);
  const std::string error = data.View.IsTooLarge()
    ? "The mesh is larger than 1e36 in world coordinates; scale its points or the volume."
    : "";
  if (relevo::ShouldReport(data.SizeError, error))
  {
    vtkErrorMacro(<< error);
  }
  if (!isVisible || data.View.IsTooLarge())
  {
    return false;
  }
  const int tableDimensions = this->Integration == EXACT ? 0
    : this->Integration == PRE_INTEGRATED                ? 3
                                                         : 2;
  relevo::StageReport report;
  data.Shown->Features.Update({ renderer, volume->GetProperty(), this->ClippingPlanes, mesh,
                                data.Shown->Functions.GetFunctions(), data.View.GetMeshToWorld(),
                                static_cast<relevo::BlendMode>(this->BlendMode), this->IsoSurfaces,
                                tableDimensions, segments },
    report);
  data.Report(report, this);
  return true;
}

bool vtkGPUUnstructuredGridVolumeMapper::UpdateTable()
{
  vtkInternals& data = *this->Internals;
  const relevo::VolumeShaderOptions& options = data.Shown->Features.GetFeatures().Options;
  const relevo::RayCastMesh& layout = data.Shown->Mesh.GetMesh().Layout;
  const int component = options.FirstComponent;
  relevo::IntegralTable::Settings settings;
  settings.Size = this->TableSize;
  settings.Is2D = options.PreIntegrated == 2;
  settings.Longest =
    options.PreIntegrated > 0 ? layout.LongestEdge * data.View.GetLargestScale() : 0.0;
  settings.ScalarLow = layout.ScalarLow[component];
  settings.ScalarSize = layout.ScalarSize[component];
  relevo::StageReport report;
  const bool isReady = data.Shown->Table.Update(
    { data.GetWindow(), data.Shown->Functions.GetFunctions(), options.PreIntegrated > 0, settings },
    report);
  data.Report(report, this);
  return isReady;
}

relevo::MeshExtent vtkGPUUnstructuredGridVolumeMapper::MeasurePiece(
  vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  data.Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  relevo::MeshExtent extent;
  relevo::StageReport report;
  relevo::RunWithinMemory(this, "the mesh",
    [&]
    {
      extent = data.Full.Mesh.Measure(this->MakeMeshRequest(volume, nullptr, false), report);
      return true;
    });
  report.InvokeEvents(this);
  return extent;
}

bool vtkGPUUnstructuredGridVolumeMapper::CastSegments(vtkRenderer* renderer, vtkVolume* volume,
  const relevo::SegmentRequest& request, relevo::RaySegments& segments)
{
  vtkInternals& data = *this->Internals;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    vtkErrorMacro("The render window is not a vtkOpenGLRenderWindow.");
    return false;
  }
  data.Context->SetContext(window);
  volume->ComputeMatrix();
  glGetIntegerv(GL_VIEWPORT, data.Viewport.data());
  segments.Reset(data.Viewport[2], data.Viewport[3], {});
  const auto cast = [&](relevo::SegmentOutput output)
  {
    return this->UpdateMesh(volume, &request.Whole) && this->UpdateFunctions(volume) &&
      this->UpdateFeatures(renderer, volume, output) && this->UpdateTable() &&
      this->ReadSegments(request, segments);
  };
  return relevo::RunWithinMemory(this, "the picture",
    [&]
    {
      const bool hasBuffers = request.UsesStorageBuffers && !data.Segments.IsBufferTooLarge() &&
        relevo::SegmentCaster::HasStorageBuffers();
      return (hasBuffers && cast(relevo::SegmentOutput::Buffer)) ||
        ((!hasBuffers || data.Segments.IsBufferTooLarge()) && cast(relevo::SegmentOutput::Pass));
    });
}

bool vtkGPUUnstructuredGridVolumeMapper::ReadSegments(
  const relevo::SegmentRequest& request, relevo::RaySegments& segments)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = data.GetWindow();
  segments.Reset(data.Viewport[2], data.Viewport[3],
    relevo::GetSegmentFormat(data.Shown->Features.GetFeatures().Options));
  std::string error = request.Depths.empty()
    ? data.Compositor.ReadDepths(window, data.Viewport)
    : data.Compositor.SetDepths(window, data.Viewport, request.Depths, request.Begins);
  bool isDone = false;
  if (error.empty())
  {
    error =
      data.Segments.Cast(data.MakeFrame({}), data.Rays, this->MaximumSegments, segments, isDone);
  }
  if (relevo::ShouldReport(data.DrawError, error))
  {
    vtkErrorMacro(<< error);
  }
  return isDone;
}

relevo::ProbeRequest vtkGPUUnstructuredGridVolumeMapper::MakeProbeRequest(
  vtkVolumeProperty* property)
{
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  return { this->GetDataObjectInput(),
    relevo::ChooseScalars(property, this->VectorMode, this->VectorComponent),
    { this->ScalarMode, this->ArrayAccessMode, this->ArrayId,
      this->ArrayName ? this->ArrayName : "" },
    property, static_cast<relevo::BlendMode>(this->BlendMode),
    this->IsoSurfaces || this->BlendMode == ISOSURFACE_BLEND, this->ClippingPlanes };
}

void vtkGPUUnstructuredGridVolumeMapper::Draw(vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  glGetIntegerv(GL_VIEWPORT, data.Viewport.data());
  const relevo::RenderPasses passes(this, volume);
  const relevo::VolumeFrame frame = data.MakeFrame(passes);
  std::string error;
  if (!passes.IsEmpty())
  {
    error = data.Rays.Draw(frame, { { data.Viewport[2], data.Viewport[3] } });
  }
  else
  {
    error = data.Compositor.ReadDepths(data.GetWindow(), data.Viewport);
    if (error.empty())
    {
      error =
        this->Method == CELL_PROJECTION ? this->ProjectCells(frame) : this->CastRays(frame, volume);
    }
  }
  if (relevo::ShouldReport(data.DrawError, error))
  {
    vtkErrorMacro(<< error);
  }
}

std::string vtkGPUUnstructuredGridVolumeMapper::ProjectCells(const relevo::VolumeFrame& frame)
{
  vtkInternals& data = *this->Internals;
  const std::string error = data.Cells.Draw(frame);
  const bool isStored = relevo::IsStored(frame.Features.Options);
  return error.empty() ? data.Compositor.Add(frame,
                           isStored ? relevo::VolumeShader::Finish : relevo::VolumeShader::Picture)
                       : error;
}

std::string vtkGPUUnstructuredGridVolumeMapper::CastRays(
  const relevo::VolumeFrame& frame, vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  const std::array<int, 2> size = data.Compositor.ChooseSize(data.Viewport,
    { this->ImageSampleDistance, this->AutoAdjustSampleDistances && data.IsMoving(),
      data.Pace.GetFactor() * volume->GetAllocatedRenderTime() });
  vtkInternals::Level& level = *data.Shown;
  const bool startsInside = level.Surfaces.IsReady(frame, level.Ranges);
  const bool isSampled = startsInside || size[0] != data.Viewport[2] || size[1] != data.Viewport[3];
  relevo::VisibleCells* visible =
    level.Visible.IsReady(frame, level.Ranges) ? &level.Visible : nullptr;
  const std::string error =
    startsInside ? level.Surfaces.Draw(frame, size) : data.Rays.Draw(frame, size, visible);
  return error.empty() && isSampled ? data.Compositor.Add(frame, relevo::VolumeShader::Picture)
                                    : error;
}

void vtkGPUUnstructuredGridVolumeMapper::SetInputData(vtkUnstructuredGridBase* mesh)
{
  this->SetInputDataInternal(0, mesh);
}

void vtkGPUUnstructuredGridVolumeMapper::SetInputData(vtkDataSet* mesh)
{
  this->SetInputDataInternal(0, mesh);
}

void vtkGPUUnstructuredGridVolumeMapper::SetVectorMode(int mode)
{
  relevo::SetInRange(this, "VectorMode", this->VectorMode, mode, static_cast<int>(DISABLED),
    static_cast<int>(COMPONENT));
}

void vtkGPUUnstructuredGridVolumeMapper::SetVectorComponent(int component)
{
  relevo::SetInRange(
    this, "VectorComponent", this->VectorComponent, component, 0, relevo::MaximumComponents - 1);
}

void vtkGPUUnstructuredGridVolumeMapper::SetMethod(int method)
{
  relevo::SetChoice(this, "Method", this->Method, method, { "RAY_CASTING", "CELL_PROJECTION" });
}

void vtkGPUUnstructuredGridVolumeMapper::SetBlendMode(int mode)
{
  relevo::SetChoice(this, "BlendMode", this->BlendMode, mode,
    { "COMPOSITE_BLEND", "MAXIMUM_INTENSITY_BLEND", "MINIMUM_INTENSITY_BLEND",
      "AVERAGE_INTENSITY_BLEND", "ADDITIVE_BLEND", "ISOSURFACE_BLEND" });
}

void vtkGPUUnstructuredGridVolumeMapper::SetIntegration(int integration)
{
  relevo::SetChoice(this, "Integration", this->Integration, integration,
    { "EXACT", "PRE_INTEGRATED", "PRE_INTEGRATED_2D" });
}

// All supported OpenGL versions have 3D textures of at least 256 texels per axis.
void vtkGPUUnstructuredGridVolumeMapper::SetTableSize(int size)
{
  relevo::SetInRange(this, "TableSize", this->TableSize, size, 2, 256);
}

void vtkGPUUnstructuredGridVolumeMapper::SetImageSampleDistance(double distance)
{
  relevo::SetInRange(this, "ImageSampleDistance", this->ImageSampleDistance, distance, 0.1, 100.0);
}

void vtkGPUUnstructuredGridVolumeMapper::SetShapeTolerance(double share)
{
  relevo::SetInRange(this, "ShapeTolerance", this->ShapeTolerance, share, 1e-6, 1.0);
}

void vtkGPUUnstructuredGridVolumeMapper::SetFieldTolerance(double share)
{
  relevo::SetInRange(this, "FieldTolerance", this->FieldTolerance, share, 1e-6, 1.0);
}

void vtkGPUUnstructuredGridVolumeMapper::SetLevelOfDetail(double share)
{
  relevo::SetInRange(this, "LevelOfDetail", this->LevelOfDetail, share, 0.0, 1.0);
}

double vtkGPUUnstructuredGridVolumeMapper::GetLevelOfDetailError()
{
  this->Internals->TakeSimplified();
  return this->Internals->Simplified.Error;
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfLevelOfDetailCells()
{
  this->Internals->TakeSimplified();
  const auto& mesh = this->Internals->Simplified.Mesh;
  return mesh ? mesh->GetNumberOfCells() : 0;
}

void vtkGPUUnstructuredGridVolumeMapper::SetMaximumSegments(int number)
{
  relevo::SetInRange(this, "MaximumSegments", this->MaximumSegments, number, 1,
    relevo::RaySegments::MaximumPerPixel);
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfDrawnCells()
{
  return this->Internals->Full.Mesh.GetNumberOfDrawnCells();
}

// The layers are drawn on request, with the view of the last render.
int vtkGPUUnstructuredGridVolumeMapper::GetNumberOfLayers()
{
  vtkInternals& data = *this->Internals;
  if (!data.GetWindow() || !data.Full.Mesh.IsReady() || data.Viewport[2] == 0)
  {
    return 0;
  }
  data.GetWindow()->MakeCurrent();
  return data.Rays.CountLayers(data.MakeFrame({}));
}

vtkTypeInt64 vtkGPUUnstructuredGridVolumeMapper::GetGraphicsMemorySize()
{
  vtkInternals& data = *this->Internals;
  return data.Full.GetMemorySize() + data.Simple.GetMemorySize() + data.Segments.GetMemorySize();
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfSkippedCells()
{
  const vtkInternals::Level& level = *this->Internals->Shown;
  return static_cast<vtkIdType>(
    level.Surfaces.GetNumberOfSkippedCells() + level.Visible.GetNumberOfSkippedCells());
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfBufferBuilds()
{
  return this->Internals->Full.Mesh.GetNumberOfBuilds();
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfValueUploads()
{
  return this->Internals->Full.Mesh.GetNumberOfValueUploads();
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfNeighborSearches()
{
  return this->Internals->Full.Mesh.GetNumberOfNeighborSearches();
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfShaderBuilds()
{
  return this->Internals->Programs.GetNumberOfBuilds();
}

vtkIdType vtkGPUUnstructuredGridVolumeMapper::GetNumberOfTableBuilds()
{
  return this->Internals->Full.Table.GetNumberOfBuilds();
}

void vtkGPUUnstructuredGridVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VectorMode: " << this->VectorMode << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "IsoSurfaces: " << (this->IsoSurfaces ? "On" : "Off") << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Integration: " << this->Integration << "\n";
  os << indent << "TableSize: " << this->TableSize << "\n";
  os << indent << "ShapeTolerance: " << this->ShapeTolerance << "\n";
  os << indent << "FieldTolerance: " << this->FieldTolerance << "\n";
  os << indent << "KeepHostData: " << (this->KeepHostData ? "On" : "Off") << "\n";
  os << indent << "LevelOfDetail: " << this->LevelOfDetail << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MaximumSegments: " << this->MaximumSegments << "\n";
  os << indent << "AutoAdjustSampleDistances: " << (this->AutoAdjustSampleDistances ? "On" : "Off")
     << "\n";
  os << indent << "NumberOfDrawnCells: " << this->GetNumberOfDrawnCells() << "\n";
  os << indent << "NumberOfSkippedCells: " << this->GetNumberOfSkippedCells() << "\n";
  os << indent << "NumberOfBufferBuilds: " << this->GetNumberOfBufferBuilds() << "\n";
  os << indent << "NumberOfValueUploads: " << this->GetNumberOfValueUploads() << "\n";
  os << indent << "NumberOfNeighborSearches: " << this->GetNumberOfNeighborSearches() << "\n";
  os << indent << "NumberOfShaderBuilds: " << this->GetNumberOfShaderBuilds() << "\n";
  os << indent << "NumberOfTableBuilds: " << this->GetNumberOfTableBuilds() << "\n";
}
