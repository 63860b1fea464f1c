// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinementMapper.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Actors/ActorView.h"
#include "Actors/ShaderVariantKey.h"
#include "Actors/UsableArrays.h"
#include "Blocks/RefinementBlocks.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Compatibility/VTKCompatibility.h"
#include "Composite/BlockAttributes.h"
#include "Evaluation/PatternSelection.h"
#include "Mathematics/SameNumber.h"
#include "OpenGL/ContextWatch.h"
#include "OpenGL/PositionShift.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Parallel/PieceReduction.h"
#include "Parallel/ProcessReduction.h"
#include "Patterns/RefinementPattern.h"
#include "Picking/PickedInput.h"
#include "Picking/PickedInputPipeline.h"
#include "Recipe/RecipeLevels.h"
#include "Shaders/ShaderExtension.h"
#include "Stages/ActorCulling.h"
#include "Stages/BudgetStage.h"
#include "Stages/ContextCheck.h"
#include "Stages/FaceColorStage.h"
#include "Stages/InputCheck.h"
#include "Stages/MethodStage.h"
#include "Stages/ProcessAgreement.h"
#include "Stages/RefinementPrograms.h"
#include "Stages/SelectionStage.h"
#include "Stages/StageResult.h"
#include "Stages/UploadStage.h"
#include "State/RefinementState.h"
#include "View/CullingView.h"
#include "vtkAbstractArray.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDisplacement.h"
#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkAdaptiveRefinementMapper);

namespace
{
// Private code uses the mapper's numbers of methods and colour modes.
using Mapper = vtkAdaptiveRefinementMapper;
using Method = relevo::RefinementMethod;
static_assert(relevo::HaveSameNumber(Mapper::METHOD_ARKFPI, Method::ARKFPI), "ARKFPI");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_ARK, Method::ARK), "ARK");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_DMR, Method::DMR), "DMR");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_SUAPT, Method::SUAPT), "SUAPT");
static_assert(
  relevo::HaveSameNumber(Mapper::METHOD_HARDWARE_TESSELLATION, Method::HARDWARE_TESSELLATION),
  "tessellation");
static_assert(relevo::HaveSameNumber(Mapper::METHOD_UNIFORM, Method::UNIFORM), "uniform");
static_assert(
  relevo::HaveSameNumber(Mapper::SELECTION_DEVICE_AUTOMATIC, relevo::SELECTION_DEVICE_AUTOMATIC),
  "any device");
static_assert(
  relevo::HaveSameNumber(Mapper::SELECTION_DEVICE_CPU, relevo::SELECTION_DEVICE_CPU), "CPU");
static_assert(
  relevo::HaveSameNumber(Mapper::SELECTION_DEVICE_GPU, relevo::SELECTION_DEVICE_GPU), "GPU");
static_assert(
  relevo::HaveSameNumber(Mapper::COLOR_BY_SCALARS, relevo::COLOR_BY_SCALARS), "scalars");
static_assert(relevo::HaveSameNumber(Mapper::COLOR_BY_LEVEL, relevo::COLOR_BY_LEVEL), "level");
static_assert(
  relevo::HaveSameNumber(Mapper::COLOR_BY_PATTERN, relevo::COLOR_BY_PATTERN), "pattern");
static_assert(relevo::HaveSameNumber(Mapper::COLOR_BY_METRIC, relevo::COLOR_BY_METRIC), "metric");

relevo::RefinementMethod::Primitives GetPrimitives(int mode, bool pointPicking)
{
  using Primitives = relevo::RefinementMethod::Primitives;
  return mode == GL_TRIANGLES ? Primitives::TRIANGLES
    : mode == GL_LINES        ? Primitives::LINES
    : pointPicking            ? Primitives::CORNERS
                              : Primitives::POINTS;
}

bool FollowsCamera(int shiftScaleMethod)
{
  using Method = vtkOpenGLVertexBufferObject::ShiftScaleMethod;
  return shiftScaleMethod == static_cast<int>(Method::NEAR_PLANE_SHIFT_SCALE) ||
    shiftScaleMethod == static_cast<int>(Method::FOCAL_POINT_SHIFT_SCALE);
}

}

struct vtkAdaptiveRefinementMapper::vtkInternals
{
  // The stages of a frame.
  vtkNew<relevo::ContextWatch> Context;
  relevo::ContextCheck ContextCheck;
  relevo::InputCheck InputCheck;
  relevo::SelectionStage Selection;
  relevo::UploadStage Upload;
  relevo::MethodStage Methods;
  relevo::FaceColorStage FaceColors;
  relevo::RefinementPrograms Programs{ PrimitiveTris, PrimitiveVertices };
  relevo::PickedInput Picking;
  relevo::RefinementBlocks Blocks;
  relevo::ProcessAgreement Processes;

  relevo::BudgetStage Budget; // shared by all blocks of a composite input
  bool IsBlock = false;

  struct Frame
  {
    bool IsDrawable = false;
    bool HasLines = false; // a wireframe is drawn
    int NumberOfDrawCalls = 0;
  };
  Frame LastFrame;
  std::string ColorError;        // error that was reported last
  bool HasVertexIndices = false; // VTK's indices of visible vertices
  // Shaders depend on the kind of the scalars' colours, not on the colours of the table.
  bool AsksForShaders = false;
  int ColorKind = 0; // in VTK's buffers
  vtkTimeStamp ColorKindTime;

  vtkOpenGLRenderWindow* GetWindow() const { return this->Context->GetContext(); }
  relevo::RefinementState& GetState() { return this->Selection.GetState(); }
  /// Without a recipe, the drawing can be counted, but not uploaded.
  relevo::RefinementDrawing GetDrawing(vtkAdaptiveRefinement* recipe);
  relevo::FaceSums CountTriangles();
};

vtkAdaptiveRefinementMapper::vtkAdaptiveRefinementMapper()
  : Internals(new vtkInternals)
{
  this->Internals->Context->OnRelease = [this](vtkWindow* window)
  { this->ReleaseGraphicsResources(window); };
  this->Internals->Blocks.OnRemove = [this](vtkBlockAttributesPolyDataMapper* block)
  { this->AddCounts(static_cast<vtkAdaptiveRefinementMapper*>(block)); };
  vtkNew<relevo::PickedInputPipeline> pipeline; // VTK's pickers get the drawn surface
  pipeline->Replace = [this](vtkDataObject* input)
  { return this->ReplaceInput(this->ConvertInput(input)); };
  this->SetExecutive(pipeline);
}

vtkAdaptiveRefinementMapper::~vtkAdaptiveRefinementMapper()
{
  // The resources are released here, while virtual calls still reach this class, in the context of
  // the window.
  this->ReleaseGraphicsResources(nullptr);
}

vtkCxxSetSmartPointerMacro(vtkAdaptiveRefinementMapper, Refinement, vtkAdaptiveRefinement);

vtkAdaptiveRefinement* vtkAdaptiveRefinementMapper::GetRefinement()
{
  return this->Refinement;
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
    this->CopySettings(other);
    this->ExtraAttributes = other->ExtraAttributes;
    this->SetVBOShiftScaleMethod(other->GetVBOShiftScaleMethod());
    this->SetCompositeDataDisplayAttributes(other->GetCompositeDataDisplayAttributes());
  }
  if (vtkOpenGLPolyDataMapper* other = vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    this->SetPointIdArrayName(other->GetPointIdArrayName());
    this->SetCompositeIdArrayName(other->GetCompositeIdArrayName());
    this->SetProcessIdArrayName(other->GetProcessIdArrayName());
    this->SetCellIdArrayName(other->GetCellIdArrayName());
  }
  // The superclass's method is not called: VTK 9.1 warns about its own deprecated methods there,
  // and the copy's actor loses its vtkShaderProperty. This call sets VTK's colour mode.
  this->vtkPolyDataMapper::ShallowCopy(mapper);
  if (vtkAdaptiveRefinementMapper* other = vtkAdaptiveRefinementMapper::SafeDownCast(mapper))
  {
    this->SetRefinementColorMode(other->RefinementColorMode);
  }
}

//------------------------------------------------------------------------------
// Context

void vtkAdaptiveRefinementMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& data = *this->Internals;
  if (data.Context->Release())
  {
    return; // a recursive call, in the context that owns the resources
  }
  this->Superclass::ReleaseGraphicsResources(window);
  data.Upload.ReleaseGraphicsResources(window);
  data.Methods.ReleaseGraphicsResources(window);
  data.FaceColors.ReleaseGraphicsResources(window);
  data.Programs.ReleaseGraphicsResources(window);
  data.Selection.ReleaseGraphicsResources();
  data.Budget.ReleaseGraphicsResources();
  data.ContextCheck.Reset();
  this->ForEachBlock(
    [window](vtkAdaptiveRefinementMapper* block) { block->ReleaseGraphicsResources(window); });
}

//------------------------------------------------------------------------------
// Rendering

void vtkAdaptiveRefinementMapper::RenderPiece(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  if (this->IsComposite())
  {
    this->ReleaseMesh(ren);
  }
  // This releases resources in the context of another window. Some windows leave that context
  // current.
  data.Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()));
  data.Picking.GetDetector().AskOther();
  const auto draw = [&]
  {
    relevo::RunWithinMemory(this, "the mesh in this view",
      [&]
      {
        this->RenderRefined(ren, act);
        return true;
      });
  };
  if (data.IsBlock || !this->UseAllocatedRenderTime || ren->GetSelector())
  {
    draw();
  }
  else
  {
    data.Budget.Measure(
      ren, act, draw, [this](bool isSlow) { return this->CountTrianglesOfPass(isSlow); });
  }
}

// The GPU's selection is read back only if the timer shows that the pass is slow.
vtkIdType vtkAdaptiveRefinementMapper::CountTrianglesOfPass(bool isSlow)
{
  vtkIdType triangles = 0;
  this->ForEachPart(
    [&](vtkAdaptiveRefinementMapper* mapper)
    {
      const relevo::SelectionStage& selection = mapper->Internals->Selection;
      if (mapper->IsDrawable() && (isSlow || !selection.IsOnGPU()))
      {
        triangles += selection.IsOnGPU()
          ? mapper->GetNumberOfDrawnTriangles()
          : selection.GetState().GetSelection().GetSelection().GetNumberOfGroupedTriangles();
      }
    });
  return triangles;
}

void vtkAdaptiveRefinementMapper::RenderRefined(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  if (!this->IsComposite())
  {
    data.Blocks.Clear();
    data.Blocks.AreDrawn = false;
    const relevo::BlockAttributes& attributes = this->GetBlockAttributes();
    if (ren->GetSelector() && !(attributes.Visible && attributes.Pickable))
    {
      return; // the statistics of the last frame stay
    }
    data.LastFrame = {};
    data.Selection.SetOnCPU();
    if (this->CheckInputType() && attributes.Visible)
    {
      this->Superclass::RenderPiece(ren, act);
    }
  }
  else
  {
    this->RenderBlocks(ren, act);
  }
}

void vtkAdaptiveRefinementMapper::RenderPieceStart(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  data.Selection.SetOnCPU();
  const bool isContextValid = this->Report(data.ContextCheck.Update(this->SelectionDevice));
  const bool isMeshValid = this->UpdateMesh() && isContextValid;
  this->CurrentInput = data.GetState().GetPreparedInput();
  this->Superclass::RenderPieceStart(ren, act);
  this->UseShaderVariant(ren, act);
  if (!isMeshValid || !data.Upload.IsMeshValid())
  {
    return;
  }
  this->ChooseMethod(ren, act);
  this->UpdateBudget(ren, act);
  const auto culling = this->MakeCullingView(ren, act);
  relevo::RefinementView view = relevo::MakeActorView(ren, act);
  view.IsPart = data.IsBlock;
  const relevo::SelectionStage::Input input = { { this->GetInput(), this->Refinement, view,
                                                  culling.get(), this->HidesBackFaces(ren, act) },
    data.GetWindow(), data.LastFrame.HasLines, this->SelectionDevice,
    data.ContextCheck.CanCompute() && data.Methods.Get().TakesComputeSelection() &&
      this->RefinementColorMode != COLOR_BY_METRIC };
  if (this->Report(data.Selection.Update(input)) &&
    this->Report(
      data.Upload.UploadHeights(data.GetWindow(), this->Refinement->GetDisplacement())) &&
    this->Report(data.Selection.UpdateOnGPU(input, data.Upload)))
  {
    this->UploadSelection();
  }
}

void vtkAdaptiveRefinementMapper::UploadSelection()
{
  vtkInternals& data = *this->Internals;
  data.LastFrame.IsDrawable =
    this->Report(data.Upload.UploadSelection(data.Methods, data.GetDrawing(this->Refinement)));
  if (data.LastFrame.IsDrawable)
  {
    this->UpdateFaceColors();
  }
}

void vtkAdaptiveRefinementMapper::UpdateFaceColors()
{
  vtkInternals& data = *this->Internals;
  this->Report(
    data.FaceColors.Update({ data.GetWindow(), this->RefinementColorMode, this->Refinement,
      this->GetLevelOffset(), &data.GetState().GetMesh(), &data.GetState().GetSelection(),
      data.Methods.Get().HasPatterns() ? &data.Upload.GetPatterns() : nullptr,
      this->GetLevelLookupTable() }));
}

void vtkAdaptiveRefinementMapper::UseShaderVariant(vtkRenderer* ren, vtkActor* act)
{
  relevo::RefinementPrograms& programs = this->Internals->Programs;
  const relevo::Dependencies key = relevo::GetShaderVariantKey(ren, act, this->GetTextures(act));
  if (programs.UsesVariant(key))
  {
    return;
  }
  std::vector<vtkOpenGLHelper*> helpers;
  for (int i = PrimitiveStart; i < PrimitiveEnd; ++i)
  {
    helpers.push_back(&this->Primitives[i]);
    helpers.push_back(&this->SelectionPrimitives[i]);
  }
  using Info = decltype(this->PrimitiveInfo);
  const auto swap = [this](std::shared_ptr<void>& other)
  {
    if (!other)
    {
      other = std::make_shared<Info>();
    }
    std::swap(this->PrimitiveInfo, *static_cast<Info*>(other.get()));
  };
  programs.UseVariant(key, helpers, swap, ren->GetRenderWindow());
}

bool vtkAdaptiveRefinementMapper::AreVerticesDrawn(
  vtkProperty* property, vtkHardwareSelector* selector)
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

void vtkAdaptiveRefinementMapper::RenderPieceDraw(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::RenderPieceDraw(ren, act);
  if (!this->IsDrawable())
  {
    return;
  }
  vtkProperty* property = act->GetProperty();
  this->DrawingSelection = false;
  this->PrimitiveIDOffset = 0; // faces have their own ids
  this->DrawingVertices = false;
  this->DrawFaces(this->Internals->Programs.GetFaces(), ren, act);
  if (AreVerticesDrawn(property, ren->GetSelector()))
  {
    this->DrawingVertices = true;
    this->DrawFaces(this->Internals->Programs.GetVertices(), ren, act);
    this->DrawingVertices = false;
  }
}

void vtkAdaptiveRefinementMapper::RenderPieceFinish(vtkRenderer* ren, vtkActor* act)
{
  this->Internals->Upload.Deactivate();
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
  this->UpdateRefiningShaders(cellBO, ren, act);
  if (!this->IsDrawable() || !data.Programs.Draws(cellBO))
  {
    return;
  }
  if (mode == GL_LINES && !this->HaveWideLines(ren, act))
  {
    state->vtkglLineWidth(act->GetProperty()->GetLineWidth());
  }
  cellBO.VAO->Bind();
  data.LastFrame.NumberOfDrawCalls += data.Methods.Get().Draw(
    data.GetDrawing(this->Refinement), cellBO.Program, GetPrimitives(mode, this->PointPicking));
}

//------------------------------------------------------------------------------
// Messages, mesh and levels

bool vtkAdaptiveRefinementMapper::Report(const relevo::StageResult& result)
{
  result.InvokeEvents(this);
  return result.IsValid;
}

bool vtkAdaptiveRefinementMapper::UpdateMesh()
{
  vtkPolyData* input = this->GetInput();
  return input && this->Report(this->Internals->Selection.UpdateMesh(input, this->Refinement));
}

std::unique_ptr<relevo::CullingView> vtkAdaptiveRefinementMapper::MakeCullingView(
  vtkRenderer* ren, vtkActor* act)
{
  return this->FrustumCulling
    ? relevo::MakeCullingView(ren, act, this->Internals->GetState().GetMesh())
    : nullptr;
}

bool vtkAdaptiveRefinementMapper::HidesBackFaces(vtkRenderer* ren, vtkActor* act)
{
  return !ren->GetSelector() && !act->IsRenderingTranslucentPolygonalGeometry() &&
    this->CanHideBackFaces(act);
}

bool vtkAdaptiveRefinementMapper::CanHideBackFaces(vtkActor* act)
{
  return this->BackFaceCulling && this->Method != METHOD_ARK &&
    this->GetNumberOfClippingPlanes() == 0 && relevo::HidesBackFaces(act) &&
    !this->HasTranslucentPolygonalGeometry() && !relevo::AreTranslucent(this->Colors);
}

void vtkAdaptiveRefinementMapper::UpdateBudget(
  vtkRenderer* ren, vtkActor* act, const relevo::PieceReduction* pieces)
{
  vtkInternals& data = *this->Internals;
  if (data.IsBlock || (data.Processes.IsActive() && !pieces))
  {
    return;
  }
  const bool isBudgeted = data.Budget.Begin({ ren, act, this->UseAllocatedRenderTime, pieces });
  relevo::RefinementView view = relevo::MakeActorView(ren, act);
  view.IsPart = !data.Blocks.IsEmpty();
  std::vector<relevo::LevelBudget::Part> parts;
  const auto addPart = [&](vtkAdaptiveRefinementMapper* mapper)
  {
    relevo::SelectionStage& selection = mapper->Internals->Selection;
    selection.GetState().IsBudgeted = isBudgeted;
    if (isBudgeted && mapper->GetBlockAttributes().Visible && mapper->UpdateMesh())
    {
      const auto culling = mapper->MakeCullingView(ren, act);
      selection.AddBudgetPart({ mapper->GetInput(), this->Refinement, view, culling.get(),
                                mapper->CanHideBackFaces(act) },
        parts);
    }
  };
  if (data.Blocks.IsEmpty())
  {
    addPart(this);
  }
  this->ForEachBlock(addPart);
  const bool isSought = isBudgeted && this->Refinement && (pieces || !parts.empty());
  const double offset = isSought ? data.Budget.FindOffset(parts, this->Refinement, pieces) : 0.0;
  const auto setOffset = [&](vtkAdaptiveRefinementMapper* mapper)
  {
    mapper->Internals->GetState().LevelOffset = offset;
    mapper->Internals->IsBlock = mapper != this;
  };
  setOffset(this);
  this->ForEachBlock(setOffset);
}

void vtkAdaptiveRefinementMapper::ComputeBounds()
{
  vtkInternals& data = *this->Internals;
  if (this->IsComposite())
  {
    this->UpdateBlocks();
    vtkBoundingBox box;
    this->ForEachBlock(
      [&box](vtkAdaptiveRefinementMapper* block)
      {
        if (block->GetBlockAttributes().Visible)
        {
          box.AddBounds(block->GetBounds());
        }
      });
    vtkMath::UninitializeBounds(this->Bounds);
    if (box.IsValid())
    {
      box.GetBounds(this->Bounds);
    }
    return;
  }
  data.Blocks.Clear();
  if (!this->CheckInputType() || !this->UpdateMesh())
  {
    // The bounds of the points are used, because vtkPolyData does not check the point ids of cells.
    vtkPoints* points = this->GetInput() ? this->GetInput()->GetPoints() : nullptr;
    vtkMath::UninitializeBounds(this->Bounds);
    if (points && points->GetNumberOfPoints() > 0)
    {
      points->GetBounds(this->Bounds);
    }
    return;
  }
  data.GetState().GetBounds(this->Refinement, this->Bounds);
}

//------------------------------------------------------------------------------
// Methods

relevo::RefinementDrawing vtkAdaptiveRefinementMapper::vtkInternals::GetDrawing(
  vtkAdaptiveRefinement* recipe)
{
  const relevo::ViewSelection& selection = this->GetState().GetSelection();
  return { this->GetWindow(), &selection.GetMesh(), &selection, this->GetState().GetSelectionSlot(),
    this->Selection.GetComputeView(),
    recipe ? recipe->GetPatternTable()->GetLibrary().get() : nullptr, this->LastFrame.HasLines,
    &this->Upload.GetPatterns(), &this->Upload.GetInstances() };
}

int vtkAdaptiveRefinementMapper::GetMethodInUse()
{
  int method = this->Internals->Methods.GetNumber();
  this->ForEachBlock(
    [&method](vtkAdaptiveRefinementMapper* block) { method = block->GetMethodInUse(); });
  return method;
}

void vtkAdaptiveRefinementMapper::ChooseMethod(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const int representation = act->GetProperty()->GetRepresentation();
  data.LastFrame.HasLines = representation == VTK_WIREFRAME;
  const auto family = relevo::GetPatternFamily(this->Refinement, this->GetInput());
  using Primitives = relevo::MethodStage::Primitives;
  const int mode = this->GetOpenGLMode(representation, data.Programs.GetFaces().PrimitiveType);
  this->Report(data.Methods.Choose(
    { this->Method, family.get(), data.Programs.HasFailed(this->Refinement, act),
      this->PointPicking ? Primitives::CORNERS : GetPrimitives(mode, false),
      AreVerticesDrawn(act->GetProperty(), ren->GetSelector()) }));
  for (int method : data.Methods.ReleaseUnused(ren->GetRenderWindow()))
  {
    data.Programs.ForgetMethod(method);
    if (method != METHOD_ARKFPI) // all other methods fall back to it
    {
      data.Upload.ForgetFailures(method);
    }
  }
}

void vtkAdaptiveRefinementMapper::FallBackToDefaultMethod(vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  data.Programs.SetFailedSources(this->Refinement, act);
  vtkErrorMacro(<< data.Methods.DescribeUnavailable(
                  "its shaders cannot be built: " + data.Methods.Get().GetError()));
  data.Methods.FallBackToDefaultMethod();
  this->UploadSelection();
}

//------------------------------------------------------------------------------
// The coarse mesh on the GPU

// VTK shifts and scales positions by the bounding box of the mesh. A piece uses the box of the
// whole surface, so that positions at its border are bit-identical to those of other pieces.
void vtkAdaptiveRefinementMapper::BuildBufferObjectsOfPiece(vtkRenderer* ren, vtkActor* act)
{
  const relevo::FiniteBox& box = this->Internals->GetState().GetWhole()->PointBox;
  vtkNew<vtkDoubleArray> corners;
  corners->SetNumberOfComponents(3);
  corners->InsertNextTuple(box.Low.data());
  corners->InsertNextTuple(box.High.data());
  const auto method = this->ShiftScaleMethod;
  vtkNew<vtkOpenGLVertexBufferObject> whole;
  whole->SetCoordShiftAndScaleMethod(
    static_cast<vtkOpenGLVertexBufferObject::ShiftScaleMethod>(method));
  whole->UpdateShiftScale(corners);

  const bool isShifted = whole->GetCoordShiftAndScaleEnabled();
  relevo::ShiftPositions(this->VBOs, this->CurrentInput->GetPoints()->GetData(), ren,
    isShifted ? whole->GetShift() : std::vector<double>(3, 0.0),
    isShifted ? whole->GetScale() : std::vector<double>(3, 1.0));
  this->ShiftScaleMethod = static_cast<decltype(this->ShiftScaleMethod)>(
    vtkOpenGLVertexBufferObject::ShiftScaleMethod::MANUAL_SHIFT_SCALE);
  this->Superclass::BuildBufferObjects(ren, act);
  this->ShiftScaleMethod = method;
}

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const bool needed = this->Superclass::GetNeedToRebuildBufferObjects(ren, act);
  return needed ||
    data.Upload.NeedsMesh(
      data.GetState().GetMeshTime(), this->GetMeshBuildMTime(), this->VBOs->GetVBO("vertexMC"));
}

void vtkAdaptiveRefinementMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  // VTK also calls this for each actor whose property differs from that of the last actor.
  vtkInternals& data = *this->Internals;
  vtkPolyData* input = this->CurrentInput;
  if (data.GetState().GetWhole() && input->GetNumberOfPoints() > 0 &&
    !FollowsCamera(this->ShiftScaleMethod))
  {
    this->BuildBufferObjectsOfPiece(ren, act);
  }
  else
  {
    this->Superclass::BuildBufferObjects(ren, act);
  }
  const int kind = this->ColorTextureMap ? -this->ColorTextureMap->GetNumberOfScalarComponents()
    : this->Colors                       ? this->HaveCellScalars + 1
                                         : 0;
  if (data.ColorKind != kind)
  {
    data.ColorKind = kind;
    data.ColorKindTime.Modified();
  }
  const relevo::RefinementMesh* mesh =
    data.GetState().IsMeshValid() ? &data.GetState().GetMesh() : nullptr;
  const int representation = act->GetProperty()->GetRepresentation();
  vtkAbstractArray* scalars = nullptr;
  vtkAbstractArray* cellScalars = nullptr;
  bool areColors = false;
  if (mesh)
  {
    vtkCellArray* cells[4] = { input->GetVerts(), input->GetLines(), input->GetPolys(),
      input->GetStrips() };
    this->CellCellMap->Update(cells, representation, input->GetPoints());
    scalars = this->GetScalarsToInterpolate();
    int cellFlag = 0;
    vtkAbstractArray* any = vtkAbstractMapper::GetAbstractScalars(
      input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
    cellScalars = this->HaveCellScalars && cellFlag == 1 ? any : nullptr;
    areColors = (scalars && this->AreDirectColors(scalars)) ||
      (cellScalars && this->AreDirectColors(cellScalars));
  }
  this->Report(data.Upload.UploadMesh({ vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()),
    mesh, data.GetState().GetMeshTime(), this->GetMeshBuildMTime(), this->GetBuildMTime(),
    this->VBOs->GetVBO("vertexMC"), this->Refinement, input, scalars, cellScalars, areColors,
    (scalars || cellScalars) && !areColors ? this->GetLookupTable() : nullptr, this->ArrayComponent,
    this->ColorCoordinates != nullptr, representation, input->GetNumberOfCells(),
    this->CellCellMap }));
}

vtkUnsignedCharArray* vtkAdaptiveRefinementMapper::MapScalars(
  vtkDataSet* input, double alpha, int& cellFlag)
{
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(
    input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  std::string error;
  if (this->ScalarVisibility && scalars)
  {
    error = relevo::FindMappingError({ input, scalars, cellFlag, this->ColorMode,
      this->ScalarMode == VTK_SCALAR_MODE_USE_FIELD_DATA ? this->FieldDataTupleId : -1 });
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(scalars);
    vtkScalarsToColors* table = numbers ? numbers->GetLookupTable() : nullptr;
    table = table ? table : this->GetLookupTable();
    const std::string unusable = relevo::ColorTable::FindError(
      table, this->UseLookupTableScalarRange ? table->GetRange() : this->ScalarRange);
    if (error.empty() && !unusable.empty())
    {
      error = "Cannot map scalars to colours: " + unusable + ".";
    }
  }
  if (relevo::ShouldReport(this->Internals->ColorError, error))
  {
    vtkErrorMacro(<< error << " The surface is drawn without these colours.");
  }
  vtkNew<vtkPolyData> colorless;
  return this->Superclass::MapScalars(error.empty() ? input : colorless, alpha, cellFlag);
}

// Return the values that colour vertices between coarse points; nullptr for none.
vtkAbstractArray* vtkAdaptiveRefinementMapper::GetScalarsToInterpolate()
{
  if (this->VBOs->GetNumberOfComponents("scalarColor") == 0 && !this->ColorCoordinates)
  {
    return nullptr;
  }
  int cellFlag = 0;
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(this->GetInput(),
    this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  return cellFlag == 0 ? scalars : nullptr;
}

bool vtkAdaptiveRefinementMapper::AreDirectColors(vtkAbstractArray* scalars)
{
  return this->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (this->ColorMode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(scalars));
}

void vtkAdaptiveRefinementMapper::BuildIBO(vtkRenderer* ren, vtkActor* act, vtkPolyData* poly)
{
  // Patterns draw the faces, so VTK needs only the indices of vertices and lines.
  vtkNew<vtkPolyData> others;
  others->ShallowCopy(poly);
  others->SetPolys(nullptr);
  others->SetStrips(nullptr);
  // VTK does not detect a change of the vertices' visibility.
  const bool withVertices = act->GetProperty()->GetVertexVisibility() != 0;
  if (this->Internals->HasVertexIndices != withVertices)
  {
    this->Internals->HasVertexIndices = withVertices;
    this->IBOBuildState.Clear();
  }
  this->Superclass::BuildIBO(ren, act, others);
  if (!withVertices)
  {
    this->Primitives[PrimitiveVertices].IBO->IndexCount = 0;
  }
  // From VTK 9.3 on, the flags of visible edges begin with entries for vertices and lines. They
  // apply to faces, whose shader has its own flags.
  this->EdgeValues.clear();
}

//------------------------------------------------------------------------------
// Shaders of refined faces

vtkOpenGLHelper* vtkAdaptiveRefinementMapper::AddFaceHelper()
{
  return this->Internals->Programs.AddFaceHelper();
}

bool vtkAdaptiveRefinementMapper::IsFaceHelper(const vtkOpenGLHelper* helper) const
{
  return this->Internals->Programs.IsFaceHelper(helper);
}

bool vtkAdaptiveRefinementMapper::IsDrawable() const
{
  return this->Internals->LastFrame.IsDrawable;
}

void vtkAdaptiveRefinementMapper::ExtendShaders(const vtkOpenGLHelper*, relevo::ShaderExtension&)
{
}

void vtkAdaptiveRefinementMapper::UpdateShaderOptions(const vtkOpenGLHelper* cellBO)
{
  vtkInternals& data = *this->Internals;
  relevo::RefinementShaderOptions& options = data.Programs.GetOptions(cellBO);
  options = {};
  data.Upload.FillOptions(data.GetState().GetMesh(), options);
  data.Programs.FillOptions(this->Refinement, options);
  data.Methods.Get().FillOptions(data.GetDrawing(this->Refinement), options);
  options.ColorMode =
    cellBO != &data.Programs.GetVertices() ? this->RefinementColorMode : COLOR_BY_SCALARS;
  options.Extension.HasNormals = options.HasNormals;
  this->ExtendShaders(cellBO, options.Extension);
  if (options.ColorMode == COLOR_BY_SCALARS && !options.Extension.HasOwnColors)
  {
    if (cellBO != &data.Programs.GetVertices())
    {
      options.Field = data.Upload.GetField().GetColoring();
    }
    if (options.Field != relevo::FieldColoring::NONE)
    {
      options.FieldSource = data.Upload.GetField().GetShaderSource();
    }
    else
    {
      options.Scalars = data.Upload.GetColors().GetKind();
      options.HasNoData = data.Upload.GetColors().HasNoData();
    }
  }
  data.Programs.UpdateKey(cellBO);
}

void vtkAdaptiveRefinementMapper::UpdateRefiningShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  this->UpdateShaderOptions(&cellBO);
  if (data.Programs.CanUpdate(cellBO,
        relevo::Dependencies::On(
          act->GetShaderProperty()->GetShaderMTime(), this->GetBuildMTime())))
  {
    this->UpdateShaders(cellBO, ren, act);
    this->Report(data.Programs.CheckUpdated(cellBO));
  }
}

// The texture of the scalars' colours changes with the lookup table, but its format does not.
std::vector<std::pair<vtkTexture*, std::string>> vtkAdaptiveRefinementMapper::GetTextures(
  vtkActor* act)
{
  auto textures = this->Superclass::GetTextures(act);
  if (this->Internals->AsksForShaders && this->ColorTextureMap && !textures.empty())
  {
    textures.erase(textures.begin()); // VTK's own texture is the first one
  }
  return textures;
}

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  data.AsksForShaders = true;
  const bool needed = this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
  data.AsksForShaders = false;
  if (!this->IsFaceHelper(&cellBO))
  {
    return needed;
  }
  return data.Programs.NeedsBuild(cellBO, needed) &&
    !(data.Methods.Get().HasStages() && this->BuildStages(cellBO, ren, act));
}

bool vtkAdaptiveRefinementMapper::BuildStages(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  using Programs = relevo::RefinementPrograms;
  const Programs::Built built = data.Programs.BuildWithStages(
    cellBO, data.Methods.GetNumber(),
    [&](Programs::Shaders& shaders) { this->BuildShaders(shaders, ren, act); },
    [&](Programs::Shaders& shaders)
    { return data.Methods.Get().BuildProgram(data.GetDrawing(this->Refinement), shaders); });
  if (built == Programs::Built::FAILED)
  {
    this->FallBackToDefaultMethod(act);
    this->UpdateShaderOptions(&cellBO);
  }
  return built == Programs::Built::PROGRAM;
}

void vtkAdaptiveRefinementMapper::BuildShaders(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  this->MissingAnchors.clear();
  this->Superclass::BuildShaders(shaders, ren, act);
  this->Report(this->Internals->Programs.Finish(
    this->LastBoundBO, shaders, this->MissingAnchors, ren->GetSelector() != nullptr));
}

void vtkAdaptiveRefinementMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  if (!this->IsFaceHelper(this->LastBoundBO))
  {
    this->Superclass::ReplaceShaderValues(shaders, ren, act);
    return;
  }
  const int mode =
    this->GetOpenGLMode(act->GetProperty()->GetRepresentation(), this->LastBoundBO->PrimitiveType);
  relevo::ShaderPurpose purpose;
  purpose.HasLines = mode == GL_LINES && !this->PointPicking;
  purpose.HasEdges =
    this->DrawingEdges(ren, act) && !act->GetShaderProperty()->HasGeometryShaderCode();
  purpose.HasPointIds = this->LastSelectionState == vtkHardwareSelector::POINT_ID_LOW24 ||
    this->LastSelectionState == vtkHardwareSelector::POINT_ID_HIGH24;
  purpose.HasCellIds = this->LastSelectionState == vtkHardwareSelector::CELL_ID_LOW24 ||
    this->LastSelectionState == vtkHardwareSelector::CELL_ID_HIGH24;
  purpose.HasOwnFragments = relevo::HasOwnFragments(act);
  relevo::RefinementPrograms& programs = this->Internals->Programs;
  programs.Mark(this->LastBoundBO, purpose, shaders, this->MissingAnchors);
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  programs.Refine(this->LastBoundBO, purpose, shaders, this->MissingAnchors);
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 20260726)
// Faces hand their cell ids to the fragments themselves, so that VTK's geometry shader for
// primitive ids is not needed. Compared with the source of VTK after 9.7, but not yet run with it.
bool vtkAdaptiveRefinementMapper::FragmentShaderUsesPrimitiveID(vtkRenderer* ren, vtkActor* act)
{
  return !this->IsFaceHelper(this->LastBoundBO) &&
    this->Superclass::FragmentShaderUsesPrimitiveID(ren, act);
}
#endif

void vtkAdaptiveRefinementMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  if (!this->IsFaceHelper(&cellBO))
  {
    return;
  }
  vtkInternals& data = *this->Internals;
  data.Upload.Activate(vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()), cellBO.Program,
    this->VBOs, data.Programs.GetAttributes(&cellBO), this->Refinement);
  cellBO.AttributeUpdateTime.Modified();
  data.FaceColors.Activate(cellBO.Program);
}

//------------------------------------------------------------------------------
// Blocks of a composite input, with one mapper each

bool vtkAdaptiveRefinementMapper::IsComposite()
{
  return vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)) != nullptr;
}

bool vtkAdaptiveRefinementMapper::CheckInputType()
{
  vtkInternals& data = *this->Internals;
  const bool isValid =
    this->Report(data.InputCheck.Update(this->GetTrueInput(), this->GetInputPortInformation(0)));
  if (!isValid)
  {
    data.LastFrame = {}; // the renderer skips props without bounds
  }
  return isValid;
}

bool vtkAdaptiveRefinementMapper::HasBlocks(bool translucent)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return false;
  }
  // While blocks draw, they belong to the current (sub-)piece.
  const bool isRendering = this->Internals->Blocks.IsRendering();
  if (!isRendering && !this->GetInput())
  {
    this->Update(); // called before the first frame
  }
  bool found = false;
  if (this->IsComposite())
  {
    if (!isRendering)
    {
      this->UpdateBlocks();
    }
    this->ForEachBlock(
      [&](vtkAdaptiveRefinementMapper* block)
      {
        found = found ||
          (block->GetBlockAttributes().Visible &&
            block->HasTranslucentPolygonalGeometry() == translucent);
      });
  }
  return found;
}

bool vtkAdaptiveRefinementMapper::HasOpaqueGeometry()
{
  return this->HasBlocks(false) || (!this->IsComposite() && this->Superclass::HasOpaqueGeometry());
}

bool vtkAdaptiveRefinementMapper::HasTranslucentPolygonalGeometry()
{
  return this->HasBlocks(true) ||
    (!this->IsComposite() &&
      (this->GetBlockAttributes().IsTranslucent() ||
        this->Superclass::HasTranslucentPolygonalGeometry()));
}

void vtkAdaptiveRefinementMapper::RenderBlocks(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
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
  data.Blocks.AreDrawn = true;
  this->UpdateBlocks();
  this->UpdateBudget(ren, act);
  data.Blocks.Render(ren, act, this->DrawsAllBlocks());
  this->UpdateProgress(1.0);
}

void vtkAdaptiveRefinementMapper::ReleaseMesh(vtkRenderer* ren)
{
  vtkInternals& data = *this->Internals;
  if (data.GetState().HasMesh())
  {
    data.GetState().Clear();
    data.LastFrame.IsDrawable = false;
    data.Selection.SetOnCPU();
    this->ReleaseGraphicsResources(ren->GetRenderWindow());
  }
}

void vtkAdaptiveRefinementMapper::UpdateBlocks()
{
  vtkInternals& data = *this->Internals;
  this->CheckInputType();
  const auto setAttributes =
    [](vtkBlockAttributesPolyDataMapper* block, const relevo::BlockAttributes& attributes)
  { static_cast<vtkAdaptiveRefinementMapper*>(block)->SetBlockAttributes(attributes); };
  data.Blocks.Update({ this, vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)),
    [this] { return this->GetMeshBuildMTime(); }, setAttributes });
  if (data.Blocks.SettingsTime != this->MTime)
  {
    data.Blocks.SettingsTime = this->MTime;
    this->ForEachBlock([this](vtkAdaptiveRefinementMapper* block) { block->CopySettings(this); });
  }
}

void vtkAdaptiveRefinementMapper::ForEachBlock(
  const std::function<void(vtkAdaptiveRefinementMapper*)>& work) const
{
  this->Internals->Blocks.ForEach([&work](vtkBlockAttributesPolyDataMapper* block)
    { work(static_cast<vtkAdaptiveRefinementMapper*>(block)); });
}

void vtkAdaptiveRefinementMapper::ForEachPart(
  const std::function<void(vtkAdaptiveRefinementMapper*)>& work)
{
  if (this->Internals->Blocks.AreDrawn)
  {
    this->ForEachBlock(work);
  }
  else
  {
    work(this);
  }
}

void vtkAdaptiveRefinementMapper::AddCounts(vtkAdaptiveRefinementMapper* block)
{
  vtkInternals& data = *this->Internals;
  data.GetState().AddSelections(block->GetNumberOfSelections());
  data.Blocks.NumberOfBufferBuilds += block->GetNumberOfBufferBuilds();
  data.Blocks.NumberOfShaderBuilds += block->GetNumberOfShaderBuilds();
}

//------------------------------------------------------------------------------
// Several processes

void vtkAdaptiveRefinementMapper::AgreeWithProcesses(
  vtkMultiProcessController* controller, vtkRenderer* ren, vtkActor* act)
{
  relevo::ProcessAgreement& processes = this->Internals->Processes;
  if (!processes.SetController(controller) && processes.IsEmpty())
  {
    return;
  }
  const relevo::ProcessAgreement::Parts parts = this->FindParts();
  if (!processes.IsActive() || !this->Refinement)
  {
    processes.Clear(parts);
    return;
  }
  const relevo::ProcessReduction pieces(controller);
  processes.Update(this->Refinement, relevo::MakeActorView(ren, act), parts, pieces);
  this->UpdateBudget(ren, act, &pieces);
}

// The part of this mapper, or those of its blocks.
relevo::ProcessAgreement::Parts vtkAdaptiveRefinementMapper::FindParts()
{
  relevo::ProcessAgreement::Parts parts;
  const auto add = [&parts](unsigned int index, vtkAdaptiveRefinementMapper* mapper)
  {
    parts[index] = { mapper->GetInput(), &mapper->Internals->GetState(),
      [mapper] { return mapper->UpdateMesh(); } };
  };
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return parts;
  }
  this->Update();
  if (this->IsComposite())
  {
    this->UpdateBlocks();
    const relevo::RefinementBlocks& blocks = this->Internals->Blocks;
    for (unsigned int index : blocks.GetFlatIndices())
    {
      add(index, static_cast<vtkAdaptiveRefinementMapper*>(blocks.Find(index)));
    }
  }
  else if (this->GetInput())
  {
    add(0, this);
  }
  return parts;
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
  if (this->Internals->Programs.TakeLackOfIds())
  {
    // Pixels of other passes would be found with ids of 0.
    unsigned char* actors = sel->GetPixelBuffer(vtkHardwareSelector::ACTOR_PASS);
    for (unsigned int pixel : pixeloffsets)
    {
      std::fill_n(actors + pixel, 3, static_cast<unsigned char>(0));
    }
  }
  if (this->Internals->Blocks.IsEmpty())
  {
    this->Superclass::ProcessSelectorPixelBuffers(sel, pixeloffsets, prop);
  }
  else
  {
    this->Internals->Blocks.ProcessSelectorPixelBuffers(sel, pixeloffsets, prop);
  }
}

//------------------------------------------------------------------------------
// Picking

vtkPolyData* vtkAdaptiveRefinementMapper::GetInput()
{
  this->Internals->Picking.GetDetector().AskOther();
  return this->Superclass::GetInput();
}

vtkDataSet* vtkAdaptiveRefinementMapper::GetInputAsDataSet()
{
  return this->GetInput();
}

vtkDataObject* vtkAdaptiveRefinementMapper::GetInputDataObject(int port, int connection)
{
  this->Internals->Picking.GetDetector().AskOther();
  return this->Superclass::GetInputDataObject(port, connection);
}

double* vtkAdaptiveRefinementMapper::GetBounds()
{
  const relevo::OwnBoundsQuestion question(this->Internals->Picking.GetDetector());
  return this->Superclass::GetBounds();
}

void vtkAdaptiveRefinementMapper::GetBounds(double bounds[6])
{
  this->Superclass::GetBounds(bounds);
  this->Internals->Picking.GetDetector().AskBounds();
}

vtkDataObject* vtkAdaptiveRefinementMapper::ReplaceInput(vtkDataObject* input)
{
  using Detector = relevo::PickerDetector;
  relevo::PickedInput& picking = this->Internals->Picking;
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  const Detector::Askers asker = picking.GetDetector().AskInput(composite != nullptr);
  if (asker == Detector::NO_PICKER)
  {
    return input;
  }
  const bool isAsked = asker == Detector::PICKER_OF_PARTS;
  if (!composite)
  {
    vtkPolyData* picked = this->IsPickable() ? this->GetPickedData(isAsked) : picking.GetEmpty();
    return picked ? picked : input;
  }
  const auto getLeaf = [&](unsigned int index) -> vtkPolyData*
  {
    auto* block = static_cast<vtkAdaptiveRefinementMapper*>(this->Internals->Blocks.Find(index));
    return block && block->IsPickable() ? block->GetPickedData(isAsked) : nullptr;
  };
  return picking.GetComposite(composite, getLeaf);
}

bool vtkAdaptiveRefinementMapper::IsPickable()
{
  const relevo::BlockAttributes& attributes = this->GetBlockAttributes();
  return attributes.Visible && attributes.Pickable;
}

vtkPolyData* vtkAdaptiveRefinementMapper::GetPickedData(bool isAsked)
{
  vtkInternals& data = *this->Internals;
  vtkPolyData* input = this->GetInput();
  if (!input)
  {
    return nullptr;
  }
  if (!this->UpdateMesh() || input->GetNumberOfPoints() == 0)
  {
    return data.Picking.GetEmpty(); // nothing is visible
  }
  this->ReadSelection();
  return data.Picking.Get(
    { input, this->Refinement, &data.GetState(), data.Methods.Get().GetDrawnLevels() }, isAsked);
}

//------------------------------------------------------------------------------
// Settings

vtkMTimeType vtkAdaptiveRefinementMapper::GetMTime()
{
  if (this->IsAskedByVTK() && this->Internals->AsksForShaders)
  {
    return std::max(this->GetMeshBuildMTime(), this->Internals->ColorKindTime.GetMTime());
  }
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* part : { static_cast<vtkObject*>(this->Refinement.Get()),
         static_cast<vtkObject*>(this->LevelLookupTable.Get()) })
  {
    time = part && !this->IsAskedByVTK() ? std::max(time, part->GetMTime()) : time;
  }
  return time;
}

void vtkAdaptiveRefinementMapper::CopySettings(vtkAdaptiveRefinementMapper* other)
{
  this->SetRefinement(other->GetRefinement());
  this->SetTargetNumberOfTriangles(other->GetTargetNumberOfTriangles());
  this->SetUseAllocatedRenderTime(other->GetUseAllocatedRenderTime());
  this->SetFrustumCulling(other->GetFrustumCulling());
  this->SetBackFaceCulling(other->GetBackFaceCulling());
  this->SetMethod(other->GetMethod());
  this->SetSelectionDevice(other->GetSelectionDevice());
  this->SetLevelLookupTable(other->LevelLookupTable);
  this->SetRefinementColorMode(other->RefinementColorMode);
}

void vtkAdaptiveRefinementMapper::SetFrustumCulling(bool culling)
{
  this->SetLive(this->FrustumCulling, culling);
}

void vtkAdaptiveRefinementMapper::SetBackFaceCulling(bool culling)
{
  this->SetLive(this->BackFaceCulling, culling);
}

void vtkAdaptiveRefinementMapper::SetMethod(int method)
{
  if (!relevo::CheckChoice(this, "Method", method,
        { "METHOD_ARKFPI", "METHOD_ARK", "METHOD_DMR", "METHOD_SUAPT",
          "METHOD_HARDWARE_TESSELLATION", "METHOD_UNIFORM" }))
  {
    return;
  }
  if (this->Method != method)
  {
    this->Internals->Methods.ForgetError();
    this->Internals->Programs.ForgetFailures();
  }
  this->SetLive(this->Method, method);
}

void vtkAdaptiveRefinementMapper::SetColorMode(int mode)
{
  this->SetColorModeToScalars();
  this->Superclass::SetColorMode(mode);
}

void vtkAdaptiveRefinementMapper::SetRefinementColorMode(RefinementColorModes mode)
{
  this->SetLive(this->RefinementColorMode, mode);
}

void vtkAdaptiveRefinementMapper::SetLevelLookupTable(vtkScalarsToColors* table)
{
  this->SetLive(this->LevelLookupTable, vtkSmartPointer<vtkScalarsToColors>(table));
}

vtkScalarsToColors* vtkAdaptiveRefinementMapper::GetLevelLookupTable()
{
  if (this->LevelLookupTable)
  {
    return this->LevelLookupTable;
  }
  return this->Internals->FaceColors.GetDefaultTable(this->RefinementColorMode, this->Refinement);
}

void vtkAdaptiveRefinementMapper::SetTargetNumberOfTriangles(vtkIdType triangles)
{
  if (relevo::CheckRange<vtkIdType>(this, "TargetNumberOfTriangles", triangles, 0, VTK_ID_MAX))
  {
    this->SetLive(this->Internals->Budget.GetTarget(), triangles);
  }
}

vtkIdType vtkAdaptiveRefinementMapper::GetTargetNumberOfTriangles()
{
  return this->Internals->Budget.GetTarget();
}

void vtkAdaptiveRefinementMapper::SetUseAllocatedRenderTime(bool use)
{
  this->SetLive(this->UseAllocatedRenderTime, use);
}

double vtkAdaptiveRefinementMapper::GetLevelOffset()
{
  return this->Internals->GetState().LevelOffset;
}

void vtkAdaptiveRefinementMapper::SetSelectionDevice(int device)
{
  if (relevo::CheckChoice(this, "SelectionDevice", device,
        { "SELECTION_DEVICE_AUTOMATIC", "SELECTION_DEVICE_CPU", "SELECTION_DEVICE_GPU" }) &&
    this->SelectionDevice != device)
  {
    this->Internals->ContextCheck.Reset();
    this->SetLive(this->SelectionDevice, device);
  }
}

int vtkAdaptiveRefinementMapper::GetSelectionDeviceInUse()
{
  bool onGPU = false;
  this->ForEachPart([&onGPU](vtkAdaptiveRefinementMapper* part)
    { onGPU = onGPU || part->Internals->Selection.IsOnGPU(); });
  return onGPU ? SELECTION_DEVICE_GPU : SELECTION_DEVICE_CPU;
}

//------------------------------------------------------------------------------
// Statistics of the last render

void vtkAdaptiveRefinementMapper::ReadSelection()
{
  vtkInternals& data = *this->Internals;
  data.Selection.ReadBack(data.GetWindow(), data.Upload.GetInstances());
}

vtkIdType vtkAdaptiveRefinementMapper::SumOverParts(
  const std::function<vtkIdType(vtkInternals&)>& count)
{
  vtkIdType sum = 0;
  this->ForEachPart(
    [&](vtkAdaptiveRefinementMapper* part)
    {
      part->ReadSelection();
      sum += part->IsDrawable() ? count(*part->Internals) : 0;
    });
  return sum;
}

relevo::FaceSums vtkAdaptiveRefinementMapper::vtkInternals::CountTriangles()
{
  // This counts the last frame, because the recipe and the input may have changed since.
  relevo::FaceSums sums;
  const bool isCounted = this->Methods.Get().CountTriangles(this->GetDrawing(nullptr), sums);
  return isCounted ? sums : this->GetState().CountTriangles();
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfDrawnTriangles()
{
  return this->SumOverParts([](vtkInternals& part) { return part.CountTriangles().Drawn; });
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCulledTriangles()
{
  return this->SumOverParts([](vtkInternals& part) { return part.CountTriangles().Culled; });
}

int vtkAdaptiveRefinementMapper::GetNumberOfDrawCalls()
{
  int sum = 0;
  this->ForEachPart([&sum](vtkAdaptiveRefinementMapper* part)
    { sum += part->Internals->LastFrame.NumberOfDrawCalls; });
  return sum;
}

int vtkAdaptiveRefinementMapper::GetNumberOfUsedPatterns()
{
  return static_cast<int>(
    this->SumOverParts([](vtkInternals& part) { return part.Selection.CountUsedPatterns(); }));
}

void vtkAdaptiveRefinementMapper::GetPatternCounts(vtkIdTypeArray* counts)
{
  // The numbers of faces and of triangles of the patterns with these segments.
  std::map<std::array<int, 3>, std::array<vtkIdType, 2>, std::greater<>> patterns;
  this->SumOverParts(
    [&](vtkInternals& part)
    {
      const relevo::ViewSelection& selection = part.GetState().GetSelection();
      return selection
        .SumOverFaces(
          [&](int face)
          {
            const unsigned char* hidden = selection.GetHidden();
            if (hidden && hidden[face])
            {
              return 0;
            }
            const relevo::RefinementPattern& pattern =
              *selection.GetSelection().GetFacePattern(face).Pattern;
            std::array<int, 3> segments;
            std::copy_n(pattern.Segments, 3, segments.begin());
            std::sort(segments.begin(), segments.end(), std::greater<>());
            std::array<vtkIdType, 2>& sums = patterns[segments];
            ++sums[0];
            sums[1] += pattern.GetNumberOfTriangles();
            return 1;
          })
        .Drawn;
    });
  counts->Initialize();
  counts->SetNumberOfComponents(5);
  for (const auto& pattern : patterns)
  {
    for (const vtkIdType number :
      { static_cast<vtkIdType>(pattern.first[0]), static_cast<vtkIdType>(pattern.first[1]),
        static_cast<vtkIdType>(pattern.first[2]), pattern.second[0], pattern.second[1] })
    {
      counts->InsertNextValue(number);
    }
  }
}

double vtkAdaptiveRefinementMapper::GetSelectionTime()
{
  double sum = 0.0;
  this->ForEachPart(
    [&sum](vtkAdaptiveRefinementMapper* part) { sum += part->Internals->Selection.GetSeconds(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCoarseFaces()
{
  return this->SumOverParts([](vtkInternals& part)
    { return static_cast<vtkIdType>(part.GetState().GetSelection().GetMesh().Faces.size()); });
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCulledFaces()
{
  return this->SumOverParts(
    [](vtkInternals& part) { return part.GetState().GetSelection().GetNumberOfHiddenFaces(); });
}

//------------------------------------------------------------------------------
// Statistics since the mapper was created

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfSelections()
{
  vtkIdType sum = this->Internals->GetState().GetNumberOfSelections();
  this->ForEachBlock(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfSelections(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfBufferBuilds()
{
  vtkIdType sum =
    this->Internals->Blocks.NumberOfBufferBuilds + this->Internals->Upload.GetNumberOfBuilds();
  this->ForEachBlock(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfBufferBuilds(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfShaderBuilds()
{
  vtkIdType sum =
    this->Internals->Blocks.NumberOfShaderBuilds + this->Internals->Programs.GetNumberOfBuilds();
  this->ForEachBlock(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfShaderBuilds(); });
  return sum;
}

//------------------------------------------------------------------------------

vtkTypeInt64 vtkAdaptiveRefinementMapper::GetGraphicsMemorySize()
{
  vtkInternals& data = *this->Internals;
  vtkTypeInt64 sum = data.Upload.GetMemorySize() + data.FaceColors.GetMemorySize() +
    data.Selection.GetMemorySize() + data.Methods.GetMemorySize();
  for (const char* name :
    { "vertexMC", "normalMC", "scalarColor", "tcoord", "colorTCoord", "tangentMC" })
  {
    if (vtkOpenGLVertexBufferObject* vbo = this->VBOs->GetVBO(name))
    {
      sum += static_cast<vtkTypeInt64>(vbo->GetNumberOfTuples()) * vbo->GetStride();
    }
  }
  this->ForEachBlock(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetGraphicsMemorySize(); });
  return sum;
}

void vtkAdaptiveRefinementMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement.Get() << "\n";
  os << indent << "FrustumCulling: " << (this->FrustumCulling ? "On\n" : "Off\n");
  os << indent << "BackFaceCulling: " << (this->BackFaceCulling ? "On\n" : "Off\n");
  os << indent << "Method: " << relevo::RefinementMethod::GetName(this->Method) << "\n";
  os << indent << "SelectionDevice: " << this->SelectionDevice << "\n";
  os << indent << "RefinementColorMode: " << this->RefinementColorMode << "\n";
  os << indent << "LevelLookupTable: " << this->LevelLookupTable.Get() << "\n";
  os << indent << "TargetNumberOfTriangles: " << this->GetTargetNumberOfTriangles() << "\n";
  os << indent << "UseAllocatedRenderTime: " << (this->UseAllocatedRenderTime ? "On\n" : "Off\n");
  os << indent << "LevelOffset: " << this->GetLevelOffset() << "\n";
  os << indent << "NumberOfCoarseFaces: " << this->GetNumberOfCoarseFaces() << "\n";
  os << indent << "NumberOfDrawnTriangles: " << this->GetNumberOfDrawnTriangles() << "\n";
  os << indent << "NumberOfCulledTriangles: " << this->GetNumberOfCulledTriangles() << "\n";
  os << indent << "NumberOfDrawCalls: " << this->GetNumberOfDrawCalls() << "\n";
  os << indent << "NumberOfSelections: " << this->GetNumberOfSelections() << "\n";
  os << indent << "NumberOfBufferBuilds: " << this->GetNumberOfBufferBuilds() << "\n";
  os << indent << "NumberOfShaderBuilds: " << this->GetNumberOfShaderBuilds() << "\n";
}
