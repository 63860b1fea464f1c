// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks/MemoryGuard.h"
#include "Composite/BlockAttributes.h"
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "OpenGL/ContextFacts.h"
#include "OpenGL/RelevoOpenGL.h"

#include "Compatibility/VTKCompatibility.h"
#include "Compute/RefinementComputeProgram.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDataObject.h"
#include "vtkDisplacement.h"
#include "vtkHardwareSelector.h"
#include "vtkHeightField.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

#include <algorithm>

vtkStandardNewMacro(vtkAdaptiveRefinementMapper);

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
  data.Buffers.ReleaseGraphicsResources(window);
  data.Patterns.ReleaseGraphicsResources();
  data.Instances.ReleaseGraphicsResources(window);
  for (auto& method : data.Methods)
  {
    method.second->ReleaseGraphicsResources(window);
  }
  data.MethodProblem.clear();
  data.HeightProblem.clear();
  data.FaceColorsValid = true;
  data.SelectionProblem.clear();
  data.FailedSelection.Clear();
  data.FailedUploads.clear();
  data.Failure = {};
  data.ShaderProblem.clear();
  data.ReleaseLooks(window);
  data.Colors.ReleaseGraphicsResources(window);
  data.Clock.ReleaseGraphicsResources();
  data.Compute.ReleaseGraphicsResources();
  data.FaceColors.ReleaseGraphicsResources(window);
  if (data.OnGPU)
  {
    data.State.ForgetLevels(); // what a metric gave for the GPU may be gone
  }
  for (vtkOpenGLHelper* helper : data.Helpers)
  {
    helper->ReleaseGraphicsResources(window);
  }
  data.Programs.clear();
  data.UploadValid = false;
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
  this->FollowLook(ren, act);
  if (!meshValid || !data.UploadValid)
  {
    return;
  }
  this->ChooseMethod(ren, act);
  this->UpdateBudget(ren, act);
  data.OnGPU = this->SelectsOnGPU();
  if (!this->UpdateSelection(ren, act) || !this->UploadHeights())
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
  data.Drawable = this->UploadMethod();
  if (data.Drawable)
  {
    this->UpdateFaceColors();
  }
}

bool vtkAdaptiveRefinementMapper::UploadHeights()
{
  vtkInternals& data = *this->Internals;
  const bool valid =
    data.Buffers.UploadHeights(data.GetWindow(), this->Refinement->GetDisplacement());
  const std::string problem = valid ? "" : data.Buffers.GetError();
  if (problem != data.HeightProblem)
  {
    data.HeightProblem = problem;
    if (!valid)
    {
      vtkErrorMacro("Cannot draw the input: " << problem << ".");
    }
  }
  return valid;
}

void vtkAdaptiveRefinementMapper::UpdateFaceColors()
{
  vtkInternals& data = *this->Internals;
  vtkScalarsToColors* table = this->GetLevelLookupTable();
  if (this->RefinementColorMode == COLOR_BY_SCALARS)
  {
    return;
  }
  const std::string problem = relevo::ColorTable::FindProblem(table, table->GetRange());
  if (!problem.empty())
  {
    if (problem != data.LevelTableProblem)
    {
      vtkErrorMacro("Cannot colour by levels, patterns or tags: " << problem << ".");
    }
    table = data.LevelTable.Get(this->RefinementColorMode,
      vtkInternals::HasWholeNumbers(this->Refinement), this->Refinement->GetMaximumLevel());
  }
  data.LevelTableProblem = problem;
  const bool valid = this->UploadFaceColors(table);
  if (!valid && data.FaceColorsValid)
  {
    vtkErrorMacro("The colours of levels, patterns or tags do not fit on the graphics card: "
      << relevo::BufferTexture::GetTooLarge() << ".");
  }
  data.FaceColorsValid = valid;
}

bool vtkAdaptiveRefinementMapper::UploadFaceColors(vtkScalarsToColors* table)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = data.GetWindow();
  const bool wholeNumbers = vtkInternals::HasWholeNumbers(this->Refinement);
  const relevo::ViewSelection& selection = data.State.GetSelection();
  if (this->RefinementColorMode == COLOR_BY_METRIC)
  {
    return data.FaceColors.UploadTags(window, data.State.GetMesh(), selection,
      this->Refinement->GetLevelOffset() + this->GetLevelOffset(),
      this->Refinement->GetMaximumLevel(), table);
  }
  return data.GetMethod().HasPatterns()
    ? data.FaceColors.UploadPatterns(
        window, this->RefinementColorMode, wholeNumbers, data.Patterns, table)
    : data.FaceColors.UploadFaces(
        window, this->RefinementColorMode, wholeNumbers, selection, table);
}

bool vtkAdaptiveRefinementMapper::vtkInternals::AreVerticesDrawn(
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
  this->DrawFaces(this->Internals->Faces, ren, act);
  if (vtkInternals::AreVerticesDrawn(property, ren->GetSelector()))
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
  if (this->Internals->LacksIds)
  {
    // What other passes have drawn would be found with ids of 0.
    this->Internals->LacksIds = false;
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
