// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "vtkRelevoOpenGL.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDisplacement.h"
#include "vtkHardwareSelector.h"
#include "vtkHeightField.h"
#include "vtkInformation.h"
#include "vtkLinearSurface.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementComputeProgram.h"
#include "vtkRefinementSurface.h"
#include "vtkRelevoCompatibility.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>

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

bool vtkAdaptiveRefinementMapper::IsComposite()
{
  return vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)) != nullptr;
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
  ++data.NumberOfBufferBuilds;
  data.UploadValid = data.Buffers.UploadMesh(window, mesh, surface, positions, primitives);
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
  const bool isSlow = seconds > vtkInternals::GetAllocatedTime(ren, act);
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
  data.Budget.AddPass(vtkInternals::IsFirstPass(act), triangles, seconds);
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
      return data.FaceColors.UploadPatterns(window, this->RefinementColorMode,
        vtkInternals::HasWholeNumbers(this->Refinement), data.Patterns, table);
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
    ++this->Internals->NumberOfShaderBuilds;
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
