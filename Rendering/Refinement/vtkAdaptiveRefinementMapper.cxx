// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinementMapper.h"

#include "vtkRelevoOpenGL.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkHeightField.h"
#include "vtkInformation.h"
#include "vtkLinearSurface.h"
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
#include "vtkPatternSelection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementBlocks.h"
#include "vtkRefinementColors.h"
#include "vtkRefinementEvaluator.h"
#include "vtkRefinementMesh.h"
#include "vtkRefinementMeshBuffers.h"
#include "vtkRefinementPatternBuffer.h"
#include "vtkRefinementShader.h"
#include "vtkRefinementSurface.h"
#include "vtkRefinementView.h"
#include "vtkRelevoCompatibility.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTimerLog.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <functional>

namespace
{
// Values that decide whether something must be made anew.
using State = std::vector<vtkMTimeType>;

void Append(State& state, const void* pointer)
{
  state.push_back(static_cast<vtkMTimeType>(reinterpret_cast<size_t>(pointer)));
}

void Append(State& state, vtkObject* object, vtkMTimeType time)
{
  Append(state, object);
  state.push_back(time);
}

void Append(State& state, vtkMatrix4x4* matrix)
{
  for (int i = 0; i < 16; ++i)
  {
    static_assert(sizeof(vtkMTimeType) == sizeof(double), "a double's bits fit a time stamp");
    vtkMTimeType bits;
    std::memcpy(&bits, matrix->GetData() + i, sizeof(bits));
    state.push_back(bits);
  }
}

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

struct vtkAdaptiveRefinementMapper::vtkInternals
{
  vtkInternals()
  {
    this->Faces.PrimitiveType = PrimitiveTris;
    this->Vertices.PrimitiveType = PrimitiveVertices;
  }

  // The coarse mesh: CPU side.
  relevo::RefinementMesh Mesh;
  State MeshState;
  bool MeshValid = false;
  vtkTimeStamp MeshTime;
  vtkNew<vtkPolyData> Prepared; // the input, with normals where they had to be computed
  double Bounds[6];
  State BoundsState;

  // Levels.
  relevo::PatternSelection Selection;
  State SelectionState;
  bool SelectionValid = false;
  vtkIdType NumberOfSelections = 0;
  vtkIdType NumberOfTriangles = 0;
  double SelectionTime = 0.0;
  bool HolesCounted = false;

  // GPU side.
  relevo::RefinementMeshBuffers Buffers;
  relevo::RefinementPatternBuffer Patterns;
  relevo::RefinementColors Colors;
  bool ColorsValid = false;
  vtkTimeStamp UploadTime;
  bool UploadValid = false;
  bool InstancesUploaded = false;
  bool ContextChecked = false;
  bool ContextValid = false;
  bool Drawable = false;
  int NumberOfDrawCalls = 0;

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
    this->ExtraAttributes = other->ExtraAttributes;
    this->SetVBOShiftScaleMethod(other->GetVBOShiftScaleMethod());
  }
  this->Superclass::ShallowCopy(mapper);
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
  if (!data.HolesCounted && data.SelectionValid)
  {
    // Fragments over no-data are discarded; what the filter leaves out is counted when asked for.
    data.HolesCounted = true;
    data.NumberOfTriangles -= relevo::CountHoles(data.Mesh, data.Selection, this->Refinement);
  }
  return data.Drawable ? data.NumberOfTriangles : 0;
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
  int sum = 0;
  const auto& groups = this->Internals->Selection.Groups;
  for (size_t i = 0; i < groups.size(); ++i)
  {
    sum += i == 0 || !std::equal(groups[i].Levels, groups[i].Levels + 3, groups[i - 1].Levels);
  }
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfUsedPatterns(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfSelections()
{
  vtkIdType sum = this->Internals->NumberOfSelections;
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfSelections(); });
  return sum;
}

double vtkAdaptiveRefinementMapper::GetSelectionTime()
{
  double sum = this->Internals->SelectionTime;
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetSelectionTime(); });
  return sum;
}

vtkIdType vtkAdaptiveRefinementMapper::GetNumberOfCoarseFaces()
{
  vtkIdType sum = static_cast<vtkIdType>(this->Internals->Mesh.Faces.size());
  this->Internals->Blocks.ForEach(
    [&sum](vtkAdaptiveRefinementMapper* block) { sum += block->GetNumberOfCoarseFaces(); });
  return sum;
}

vtkTypeInt64 vtkAdaptiveRefinementMapper::GetGraphicsMemorySize()
{
  vtkInternals& data = *this->Internals;
  vtkTypeInt64 sum =
    data.Buffers.GetMemorySize() + data.Patterns.GetMemorySize() + data.Colors.GetMemorySize();
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

bool vtkAdaptiveRefinementMapper::UpdateMesh()
{
  vtkInternals& data = *this->Internals;
  vtkPolyData* input = this->GetInput();
  if (!input)
  {
    return false;
  }
  // Only what the prepared mesh depends on: not the displacement's live values.
  State state;
  Append(state, input, input->GetMTime());
  Append(state, this->Refinement);
  if (this->Refinement)
  {
    vtkRefinementSurface* surface = this->Refinement->GetSurface();
    Append(state, surface, surface ? surface->GetMTime() : 0);
    vtkDisplacement* displacement = this->Refinement->GetDisplacement();
    vtkHeightField* heights = displacement ? displacement->GetHeightMap() : nullptr;
    Append(state, displacement, displacement && displacement->IsAlongNormal() ? 1 : 0);
    Append(state, heights, heights ? heights->GetMTime() : 0);
  }
  if (state == data.MeshState)
  {
    return data.MeshValid;
  }
  data.MeshState = state;
  data.MeshValid = false;
  data.MeshTime.Modified();
  data.SelectionState.clear();
  data.Mesh = relevo::RefinementMesh();
  if (!this->Refinement)
  {
    vtkErrorMacro("No recipe: call SetRefinement() with a vtkAdaptiveRefinement.");
    return false;
  }
  vtkDisplacement* displacement = this->Refinement->GetDisplacement();
  if (displacement && !displacement->Update())
  {
    vtkErrorMacro("The displacement's height map could not be read.");
    return false;
  }
  if (!data.Mesh.Build(input, this->Refinement))
  {
    vtkErrorMacro("Cannot refine the input: " << data.Mesh.GetError() << ".");
    return false;
  }
  if (data.Mesh.GetNumberOfDroppedTriangles() > 0)
  {
    vtkWarningMacro(<< data.Mesh.GetNumberOfDroppedTriangles()
                    << " degenerate cells or triangles dropped (two corners at one place, fewer "
                       "than three points, or non-finite coordinates).");
  }
  data.Prepared->ShallowCopy(input);
  if (!data.Mesh.Normals.empty() && !input->GetPointData()->GetNormals())
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(input->GetNumberOfPoints());
    std::copy(data.Mesh.Normals.begin(), data.Mesh.Normals.end(), normals->GetPointer(0));
    data.Prepared->GetPointData()->SetNormals(normals);
  }
  data.MeshValid = true;
  return true;
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
    this->Superclass::ComputeBounds();
    return;
  }
  State state;
  vtkDisplacement* displacement = this->Refinement->GetDisplacement();
  Append(state, displacement, displacement ? displacement->GetMTime() : 0);
  state.push_back(data.MeshTime);
  if (state != data.BoundsState)
  {
    data.BoundsState = state;
    data.Mesh.GetBounds(this->Refinement, data.Bounds);
    vtkBoundingBox box;
    if (vtkMath::AreBoundsInitialized(data.Bounds))
    {
      box.AddBounds(data.Bounds);
    }
    vtkPolyData* input = this->GetInput();
    for (vtkCellArray* cells : { input->GetVerts(), input->GetLines() })
    {
      auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
      for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
      {
        vtkIdType size;
        const vtkIdType* ids;
        iterator->GetCurrentCell(size, ids);
        for (vtkIdType i = 0; i < size; ++i)
        {
          box.AddPoint(input->GetPoint(ids[i]));
        }
      }
    }
    vtkMath::UninitializeBounds(data.Bounds);
    if (box.IsValid())
    {
      box.GetBounds(data.Bounds);
    }
  }
  std::copy_n(data.Bounds, 6, this->Bounds);
}

//------------------------------------------------------------------------------
// Levels

bool vtkAdaptiveRefinementMapper::UpdateSelection(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  vtkPolyData* input = this->GetInput();
  vtkAdaptiveRefinement* recipe = this->Refinement;
  vtkCamera* camera = ren->GetActiveCamera();
  const int* size = ren->GetSize();

  State state;
  vtkDepthTagMetric* metric = recipe->GetMetric();
  Append(state, metric, metric ? metric->GetMTime() : 0);
  state.push_back(data.MeshTime);
  state.push_back(static_cast<vtkMTimeType>(recipe->GetMaximumLevel()));
  // The name of the array is the recipe's own.
  state.push_back(std::hash<std::string>()(recipe->GetDepthTagArrayName()));
  if (relevo::AreDepthTagsViewDependent(recipe, input))
  {
    Append(state, camera, camera->GetMTime());
    state.push_back(static_cast<vtkMTimeType>(size[0]));
    state.push_back(static_cast<vtkMTimeType>(size[1]));
    Append(state, act->GetMatrix());
  }
  if (state == data.SelectionState)
  {
    return data.SelectionValid;
  }
  data.SelectionState = state;
  data.SelectionValid = false;
  data.InstancesUploaded = false;
  data.HolesCounted = false;

  const double start = vtkTimerLog::GetUniversalTime();
  vtkRefinementView view;
  view.Camera = camera;
  view.ModelToWorld = act->GetMatrix();
  std::copy_n(size, 2, view.ViewportSize);
  std::vector<float> tags;
  std::string error;
  if (!relevo::ComputeDepthTags(recipe, input, data.Mesh, view, tags, error))
  {
    vtkErrorMacro("Cannot refine the input: " << error << ".");
    return false;
  }
  data.Selection.Select(data.Mesh, tags, recipe->GetMaximumLevel());
  data.SelectionTime = vtkTimerLog::GetUniversalTime() - start;
  ++data.NumberOfSelections;
  data.NumberOfTriangles = data.Selection.GetNumberOfTriangles(recipe->GetPatternTable());
  data.SelectionValid = true;
  return true;
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
  }
  return data.ContextValid;
}

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  const bool needed = this->Superclass::GetNeedToRebuildBufferObjects(ren, act);
  return needed || this->Internals->UploadTime < this->Internals->MeshTime;
}

void vtkAdaptiveRefinementMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::BuildBufferObjects(ren, act);
  vtkInternals& data = *this->Internals;
  data.UploadTime.Modified();
  data.UploadValid = false;
  vtkOpenGLVertexBufferObject* positions = this->VBOs->GetVBO("vertexMC");
  if (!data.MeshValid || data.Mesh.Faces.empty() || !positions)
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
  std::vector<int> primitives(data.Mesh.Faces.size());
  for (size_t f = 0; f < primitives.size(); ++f)
  {
    primitives[f] = primitiveOfCell[data.Mesh.Faces[f].Cell];
  }
  vtkRefinementSurface* surface = this->Refinement->GetSurface();
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkDataArray* scalars = this->GetScalarsToInterpolate();
  data.ColorsValid =
    scalars && data.Colors.Upload(window, scalars, this->GetLookupTable(), this->ArrayComponent);
  data.UploadValid = data.Buffers.UploadMesh(
    window, data.Mesh, surface ? surface->GetNumberOfEdgePositions() : 0, positions, primitives);
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
  data.Faces.ReleaseGraphicsResources(window);
  data.Vertices.ReleaseGraphicsResources(window);
  data.Programs.clear();
  data.InstancesUploaded = false;
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
  data.Blocks.Render(ren, act);
  this->UpdateProgress(1.0);
}

void vtkAdaptiveRefinementMapper::RenderPieceStart(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const bool meshValid = this->CheckOpenGL(ren) && this->UpdateMesh();
  if (meshValid)
  {
    this->CurrentInput = data.Prepared;
  }
  this->Superclass::RenderPieceStart(ren, act);
  if (!meshValid || !data.UploadValid || !this->UpdateSelection(ren, act))
  {
    return;
  }

  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkDisplacement* displacement = this->Refinement->GetDisplacement();
  data.Drawable = true;
  if (displacement)
  {
    data.Drawable =
      data.Buffers.UploadHeights(window, displacement->GetHeightMap(), displacement->HasHoles());
  }
  if (data.Drawable && !data.InstancesUploaded)
  {
    data.InstancesUploaded = true;
    data.Drawable = data.Buffers.UploadInstances(window, data.Selection.Instances);
  }
  if (!data.Drawable)
  {
    vtkErrorMacro("Cannot draw the input: " << data.Buffers.GetError() << ".");
    data.UploadValid = false; // said once, until something changes
    return;
  }
  data.Patterns.Load(this->Refinement->GetPatternTable(), data.Selection.Groups,
    act->GetProperty()->GetRepresentation() == VTK_WIREFRAME);
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
  for (const relevo::PatternGroup& group : data.Selection.Groups)
  {
    drawGroup(group);
  }
  data.Patterns.GetTriangles()->Release();
}

//------------------------------------------------------------------------------
// Shaders

bool vtkAdaptiveRefinementMapper::IsRefining(const vtkOpenGLHelper* cellBO) const
{
  return cellBO == &this->Internals->Faces || cellBO == &this->Internals->Vertices;
}

namespace
{
relevo::RefinementShaderOptions GetShaderOptions(const relevo::RefinementMesh& mesh,
  const relevo::RefinementMeshBuffers& buffers, bool hasScalars, vtkAdaptiveRefinement* recipe)
{
  relevo::RefinementShaderOptions options;
  buffers.Describe(mesh, options);
  vtkNew<vtkLinearSurface> linear;
  vtkRefinementSurface* surface = recipe->GetSurface();
  options.SurfaceSource = (surface ? surface : linear.Get())->GetShaderSource();
  vtkDisplacement* displacement = recipe->GetDisplacement();
  options.HasScalars = hasScalars;
  options.HasDisplacement = displacement != nullptr;
  options.AlongNormal = displacement && displacement->IsAlongNormal();
  return options;
}
}

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  bool needed = this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
  if (this->IsRefining(&cellBO))
  {
    const std::string key = GetShaderOptions(this->Internals->Mesh, this->Internals->Buffers,
      this->Internals->ColorsValid, this->Refinement)
                              .GetKey();
    std::string& last = this->Internals->Programs[&cellBO].ShaderKey;
    needed = needed || key != last;
    last = key;
  }
  return needed;
}

void vtkAdaptiveRefinementMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  if (this->IsRefining(this->LastBoundBO))
  {
    const int mode = this->PointPicking
      ? GL_POINTS
      : this->GetOpenGLMode(
          act->GetProperty()->GetRepresentation(), this->LastBoundBO->PrimitiveType);
    this->Internals->Programs[this->LastBoundBO].Attributes =
      relevo::RefineShaders(GetShaderOptions(this->Internals->Mesh, this->Internals->Buffers,
                              this->Internals->ColorsValid, this->Refinement),
        mode == GL_LINES, shaders);
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
  os << indent << "NumberOfCoarseFaces: " << this->GetNumberOfCoarseFaces() << "\n";
  os << indent << "NumberOfDrawnTriangles: " << this->GetNumberOfDrawnTriangles() << "\n";
  os << indent << "NumberOfDrawCalls: " << this->GetNumberOfDrawCalls() << "\n";
  os << indent << "NumberOfSelections: " << this->GetNumberOfSelections() << "\n";
}
