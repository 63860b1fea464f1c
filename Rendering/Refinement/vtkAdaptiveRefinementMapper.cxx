// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinementMapper.h"

#include "vtkRelevoOpenGL.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDisplacement.h"
#include "vtkFaceCulling.h"
#include "vtkHardwareSelector.h"
#include "vtkHeightField.h"
#include "vtkInformation.h"
#include "vtkLevelBudget.h"
#include "vtkLinearSurface.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementBlocks.h"
#include "vtkRefinementColors.h"
#include "vtkRefinementComputeProgram.h"
#include "vtkRefinementComputeState.h"
#include "vtkRefinementFaceColors.h"
#include "vtkRefinementLevelTable.h"
#include "vtkRefinementMeshBuffers.h"
#include "vtkRefinementPatternBuffer.h"
#include "vtkRefinementShader.h"
#include "vtkRefinementState.h"
#include "vtkRefinementSurface.h"
#include "vtkRefinementView.h"
#include "vtkRelevoCompatibility.h"
#include "vtkRenderClock.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTimerLog.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
bool HasExtension(const char* name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    if (!std::strcmp(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)), name))
    {
      return true;
    }
  }
  return false;
}

bool HasWholeNumbers(vtkAdaptiveRefinement* recipe)
{
  return recipe && recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS;
}

// Whether VTK has not drawn the actor yet in this frame.
bool IsFirstPass(vtkActor* act)
{
  return act->GetEstimatedRenderTime() == 0.0;
}

// In seconds. An actor within an actor, as vtkLODActor has, is allotted no time of its own.
double GetAllocatedTime(vtkRenderer* ren, vtkActor* act)
{
  return std::min(act->GetAllocatedRenderTime(), ren->GetAllocatedRenderTime());
}

// Whether VTK's own mapper would draw the vertices of faces.
bool AreVerticesDrawn(vtkProperty* property, vtkHardwareSelector* selector)
{
  if (!property->GetVertexVisibility())
  {
    return false;
  }
  if (relevo::VerticesNeedNoEdges)
  {
    return !selector || selector->GetFieldAssociation() != vtkDataObject::FIELD_ASSOCIATION_POINTS;
  }
  return property->GetEdgeVisibility() && property->GetRepresentation() == VTK_SURFACE && !selector;
}
}

struct vtkAdaptiveRefinementMapper::vtkInternals
{
  vtkInternals()
  {
    this->Faces.PrimitiveType = PrimitiveTris;
    this->Vertices.PrimitiveType = PrimitiveVertices;
  }

  relevo::RefinementState State;

  // GPU side.
  relevo::RefinementMeshBuffers Buffers;
  relevo::RefinementPatternBuffer Patterns;
  relevo::RefinementColors Colors;
  bool ColorsValid = false;
  relevo::RefinementLevelTable LevelTable;
  relevo::RefinementFaceColors FaceColors;
  vtkTimeStamp UploadTime;
  bool UploadValid = false;
  bool ContextChecked = false;
  bool ContextValid = false;
  bool Drawable = false;
  int NumberOfDrawCalls = 0;

  // Selections on the GPU.
  relevo::RefinementComputeState Compute;
  bool ComputeValid = false; // the context can, and nothing has failed
  bool OnGPU = false;        // in the last render
  double ComputeSeconds = 0.0;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // whose context has them
  vtkMTimeType ReadTime = 0;                    // of what was read back
  int NumberOfUsedPatterns = 0;                 // of that
  int NumberOfHiddenFaces = 0;                  // and of that

  int CountUsedPatterns() const
  {
    if (this->OnGPU)
    {
      return this->NumberOfUsedPatterns;
    }
    int count = 0;
    const auto& groups = this->State.GetSelection().GetSelection().Groups;
    for (size_t i = 0; i < groups.size(); ++i)
    {
      count += i == 0 || groups[i].Pattern != groups[i - 1].Pattern;
    }
    return count;
  }

  // What draws refined faces, and their vertices when those are shown.
  vtkOpenGLHelper Faces;
  vtkOpenGLHelper Vertices;
  struct ProgramState
  {
    std::string ShaderKey;
    std::vector<std::string> Attributes;
    vtkOpenGLBufferObject* PatternVertices = nullptr;
    vtkMTimeType AliasTime = 0;
  };
  std::map<const vtkOpenGLHelper*, ProgramState> Programs;

  relevo::RefinementBlocks Blocks;

  // Of all blocks of a composite input it is their parent's that counts.
  relevo::LevelBudget Budget;
  relevo::RenderClock Clock;
  bool IsBlock = false;

  relevo::RefinementComputeState::Targets GetTargets() const
  {
    return { this->Buffers.GetFaces(), this->Buffers.GetInstances(), this->Buffers.GetMorphTags() };
  }

  relevo::RefinementShaderOptions GetShaderOptions(
    const vtkAdaptiveRefinementMapper* mapper, const vtkOpenGLHelper* cellBO) const;
};

vtkStandardNewMacro(vtkAdaptiveRefinementMapper);

vtkAdaptiveRefinementMapper::vtkAdaptiveRefinementMapper()
  : Internals(new vtkInternals)
{
}

vtkAdaptiveRefinementMapper::~vtkAdaptiveRefinementMapper()
{
  // While virtual calls still reach this class, and in the context of the window.
  this->ReleaseGraphicsResources(nullptr);
}

void vtkAdaptiveRefinementMapper::SetRefinement(vtkAdaptiveRefinement* refinement)
{
  if (this->Refinement != refinement)
  {
    this->Refinement = refinement;
    this->Modified();
  }
}

vtkAdaptiveRefinement* vtkAdaptiveRefinementMapper::GetRefinement()
{
  return this->Refinement;
}

// Not Modified(): that would make VTK upload the mesh again.
void vtkAdaptiveRefinementMapper::SetFrustumCulling(bool culling)
{
  this->FrustumCulling = culling;
  this->Internals->Blocks.ForEach(
    [culling](vtkAdaptiveRefinementMapper* block) { block->SetFrustumCulling(culling); });
}

void vtkAdaptiveRefinementMapper::SetBackFaceCulling(bool culling)
{
  this->BackFaceCulling = culling;
  this->Internals->Blocks.ForEach(
    [culling](vtkAdaptiveRefinementMapper* block) { block->SetBackFaceCulling(culling); });
}

void vtkAdaptiveRefinementMapper::SetColorMode(int mode)
{
  this->SetColorModeToScalars();
  this->Superclass::SetColorMode(mode);
}

// Not Modified(), as above.
void vtkAdaptiveRefinementMapper::SetRefinementColorMode(RefinementColorModes mode)
{
  this->RefinementColorMode = mode;
  this->Internals->Blocks.ForEach(
    [mode](vtkAdaptiveRefinementMapper* block) { block->SetRefinementColorMode(mode); });
}

void vtkAdaptiveRefinementMapper::SetLevelLookupTable(vtkScalarsToColors* table)
{
  this->LevelLookupTable = table;
  this->Internals->Blocks.ForEach(
    [table](vtkAdaptiveRefinementMapper* block) { block->SetLevelLookupTable(table); });
}

vtkScalarsToColors* vtkAdaptiveRefinementMapper::GetLevelLookupTable()
{
  if (this->LevelLookupTable)
  {
    return this->LevelLookupTable;
  }
  vtkAdaptiveRefinement* recipe = this->Refinement;
  return this->Internals->LevelTable.Get(
    this->RefinementColorMode, HasWholeNumbers(recipe), recipe ? recipe->GetMaximumLevel() : 0);
}

void vtkAdaptiveRefinementMapper::SetTargetNumberOfTriangles(vtkIdType triangles)
{
  if (triangles < 0)
  {
    vtkErrorMacro("TargetNumberOfTriangles must not be negative, got " << triangles << ".");
    return;
  }
  this->Internals->Budget.Target = triangles;
}

vtkIdType vtkAdaptiveRefinementMapper::GetTargetNumberOfTriangles()
{
  return this->Internals->Budget.Target;
}

void vtkAdaptiveRefinementMapper::SetUseAllocatedRenderTime(bool use)
{
  this->UseAllocatedRenderTime = use;
}

double vtkAdaptiveRefinementMapper::GetLevelOffset()
{
  return this->Internals->State.LevelOffset;
}

int vtkAdaptiveRefinementMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkAdaptiveRefinementMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkAdaptiveRefinementMapper* other = vtkAdaptiveRefinementMapper::SafeDownCast(mapper))
  {
    this->SetRefinement(other->GetRefinement());
    this->SetTargetNumberOfTriangles(other->GetTargetNumberOfTriangles());
    this->SetUseAllocatedRenderTime(other->GetUseAllocatedRenderTime());
    this->SetFrustumCulling(other->GetFrustumCulling());
    this->SetBackFaceCulling(other->GetBackFaceCulling());
    this->SetSelectionDevice(other->GetSelectionDevice());
    this->SetLevelLookupTable(other->LevelLookupTable);
    this->ExtraAttributes = other->ExtraAttributes;
    this->SetVBOShiftScaleMethod(other->GetVBOShiftScaleMethod());
  }
  this->Superclass::ShallowCopy(mapper); // sets VTK's colour mode
  if (vtkAdaptiveRefinementMapper* other = vtkAdaptiveRefinementMapper::SafeDownCast(mapper))
  {
    this->SetRefinementColorMode(other->RefinementColorMode);
  }
}

void vtkAdaptiveRefinementMapper::SetSelectionDevice(int device)
{
  if (device < SELECTION_DEVICE_AUTOMATIC || device > SELECTION_DEVICE_GPU)
  {
    vtkErrorMacro("SelectionDevice is 0 (automatic), 1 (CPU) or 2 (GPU), not " << device << ".");
    return;
  }
  if (this->SelectionDevice != device)
  {
    this->SelectionDevice = device;
    this->Internals->ContextChecked = false;
    this->Modified();
  }
}

int vtkAdaptiveRefinementMapper::GetSelectionDeviceInUse()
{
  bool onGPU = this->Internals->OnGPU;
  this->Internals->Blocks.ForEach([&onGPU](vtkAdaptiveRefinementMapper* block)
    { onGPU = onGPU || block->GetSelectionDeviceInUse() == SELECTION_DEVICE_GPU; });
  return onGPU ? SELECTION_DEVICE_GPU : SELECTION_DEVICE_CPU;
}

bool vtkAdaptiveRefinementMapper::IsComposite()
{
  return vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)) != nullptr;
}

//------------------------------------------------------------------------------
// Statistics

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfDrawnTriangles()
{
  vtkInternals& data = *this->Internals;
  if (!data.Blocks.IsEmpty())
  {
    vtkIdType sum = 0;
    data.Blocks.ForEach(
      [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfDrawnTriangles(); });
    return sum;
  }
  this->ReadSelection();
  return data.Drawable ? data.State.GetNumberOfTriangles(this->GetInput(), this->Refinement) : 0;
}

int vtkAdaptiveRefinementMapper::GetNumberOfDrawCalls()
{
  int sum = this->Internals->NumberOfDrawCalls;
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfDrawCalls(); });
  return sum;
}

int vtkAdaptiveRefinementMapper::GetNumberOfUsedPatterns()
{
  this->ReadSelection();
  int sum = this->Internals->CountUsedPatterns();
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfUsedPatterns(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfSelections()
{
  vtkIdType sum = this->Internals->State.GetNumberOfSelections();
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfSelections(); });
  return sum;
}

double vtkAdaptiveRefinementMapper::GetSelectionTime()
{
  double sum = this->Internals->State.GetSelection().GetSeconds() +
    (this->Internals->OnGPU ? this->Internals->ComputeSeconds : 0.0);
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetSelectionTime(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCoarseFaces()
{
  vtkIdType sum = static_cast<vtkIdType>(this->Internals->State.GetMesh().Faces.size());
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfCoarseFaces(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCulledFaces()
{
  this->ReadSelection();
  const vtkInternals& data = *this->Internals;
  vtkIdType sum = data.OnGPU
    ? data.NumberOfHiddenFaces
    : (data.Drawable ? data.State.GetSelection().GetNumberOfHiddenFaces() : 0);
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfCulledFaces(); });
  return sum;
}

vtkTypeInt64 vtkAdaptiveRefinementMapper::GetGraphicsMemorySize()
{
  vtkInternals& data = *this->Internals;
  vtkTypeInt64 sum = data.Buffers.GetMemorySize() + data.Patterns.GetMemorySize() +
    data.Colors.GetMemorySize() + data.FaceColors.GetMemorySize() + data.Compute.GetMemorySize();
  for (const char* name :
    { "vertexMC", "normalMC", "scalarColor", "tcoord", "colorTCoord", "tangentMC" })
  {
    if (vtkOpenGLVertexBufferObject* vbo = this->VBOs->GetVBO(name))
    {
      sum += static_cast<vtkTypeInt64>(vbo->GetNumberOfTuples()) * vbo->GetStride();
    }
  }
  data.Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetGraphicsMemorySize(); });
  return sum;
}

//------------------------------------------------------------------------------
// The coarse mesh and its bounds

bool vtkAdaptiveRefinementMapper::Report(bool valid)
{
  const std::string error = this->Internals->State.TakeError();
  const std::string warning = this->Internals->State.TakeWarning();
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  return valid;
}

bool vtkAdaptiveRefinementMapper::UpdateMesh()
{
  vtkPolyData* input = this->GetInput();
  return input && this->Report(this->Internals->State.UpdateMesh(input, this->Refinement));
}

bool vtkAdaptiveRefinementMapper::SelectsOnGPU()
{
  const vtkInternals& data = *this->Internals;
  return data.ComputeValid && !data.State.IsBudgeted &&
    this->RefinementColorMode != COLOR_BY_METRIC &&
    relevo::RefinementComputeState::CanChooseFrom(
      relevo::GetPatternFamily(this->Refinement, this->GetInput()));
}

namespace
{
vtkRefinementView MakeView(vtkRenderer* ren, vtkActor* act)
{
  vtkRefinementView view;
  view.Camera = ren->GetActiveCamera();
  view.ModelToWorld = act->GetMatrix();
  std::copy_n(ren->GetSize(), 2, view.ViewportSize);
  return view;
}

// What a camera sees of a mesh; nullptr to draw all of it.
std::unique_ptr<relevo::CullingView> MakeCullingView(
  bool culled, vtkRenderer* ren, vtkActor* act, const relevo::RefinementMesh& mesh)
{
  return std::unique_ptr<relevo::CullingView>(culled
      ? new relevo::CullingView(
          ren->GetActiveCamera(), ren->GetTiledAspectRatio(), act->GetMatrix(), mesh)
      : nullptr);
}
}

bool vtkAdaptiveRefinementMapper::UpdateSelection(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const vtkRefinementView view = MakeView(ren, act);
  const auto culling = MakeCullingView(this->FrustumCulling, ren, act, data.State.GetMesh());
  return this->Report(data.State.UpdateSelection(this->GetInput(), this->Refinement, view,
    culling.get(), this->HidesBackFaces(ren, act), data.OnGPU));
}

void vtkAdaptiveRefinementMapper::UpdateBudget(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  if (data.IsBlock)
  {
    return;
  }
  double seconds = 0.0;
  if (this->UseAllocatedRenderTime)
  {
    // What has been seen is picked, and later passes show what the first has shown.
    seconds = IsFirstPass(act) && !ren->GetSelector() ? GetAllocatedTime(ren, act) : -1.0;
  }
  const bool isBudgeted = data.Budget.SetView(ren->GetActiveCamera(), seconds);
  const vtkRefinementView view = MakeView(ren, act);
  std::vector<relevo::LevelBudget::Part> parts;
  const auto addPart = [&](vtkAdaptiveRefinementMapper* mapper)
  {
    relevo::RefinementState& state = mapper->Internals->State;
    state.IsBudgeted = isBudgeted;
    if (isBudgeted && mapper->UpdateMesh() &&
      state.UpdateTags(mapper->GetInput(), this->Refinement, view, false))
    {
      const relevo::ViewSelection& selection = state.GetSelection();
      parts.push_back({ { &state.GetMesh(), &selection.GetTags(),
                          &relevo::GetPatternFamily(this->Refinement, mapper->GetInput()) },
        selection.GetTagsTime() });
    }
  };
  if (data.Blocks.IsEmpty())
  {
    addPart(this);
  }
  data.Blocks.ForEach(addPart);
  const double offset = parts.empty() ? 0.0 : data.Budget.FindOffset(parts, this->Refinement);
  const auto setOffset = [&](vtkAdaptiveRefinementMapper* mapper)
  {
    mapper->Internals->State.LevelOffset = offset;
    mapper->Internals->IsBlock = mapper != this;
  };
  setOffset(this);
  data.Blocks.ForEach(setOffset);
}

bool vtkAdaptiveRefinementMapper::SelectOnGPU(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  const double start = vtkTimerLog::GetUniversalTime();
  const relevo::RefinementMesh& mesh = data.State.GetMesh();
  const relevo::PatternFamily& family =
    relevo::GetPatternFamily(this->Refinement, this->GetInput());
  const int slot = data.State.GetSelectionSlot();
  const vtkMTimeType lastTime = data.Compute.GetTime(slot);
  const relevo::ViewSelection& selection = data.State.GetSelection();
  const auto camera = MakeCullingView(this->FrustumCulling, ren, act, mesh);
  const relevo::FaceCulling* culled = camera ? &data.State.GetCulling(this->Refinement) : nullptr;
  const bool reserved =
    data.Buffers.ReserveSelection(window, slot, mesh.Faces.size(), family.IsMorphing());
  const bool valid = reserved && data.Compute.UpdateMesh(mesh, data.State.GetMeshTime()) &&
    (!culled || data.Compute.UpdateCulling(*culled, data.State.GetCullingTime())) &&
    data.Compute.UpdatePatterns(family, this->Refinement->GetPatternTable(), data.Patterns,
      act->GetProperty()->GetRepresentation() == VTK_WIREFRAME) &&
    data.Compute.UpdateView(window, slot, selection.GetTags(),
      static_cast<float>(this->Refinement->GetLevelOffset() + data.State.LevelOffset),
      selection.GetLevelsTime(), camera.get(),
      culled && culled->HidesBehind(*camera, this->HidesBackFaces(ren, act)), data.GetTargets());
  if (data.Compute.GetTime(slot) != lastTime)
  {
    data.ComputeSeconds = vtkTimerLog::GetUniversalTime() - start;
  }
  if (!valid)
  {
    this->GiveUpGPU(reserved ? data.Compute.GetError() : data.Buffers.GetError());
  }
  return valid;
}

void vtkAdaptiveRefinementMapper::GiveUpGPU(const std::string& reason)
{
  this->Internals->ComputeValid = false; // said once, until something changes
  if (this->SelectionDevice == SELECTION_DEVICE_GPU)
  {
    vtkErrorMacro("Selection on the GPU failed: " << reason << ". It is done on the CPU.");
  }
  else
  {
    vtkWarningMacro("Selection on the GPU failed: " << reason << ". It is done on the CPU.");
  }
}

void vtkAdaptiveRefinementMapper::ReadSelection()
{
  vtkInternals& data = *this->Internals;
  const int slot = data.State.GetSelectionSlot();
  const vtkMTimeType time = data.OnGPU && data.Window ? data.Compute.GetTime(slot) : 0;
  if (time == 0 || time == data.ReadTime)
  {
    return;
  }
  data.ReadTime = time;
  data.Window->MakeCurrent();
  std::vector<float> morphTags;
  if (data.Buffers.GetMorphTags())
  {
    morphTags.resize(3 * data.State.GetMesh().Faces.size());
    relevo::RefinementComputeBuffer::ReadBuffer(
      data.Buffers.GetMorphTags(), 0, morphTags.data(), morphTags.size() * sizeof(float));
  }
  data.State.AssignSelection(this->GetInput(), this->Refinement, *data.Compute.GetFamily(),
    data.Compute.ReadEntries(slot), std::move(morphTags));
  const std::vector<int> counts = data.Compute.ReadCounts(slot);
  data.NumberOfHiddenFaces = static_cast<int>(data.State.GetMesh().Faces.size()) -
    std::accumulate(counts.begin(), counts.end(), 0);
  // Two keys share a pattern, of which one turns it over.
  data.NumberOfUsedPatterns = 0;
  for (size_t key = 0; key + 1 < counts.size(); key += 2)
  {
    data.NumberOfUsedPatterns += counts[key] + counts[key + 1] > 0 ? 1 : 0;
  }
}

bool vtkAdaptiveRefinementMapper::HidesBackFaces(vtkRenderer* ren, vtkActor* act)
{
  vtkProperty* property = act->GetProperty();
  return this->BackFaceCulling && !ren->GetSelector() &&
    property->GetRepresentation() == VTK_SURFACE && !property->GetFrontfaceCulling() &&
    !property->GetVertexVisibility() && !property->GetEdgeVisibility() &&
    !act->HasTranslucentPolygonalGeometry() && this->GetNumberOfClippingPlanes() == 0 &&
    act->GetMatrix()->Determinant() > 0.0;
}

double* vtkAdaptiveRefinementMapper::GetBounds()
{
  if (!this->GetNumberOfInputConnections(0))
  {
    vtkMath::UninitializeBounds(this->Bounds);
    return this->Bounds;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->ComputeBounds();
  return this->Bounds;
}

void vtkAdaptiveRefinementMapper::ComputeBounds()
{
  vtkInternals& data = *this->Internals;
  if (vtkCompositeDataSet* composite =
        vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)))
  {
    data.Blocks.Update(this, composite);
    vtkBoundingBox box;
    data.Blocks.ForEach(
      [&box](vtkAdaptiveRefinementMapper* block) { box.AddBounds(block->GetBounds()); });
    vtkMath::UninitializeBounds(this->Bounds);
    if (box.IsValid())
    {
      box.GetBounds(this->Bounds);
    }
    return;
  }
  data.Blocks.Clear();
  if (!this->UpdateMesh())
  {
    // Of the points only: vtkPolyData does not check what cells refer to.
    vtkPoints* points = this->GetInput() ? this->GetInput()->GetPoints() : nullptr;
    vtkMath::UninitializeBounds(this->Bounds);
    if (points && points->GetNumberOfPoints() > 0)
    {
      points->GetBounds(this->Bounds);
    }
    return;
  }
  data.State.GetBounds(this->GetInput(), this->Refinement, this->Bounds);
}

//------------------------------------------------------------------------------
// Buffers

bool vtkAdaptiveRefinementMapper::CheckOpenGL(vtkRenderer*)
{
  vtkInternals& data = *this->Internals;
  if (!data.ContextChecked)
  {
    data.ContextChecked = true;
    GLint major = 0;
    GLint minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    const bool instancing = major > 3 || (major == 3 && minor >= 3);
    const bool rgbBuffers = major > 3 || HasExtension("GL_ARB_texture_buffer_object_rgb32");
    data.ContextValid = instancing && rgbBuffers;
    if (!data.ContextValid)
    {
      vtkErrorMacro("Refinement needs OpenGL 3.3 with ARB_texture_buffer_object_rgb32 (part of "
                    "OpenGL 4.0); this context has OpenGL "
        << major << "." << minor << (rgbBuffers ? " with it." : " without it."));
    }
    data.ComputeValid = data.ContextValid && this->SelectionDevice != SELECTION_DEVICE_CPU &&
      relevo::RefinementComputeProgram::IsSupported();
    if (this->SelectionDevice == SELECTION_DEVICE_AUTOMATIC)
    {
      data.ComputeValid = data.ComputeValid && relevo::RefinementComputeState::IsHardware();
    }
    else if (data.ContextValid && !data.ComputeValid &&
      this->SelectionDevice == SELECTION_DEVICE_GPU)
    {
      vtkErrorMacro("Selection on the GPU needs OpenGL 4.3; this context has OpenGL "
        << major << "." << minor << ". It is done on the CPU.");
    }
  }
  return data.ContextValid;
}

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  const bool needed = this->Superclass::GetNeedToRebuildBufferObjects(ren, act);
  return needed || this->Internals->UploadTime < this->Internals->State.GetMeshTime();
}

void vtkAdaptiveRefinementMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::BuildBufferObjects(ren, act);
  vtkInternals& data = *this->Internals;
  data.UploadTime.Modified();
  data.UploadValid = false;
  const relevo::RefinementMesh& mesh = data.State.GetMesh();
  vtkOpenGLVertexBufferObject* positions = this->VBOs->GetVBO("vertexMC");
  if (!data.State.IsMeshValid() || mesh.Faces.empty() || !positions)
  {
    return;
  }

  // The ids that VTK would draw cells with: they index its cell textures and its selections.
  vtkPolyData* input = this->CurrentInput;
  vtkCellArray* cells[4] = { input->GetVerts(), input->GetLines(), input->GetPolys(),
    input->GetStrips() };
  this->CellCellMap->Update(cells, act->GetProperty()->GetRepresentation(), input->GetPoints());
  std::vector<int> primitiveOfCell(static_cast<size_t>(input->GetNumberOfCells()), 0);
  for (size_t i = this->CellCellMap->GetSize(); i-- > 0;)
  {
    primitiveOfCell[this->CellCellMap->GetValue(i)] = static_cast<int>(i);
  }
  std::vector<int> primitives(mesh.Faces.size());
  for (size_t f = 0; f < primitives.size(); ++f)
  {
    primitives[f] = primitiveOfCell[mesh.Faces[f].Cell];
  }
  vtkRefinementSurface* surface = this->Refinement->GetSurface();
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkDataArray* scalars = this->GetScalarsToInterpolate();
  data.ColorsValid =
    scalars && data.Colors.Upload(window, scalars, this->GetLookupTable(), this->ArrayComponent);
  data.UploadValid = data.Buffers.UploadMesh(
    window, mesh, surface ? surface->GetNumberOfEdgePositions() : 0, positions, primitives);
  if (!data.UploadValid)
  {
    vtkErrorMacro("Cannot draw the input: " << data.Buffers.GetError() << ".");
  }
}

vtkDataArray* vtkAdaptiveRefinementMapper::GetScalarsToInterpolate()
{
  if (this->VBOs->GetNumberOfComponents("scalarColor") == 0)
  {
    return nullptr;
  }
  int cellFlag = 0;
  vtkDataArray* scalars =
    vtkDataArray::SafeDownCast(vtkAbstractMapper::GetAbstractScalars(this->GetInput(),
      this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag));
  const bool direct = this->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (this->ColorMode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(scalars));
  return cellFlag == 0 && !direct ? scalars : nullptr;
}

void vtkAdaptiveRefinementMapper::BuildIBO(vtkRenderer* ren, vtkActor* act, vtkPolyData* poly)
{
  // Faces are drawn from patterns: VTK needs indices of vertices and lines only.
  vtkNew<vtkPolyData> others;
  others->ShallowCopy(poly);
  others->SetPolys(nullptr);
  others->SetStrips(nullptr);
  this->Superclass::BuildIBO(ren, act, others);
  // From VTK 9.3 on the flags of edges to draw start with places for vertices and lines. They are
  // about faces, whose shader has flags of its own.
  this->EdgeValues.clear();
}

void vtkAdaptiveRefinementMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  // Comes back to this method from within the context that the resources belong to.
  this->Superclass::ReleaseGraphicsResources(window);
  vtkInternals& data = *this->Internals;
  data.Buffers.ReleaseGraphicsResources(window);
  data.Patterns.ReleaseGraphicsResources();
  data.Colors.ReleaseGraphicsResources(window);
  data.Clock.ReleaseGraphicsResources();
  data.Compute.ReleaseGraphicsResources();
  data.FaceColors.ReleaseGraphicsResources(window);
  if (data.OnGPU)
  {
    data.State.ForgetLevels(); // what a metric gave for the GPU may be gone
  }
  data.Faces.ReleaseGraphicsResources(window);
  data.Vertices.ReleaseGraphicsResources(window);
  data.Programs.clear();
  data.UploadValid = false;
  data.ContextChecked = false;
  data.Blocks.ForEach(
    [window](vtkAdaptiveRefinementMapper* block) { block->ReleaseGraphicsResources(window); });
}

//------------------------------------------------------------------------------
// Rendering

void vtkAdaptiveRefinementMapper::RenderPiece(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  if (data.IsBlock || !this->UseAllocatedRenderTime || ren->GetSelector())
  {
    this->RenderRefined(ren, act);
    return;
  }
  data.Clock.Start();
  this->RenderRefined(ren, act);
  const double seconds = data.Clock.Stop();
  // What the GPU selects is read back only where the time does not do.
  const bool isSlow = seconds > GetAllocatedTime(ren, act);
  vtkIdType triangles = 0;
  const auto addTriangles = [&](vtkAdaptiveRefinementMapper* mapper)
  {
    const vtkInternals& internals = *mapper->Internals;
    if (internals.Drawable && (isSlow || !internals.OnGPU))
    {
      triangles += internals.OnGPU
        ? mapper->GetNumberOfDrawnTriangles()
        : internals.State.GetSelection().GetSelection().GetNumberOfTriangles();
    }
  };
  if (data.Blocks.IsEmpty())
  {
    addTriangles(this);
  }
  data.Blocks.ForEach(addTriangles);
  data.Budget.AddPass(IsFirstPass(act), triangles, seconds);
}

void vtkAdaptiveRefinementMapper::RenderRefined(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  if (!this->IsComposite())
  {
    data.Blocks.Clear();
    data.NumberOfDrawCalls = 0;
    data.Drawable = false;
    this->Superclass::RenderPiece(ren, act);
    return;
  }
  if (ren->GetRenderWindow()->CheckAbortStatus())
  {
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  data.NumberOfDrawCalls = 0;
  data.Blocks.Update(this, vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)));
  this->UpdateBudget(ren, act);
  data.Blocks.Render(ren, act);
  this->UpdateProgress(1.0);
}

void vtkAdaptiveRefinementMapper::RenderPieceStart(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  data.OnGPU = false;
  const bool meshValid = this->CheckOpenGL(ren) && this->UpdateMesh();
  if (meshValid)
  {
    this->CurrentInput = data.State.GetPreparedInput();
  }
  this->Superclass::RenderPieceStart(ren, act);
  if (!meshValid || !data.UploadValid)
  {
    return;
  }
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  data.Window = window;
  this->UpdateBudget(ren, act);
  data.OnGPU = this->SelectsOnGPU();
  if (!this->UpdateSelection(ren, act))
  {
    return;
  }

  vtkDisplacement* displacement = this->Refinement->GetDisplacement();
  data.Drawable = true;
  if (displacement)
  {
    data.Drawable =
      data.Buffers.UploadHeights(window, displacement->GetHeightMap(), displacement->HasHoles());
  }
  if (data.Drawable && data.OnGPU)
  {
    data.OnGPU = this->SelectOnGPU(ren, act);
    if (!data.OnGPU && !this->UpdateSelection(ren, act))
    {
      data.Drawable = false;
      return;
    }
  }
  if (data.Drawable && !data.OnGPU)
  {
    data.Drawable = data.Buffers.UploadSelection(
      window, data.State.GetSelectionSlot(), data.State.GetSelection());
  }
  if (!data.Drawable)
  {
    vtkErrorMacro("Cannot draw the input: " << data.Buffers.GetError() << ".");
    data.UploadValid = false; // said once, until something changes
    return;
  }
  if (!data.OnGPU)
  {
    data.Patterns.Load(this->Refinement->GetPatternTable(),
      data.State.GetSelection().GetSelection().Groups,
      act->GetProperty()->GetRepresentation() == VTK_WIREFRAME);
  }
  if (!this->UpdateFaceColors(ren))
  {
    vtkErrorMacro(
      "The colours of levels, patterns or tags could not be sent to the graphics card.");
  }
}

bool vtkAdaptiveRefinementMapper::UpdateFaceColors(vtkRenderer* ren)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkScalarsToColors* table = this->GetLevelLookupTable();
  switch (this->RefinementColorMode)
  {
    case COLOR_BY_SCALARS:
      return true;
    case COLOR_BY_METRIC:
      return data.FaceColors.UploadTags(window, data.State.GetMesh(), data.State.GetSelection(),
        this->Refinement->GetLevelOffset() + this->GetLevelOffset(),
        this->Refinement->GetMaximumLevel(), table);
    default:
      return data.FaceColors.UploadPatterns(
        window, this->RefinementColorMode, HasWholeNumbers(this->Refinement), data.Patterns, table);
  }
}

void vtkAdaptiveRefinementMapper::RenderPieceDraw(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::RenderPieceDraw(ren, act);
  if (!this->Internals->Drawable)
  {
    return;
  }
  vtkProperty* property = act->GetProperty();
  this->DrawingSelection = false;
  this->PrimitiveIDOffset = 0; // faces bring their ids along
  this->DrawingVertices = false;
  this->DrawFaces(this->Internals->Faces, ren, act);
  if (AreVerticesDrawn(property, ren->GetSelector()))
  {
    this->DrawingVertices = true;
    this->DrawFaces(this->Internals->Vertices, ren, act);
    this->DrawingVertices = false;
  }
}

void vtkAdaptiveRefinementMapper::RenderPieceFinish(vtkRenderer* ren, vtkActor* act)
{
  this->Internals->Buffers.Deactivate();
  this->Internals->Colors.Deactivate();
  this->Internals->FaceColors.Deactivate();
  this->Superclass::RenderPieceFinish(ren, act);
}

void vtkAdaptiveRefinementMapper::DrawFaces(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow())->GetState();
  int mode = this->GetOpenGLMode(act->GetProperty()->GetRepresentation(), cellBO.PrimitiveType);
  if (this->PointPicking)
  {
    state->vtkglPointSize(this->GetPointPickingPrimitiveSize(cellBO.PrimitiveType));
    mode = GL_POINTS;
  }
  this->UpdateShaders(cellBO, ren, act);
  if (!cellBO.Program)
  {
    return;
  }
  if (mode == GL_LINES && !this->HaveWideLines(ren, act))
  {
    state->vtkglLineWidth(act->GetProperty()->GetLineWidth());
  }
  cellBO.VAO->Bind();
  data.Patterns.GetTriangles()->Bind();

  auto drawGroup = [&](const relevo::PatternGroup& group)
  {
    const auto& range = data.Patterns.GetRange(group);
    // As many instances as it takes, each of as many copies as it takes.
    const int most = mode == GL_TRIANGLES ? range.Copies : 1;
    const int instances = (group.Count + most - 1) / most;
    const int copies = (group.Count + instances - 1) / instances;
    cellBO.Program->SetUniformi("relevoGroupOffset", group.Offset);
    cellBO.Program->SetUniformi("relevoGroupCount", group.Count);
    cellBO.Program->SetUniformi("relevoCopies", copies);
    if (mode == GL_TRIANGLES)
    {
      const size_t first = static_cast<size_t>(range.FirstIndex) +
        (group.Mirrored ? static_cast<size_t>(range.NumberOfIndices) * range.Copies : 0);
      glDrawElementsInstancedBaseVertex(GL_TRIANGLES, copies * range.NumberOfIndices,
        GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(first * sizeof(unsigned short)), instances,
        range.FirstVertex);
    }
    else if (mode == GL_LINES)
    {
      glDrawArraysInstanced(
        GL_LINES, range.FirstLineVertex, range.NumberOfLineVertices, group.Count);
    }
    else
    {
      // Picking is for coarse points: a pattern's corners come first.
      glDrawArraysInstanced(
        GL_POINTS, range.FirstVertex, this->PointPicking ? 3 : range.NumberOfVertices, group.Count);
    }
    ++data.NumberOfDrawCalls;
  };
  if (data.OnGPU)
  {
    this->DrawIndirectly(cellBO, mode);
  }
  else
  {
    for (const relevo::PatternGroup& group : data.State.GetSelection().GetSelection().Groups)
    {
      drawGroup(group);
    }
  }
  data.Patterns.GetTriangles()->Release();
}

void vtkAdaptiveRefinementMapper::DrawIndirectly(vtkOpenGLHelper& cellBO, int mode)
{
  using View = relevo::RefinementComputeView;
  vtkInternals& data = *this->Internals;
  View& view = data.Compute.GetView(data.State.GetSelectionSlot());
  const View::Primitives primitives = mode == GL_TRIANGLES ? View::TRIANGLES
    : mode == GL_LINES                                     ? View::LINES
    : this->PointPicking                                   ? View::CORNERS
                                                           : View::POINTS;
  // VTK's vertex array knows no integers.
  const GLint location =
    glGetAttribLocation(static_cast<GLuint>(cellBO.Program->GetHandle()), "relevoMembers");
  if (location >= 0)
  {
    const GLuint index = static_cast<GLuint>(location);
    glBindBuffer(GL_ARRAY_BUFFER, view.GetMembers(primitives));
    glEnableVertexAttribArray(index);
    glVertexAttribIPointer(index, 2, GL_UNSIGNED_INT, 0, nullptr);
    glVertexAttribDivisor(index, 1);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
  view.Draw(primitives);
  ++data.NumberOfDrawCalls;
}

//------------------------------------------------------------------------------
// Shaders

bool vtkAdaptiveRefinementMapper::IsRefining(const vtkOpenGLHelper* cellBO) const
{
  return cellBO == &this->Internals->Faces || cellBO == &this->Internals->Vertices;
}

relevo::RefinementShaderOptions vtkAdaptiveRefinementMapper::vtkInternals::GetShaderOptions(
  const vtkAdaptiveRefinementMapper* mapper, const vtkOpenGLHelper* cellBO) const
{
  vtkAdaptiveRefinement* recipe = mapper->Refinement;
  relevo::RefinementShaderOptions options;
  this->Buffers.Describe(this->State.GetMesh(), options);
  vtkNew<vtkLinearSurface> linear;
  vtkRefinementSurface* surface = recipe->GetSurface();
  options.SurfaceSource = (surface ? surface : linear.Get())->GetShaderSource();
  vtkDisplacement* displacement = recipe->GetDisplacement();
  options.IsIndirect = this->OnGPU;
  options.HasDisplacement = displacement != nullptr;
  options.AlongNormal = displacement && displacement->IsAlongNormal();
  options.ColorMode = cellBO == &this->Faces ? mapper->RefinementColorMode : COLOR_BY_SCALARS;
  options.HasScalars = this->ColorsValid && options.ColorMode == COLOR_BY_SCALARS;
  return options;
}

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  bool needed = this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
  if (this->IsRefining(&cellBO))
  {
    const std::string key = this->Internals->GetShaderOptions(this, &cellBO).GetKey();
    std::string& last = this->Internals->Programs[&cellBO].ShaderKey;
    needed = needed || key != last;
    last = key;
  }
  return needed;
}

void vtkAdaptiveRefinementMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  if (this->IsRefining(this->LastBoundBO))
  {
    relevo::MarkColors(shaders);
  }
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  if (this->IsRefining(this->LastBoundBO))
  {
    const int mode = this->PointPicking
      ? GL_POINTS
      : this->GetOpenGLMode(
          act->GetProperty()->GetRepresentation(), this->LastBoundBO->PrimitiveType);
    this->Internals->Programs[this->LastBoundBO].Attributes = relevo::RefineShaders(
      this->Internals->GetShaderOptions(this, this->LastBoundBO), mode == GL_LINES, shaders);
  }
}

void vtkAdaptiveRefinementMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  if (!this->IsRefining(&cellBO))
  {
    return;
  }
  vtkInternals& data = *this->Internals;
  vtkInternals::ProgramState& program = data.Programs[&cellBO];
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  const bool lines = !this->PointPicking &&
    this->GetOpenGLMode(act->GetProperty()->GetRepresentation(), cellBO.PrimitiveType) == GL_LINES;
  vtkOpenGLBufferObject* vertices = lines ? data.Patterns.GetLines() : data.Patterns.GetVertices();

  if (program.PatternVertices != vertices ||
    cellBO.AttributeUpdateTime < data.Patterns.GetUploadTime() ||
    cellBO.AttributeUpdateTime < cellBO.ShaderSourceTime ||
    cellBO.AttributeUpdateTime < cellBO.VAO->GetMTime() ||
    cellBO.AttributeUpdateTime < data.UploadTime)
  {
    program.PatternVertices = vertices;
    const int components = 4;
    cellBO.VAO->Bind();
    if (!cellBO.VAO->AddAttributeArray(cellBO.Program, vertices, "relevoPatternVertex", 0,
          components * sizeof(float), VTK_FLOAT, components, false))
    {
      vtkErrorMacro("The pattern's vertices could not be bound.");
    }
    data.Buffers.AliasAttributes(window, this->VBOs, program.Attributes);
    cellBO.AttributeUpdateTime.Modified();
  }
  data.Buffers.Activate(cellBO.Program);
  data.Colors.Activate(cellBO.Program);
  data.FaceColors.Activate(cellBO.Program);
  data.Buffers.SetUniforms(cellBO.Program, this->Refinement);
}

//------------------------------------------------------------------------------
// Selection

void vtkAdaptiveRefinementMapper::UpdateMaximumPointCellIds(vtkRenderer* ren, vtkActor* actor)
{
  this->Superclass::UpdateMaximumPointCellIds(ren, actor);
  ren->GetSelector()->UpdateMaximumCellId(static_cast<vtkIdType>(this->CellCellMap->GetSize()));
}

void vtkAdaptiveRefinementMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* sel, std::vector<unsigned int>& pixeloffsets, vtkProp* prop)
{
  if (this->Internals->Blocks.IsEmpty())
  {
    this->Superclass::ProcessSelectorPixelBuffers(sel, pixeloffsets, prop);
  }
  else
  {
    this->Internals->Blocks.ProcessSelectorPixelBuffers(sel, pixeloffsets, prop);
  }
}

void vtkAdaptiveRefinementMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement.Get() << "\n";
  os << indent << "FrustumCulling: " << (this->FrustumCulling ? "On\n" : "Off\n");
  os << indent << "BackFaceCulling: " << (this->BackFaceCulling ? "On\n" : "Off\n");
  os << indent << "SelectionDevice: " << this->SelectionDevice << "\n";
  os << indent << "RefinementColorMode: " << this->RefinementColorMode << "\n";
  os << indent << "LevelLookupTable: " << this->LevelLookupTable.Get() << "\n";
  os << indent << "TargetNumberOfTriangles: " << this->GetTargetNumberOfTriangles() << "\n";
  os << indent << "UseAllocatedRenderTime: " << (this->UseAllocatedRenderTime ? "On\n" : "Off\n");
  os << indent << "LevelOffset: " << this->GetLevelOffset() << "\n";
  os << indent << "NumberOfCoarseFaces: " << this->GetNumberOfCoarseFaces() << "\n";
  os << indent << "NumberOfDrawnTriangles: " << this->GetNumberOfDrawnTriangles() << "\n";
  os << indent << "NumberOfDrawCalls: " << this->GetNumberOfDrawCalls() << "\n";
  os << indent << "NumberOfSelections: " << this->GetNumberOfSelections() << "\n";
}
