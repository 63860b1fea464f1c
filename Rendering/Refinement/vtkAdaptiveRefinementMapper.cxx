// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Actors/ShaderVariantKey.h"
#include "Actors/UsableArrays.h"
#include "Checks/MemoryGuard.h"
#include "Checks/ShouldReport.h"
#include "Compatibility/VTKCompatibility.h"
#include "Composite/BlockAttributes.h"
#include "Compute/RefinementComputeProgram.h"
#include "Evaluation/PatternSelection.h"
#include "Mathematics/SameNumber.h"
#include "OpenGL/ContextFacts.h"
#include "OpenGL/PositionShift.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Shaders/ShaderExtension.h"
#include "vtkAbstractArray.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDisplacement.h"
#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkHeightField.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRefinementSurface.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkAdaptiveRefinementMapper);

namespace
{
// Private code numbers methods and colour modes as the mapper does.
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

vtkAdaptiveRefinementMapper::vtkAdaptiveRefinementMapper()
  : Internals(new vtkInternals)
{
  this->Internals->Context->OnRelease = [this](vtkWindow* window)
  { this->ReleaseGraphicsResources(window); };
  this->Internals->Blocks.OnRemove = [this](vtkBlockAttributesPolyDataMapper* block)
  { this->Internals->AddCounts(static_cast<vtkAdaptiveRefinementMapper*>(block)); };
  vtkInternals::InitializePicking(this);
}

vtkAdaptiveRefinementMapper::~vtkAdaptiveRefinementMapper()
{
  // While virtual calls still reach this class, and in the context of the window.
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
  // Not the superclass's: VTK 9.1 warns of its own deprecated methods there, and has the copy's
  // actor lose its vtkShaderProperty. Sets VTK's colour mode.
  this->vtkPolyDataMapper::ShallowCopy(mapper);
  if (vtkAdaptiveRefinementMapper* other = vtkAdaptiveRefinementMapper::SafeDownCast(mapper))
  {
    this->SetRefinementColorMode(other->RefinementColorMode);
  }
}

//------------------------------------------------------------------------------
// Context

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
    const bool rgbBuffers = relevo::HasBuffersOfThreeFloats();
    data.ContextValid = instancing && rgbBuffers;
    if (!data.ContextValid)
    {
      vtkErrorMacro("Refinement needs OpenGL 3.3 with ARB_texture_buffer_object_rgb32 (part of "
                    "OpenGL 4.0); this context has OpenGL "
        << major << "." << minor << (rgbBuffers ? " with it" : " without one that works") << " ("
        << relevo::GetOpenGLRenderer() << ").");
    }
    data.ComputeValid = data.ContextValid && this->SelectionDevice != SELECTION_DEVICE_CPU &&
      relevo::RefinementComputeProgram::IsSupported();
    if (this->SelectionDevice == SELECTION_DEVICE_AUTOMATIC)
    {
      data.ComputeValid = data.ComputeValid && relevo::IsHardwareRenderer();
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

void vtkAdaptiveRefinementMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& data = *this->Internals;
  if (data.Context->Release())
  {
    return; // came back to this method, from within the context that the resources belong to
  }
  this->Superclass::ReleaseGraphicsResources(window);
  data.Upload.ReleaseGraphicsResources(window);
  data.Methods.ReleaseGraphicsResources(window);
  data.FaceColors.ReleaseGraphicsResources(window);
  data.Programs.ReleaseGraphicsResources(window);
  data.SelectionProblem.clear();
  data.FailedSelection.Clear();
  data.Clock.ReleaseGraphicsResources();
  data.Compute.ReleaseGraphicsResources();
  if (data.OnGPU)
  {
    data.State.ForgetLevels(); // what a metric gave for the GPU may be gone
  }
  data.ContextChecked = false;
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
  // Releases what is in the context of another window, which some windows leave current then.
  data.Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()));
  data.Picking.Questions.AskOther();
  const auto draw = [&]
  {
    this->RenderRefined(ren, act);
    return true;
  };
  if (data.IsBlock || !this->UseAllocatedRenderTime || ren->GetSelector())
  {
    relevo::RunWithinMemory(this, "the mesh in this view", draw);
    return;
  }
  data.Clock.Start();
  relevo::RunWithinMemory(this, "the mesh in this view", draw);
  const double seconds = data.Clock.Stop();
  // What the GPU selects is read back only where the time does not do.
  const bool isSlow = seconds > vtkInternals::GetAllocatedTime(ren, act);
  vtkIdType triangles = 0;
  const auto addTriangles = [&](vtkAdaptiveRefinementMapper* mapper)
  {
    const vtkInternals& internals = *mapper->Internals;
    if (internals.Drawable && (isSlow || !internals.OnGPU))
    {
      triangles += internals.OnGPU
        ? mapper->GetNumberOfDrawnTriangles()
        : internals.State.GetSelection().GetSelection().GetNumberOfGroupedTriangles();
    }
  };
  this->ForEachPart(addTriangles);
  data.Budget.AddPass(vtkInternals::IsFirstPass(act), triangles, seconds);
}

void vtkAdaptiveRefinementMapper::RenderRefined(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  if (!this->IsComposite())
  {
    data.Blocks.Clear();
    data.DrawsBlocks = false;
    const relevo::BlockAttributes& attributes = this->GetBlockAttributes();
    if (ren->GetSelector() && !(attributes.Visible && attributes.Pickable))
    {
      return; // what is told of the last frame stays
    }
    data.NumberOfDrawCalls = 0;
    data.Drawable = false;
    data.OnGPU = false;
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
  data.OnGPU = false;
  const bool contextValid = this->CheckOpenGL(ren);
  const bool meshValid = this->UpdateMesh() && contextValid;
  this->CurrentInput = data.State.GetPreparedInput();
  this->Superclass::RenderPieceStart(ren, act);
  this->UseShaderVariant(ren, act);
  if (!meshValid || !data.Upload.IsMeshValid())
  {
    return;
  }
  this->ChooseMethod(ren, act);
  this->UpdateBudget(ren, act);
  data.OnGPU = this->SelectsOnGPU();
  if (!this->UpdateSelection(ren, act) ||
    !this->Report(data.Upload.UploadHeights(data.GetWindow(), this->Refinement->GetDisplacement())))
  {
    return;
  }
  if (data.OnGPU)
  {
    data.OnGPU = this->SelectOnGPU(ren, act);
    if (!data.OnGPU && !this->UpdateSelection(ren, act))
    {
      return;
    }
  }
  this->UploadSelection();
}

void vtkAdaptiveRefinementMapper::UploadSelection()
{
  vtkInternals& data = *this->Internals;
  data.Drawable =
    this->Report(data.Upload.UploadSelection(data.Methods, data.GetDrawing(this->Refinement)));
  if (data.Drawable)
  {
    this->UpdateFaceColors();
  }
}

void vtkAdaptiveRefinementMapper::UpdateFaceColors()
{
  vtkInternals& data = *this->Internals;
  this->Report(data.FaceColors.Update({ data.GetWindow(), this->RefinementColorMode,
    this->Refinement, this->GetLevelOffset(), &data.State.GetMesh(), &data.State.GetSelection(),
    data.Methods.Get().HasPatterns() ? &data.Upload.GetPatterns() : nullptr,
    this->GetLevelLookupTable() }));
}

void vtkAdaptiveRefinementMapper::UseShaderVariant(vtkRenderer* ren, vtkActor* act)
{
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
  this->Internals->Programs.UseVariant(
    relevo::GetShaderVariantKey(ren, act, this->GetTextures(act)), helpers, swap,
    ren->GetRenderWindow());
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
  if (!this->Internals->Drawable)
  {
    return;
  }
  vtkProperty* property = act->GetProperty();
  this->DrawingSelection = false;
  this->PrimitiveIDOffset = 0; // faces bring their ids along
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
  if (!data.Drawable || !data.Programs.Draws(cellBO))
  {
    return;
  }
  if (mode == GL_LINES && !this->HaveWideLines(ren, act))
  {
    state->vtkglLineWidth(act->GetProperty()->GetLineWidth());
  }
  cellBO.VAO->Bind();
  data.NumberOfDrawCalls += data.Methods.Get().Draw(
    data.GetDrawing(this->Refinement), cellBO.Program, GetPrimitives(mode, this->PointPicking));
}

//------------------------------------------------------------------------------
// Methods

relevo::RefinementDrawing vtkAdaptiveRefinementMapper::vtkInternals::GetDrawing(
  vtkAdaptiveRefinement* recipe)
{
  const int slot = this->State.GetSelectionSlot();
  return { this->GetWindow(), &this->State.GetSelection().GetMesh(), &this->State.GetSelection(),
    slot, this->OnGPU ? &this->Compute.GetView(slot) : nullptr,
    recipe ? recipe->GetPatternTable()->GetLibrary().get() : nullptr, this->HasLines,
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
  data.HasLines = representation == VTK_WIREFRAME;
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
    if (method != METHOD_ARKFPI) // which all others fall back to
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

// VTK shifts and scales positions by the box of the mesh. Those of a piece are shifted and scaled
// by the box of the whole, so that other pieces have the same bits at the border.
void vtkAdaptiveRefinementMapper::BuildBufferObjectsOfPiece(vtkRenderer* ren, vtkActor* act)
{
  const relevo::FiniteBox& box = this->Internals->State.GetWhole()->PointBox;
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
  const vtkInternals& data = *this->Internals;
  const bool needed = this->Superclass::GetNeedToRebuildBufferObjects(ren, act);
  return needed ||
    data.Upload.NeedsMesh(
      data.State.GetMeshTime(), this->GetBuildMTime(), this->VBOs->GetVBO("vertexMC"));
}

void vtkAdaptiveRefinementMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  // VTK comes here for every actor whose property is another than the last one's, too.
  vtkInternals& data = *this->Internals;
  vtkPolyData* input = this->CurrentInput;
  if (data.State.GetWhole() && input->GetNumberOfPoints() > 0 &&
    !FollowsCamera(this->ShiftScaleMethod))
  {
    this->BuildBufferObjectsOfPiece(ren, act);
  }
  else
  {
    this->Superclass::BuildBufferObjects(ren, act);
  }
  const relevo::RefinementMesh* mesh = data.State.IsMeshValid() ? &data.State.GetMesh() : nullptr;
  const int representation = act->GetProperty()->GetRepresentation();
  vtkAbstractArray* scalars = nullptr;
  if (mesh)
  {
    vtkCellArray* cells[4] = { input->GetVerts(), input->GetLines(), input->GetPolys(),
      input->GetStrips() };
    this->CellCellMap->Update(cells, representation, input->GetPoints());
    scalars = this->GetScalarsToInterpolate();
  }
  this->Report(data.Upload.UploadMesh({ vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()),
    mesh, data.State.GetMeshTime(), this->GetBuildMTime(), this->VBOs->GetVBO("vertexMC"),
    this->Refinement, scalars, scalars ? this->GetLookupTable() : nullptr, this->ArrayComponent,
    this->ColorCoordinates != nullptr, representation, input->GetNumberOfCells(),
    this->CellCellMap }));
}

vtkUnsignedCharArray* vtkAdaptiveRefinementMapper::MapScalars(
  vtkDataSet* input, double alpha, int& cellFlag)
{
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(
    input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  std::string problem;
  if (this->ScalarVisibility && scalars)
  {
    problem = relevo::FindMappingProblem({ input, scalars, cellFlag, this->ColorMode,
      this->ScalarMode == VTK_SCALAR_MODE_USE_FIELD_DATA ? this->FieldDataTupleId : -1 });
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(scalars);
    vtkScalarsToColors* table = numbers ? numbers->GetLookupTable() : nullptr;
    table = table ? table : this->GetLookupTable();
    const std::string unusable = relevo::ColorTable::FindProblem(
      table, this->UseLookupTableScalarRange ? table->GetRange() : this->ScalarRange);
    if (problem.empty() && !unusable.empty())
    {
      problem = "Cannot map scalars to colours: " + unusable + ".";
    }
  }
  if (relevo::ShouldReport(this->Internals->ColorProblem, problem))
  {
    vtkErrorMacro(<< problem << " The surface is drawn without these colours.");
  }
  vtkNew<vtkPolyData> colorless;
  return this->Superclass::MapScalars(problem.empty() ? input : colorless, alpha, cellFlag);
}

// The values that vertices between coarse points are coloured by; nullptr for none.
vtkAbstractArray* vtkAdaptiveRefinementMapper::GetScalarsToInterpolate()
{
  if (this->VBOs->GetNumberOfComponents("scalarColor") == 0 && !this->ColorCoordinates)
  {
    return nullptr;
  }
  int cellFlag = 0;
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(this->GetInput(),
    this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
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
  // VTK does not notice that vertices are to be seen, or no longer.
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
  // From VTK 9.3 on the flags of edges to draw start with places for vertices and lines. They are
  // about faces, whose shader has flags of its own.
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
  return this->Internals->Drawable;
}

void vtkAdaptiveRefinementMapper::ExtendShaders(const vtkOpenGLHelper*, relevo::ShaderExtension&)
{
}

void vtkAdaptiveRefinementMapper::UpdateShaderOptions(const vtkOpenGLHelper* cellBO)
{
  vtkInternals& data = *this->Internals;
  relevo::RefinementShaderOptions& options = data.Programs.GetOptions(cellBO);
  options = {};
  data.Upload.FillOptions(data.State.GetMesh(), options);
  data.Programs.FillOptions(this->Refinement, options);
  data.Methods.Get().FillOptions(data.GetDrawing(this->Refinement), options);
  options.ColorMode =
    cellBO != &data.Programs.GetVertices() ? this->RefinementColorMode : COLOR_BY_SCALARS;
  options.Extension.HasNormals = options.HasNormals;
  this->ExtendShaders(cellBO, options.Extension);
  if (options.ColorMode == COLOR_BY_SCALARS && !options.Extension.HasOwnColors)
  {
    options.Scalars = data.Upload.GetColors().GetKind();
    options.HasNoData = data.Upload.GetColors().HasNoData();
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

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  const bool needed = this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
  if (!this->IsFaceHelper(&cellBO))
  {
    return needed;
  }
  vtkInternals& data = *this->Internals;
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
    // What other passes have drawn would be found with ids of 0.
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
