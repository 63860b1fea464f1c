// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The coarse mesh on the GPU: when it is uploaded, and what of it.
#include "Actors/UsableArrays.h"
#include "OpenGL/PositionShift.h"
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "Parallel/GlobalSurfaceInfo.h"
#include "vtkAbstractArray.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

namespace
{
// Not when VTK has uploaded the positions: that is later for each actor, though nothing moved.
relevo::Dependencies GetUploadDependencies(
  vtkMTimeType meshTime, vtkMTimeType mapperTime, vtkOpenGLVertexBufferObject* positions)
{
  relevo::Dependencies dependencies = relevo::Dependencies::On(meshTime, mapperTime);
  dependencies.AddObject(positions, static_cast<vtkMTimeType>(positions->GetHandle()));
  if (positions->GetCoordShiftAndScaleEnabled())
  {
    for (int i = 0; i < 3; ++i)
    {
      dependencies.Add(positions->GetShift()[i]);
      dependencies.Add(positions->GetScale()[i]);
    }
  }
  return dependencies;
}

bool FollowsCamera(int shiftScaleMethod)
{
  using Method = vtkOpenGLVertexBufferObject::ShiftScaleMethod;
  return shiftScaleMethod == static_cast<int>(Method::NEAR_PLANE_SHIFT_SCALE) ||
    shiftScaleMethod == static_cast<int>(Method::FOCAL_POINT_SHIFT_SCALE);
}
}

// VTK shifts and scales positions by the box of the mesh. Those of a piece are shifted and scaled
// by the box of the whole, so that other pieces have the same bits at the border.
void vtkAdaptiveRefinementMapper::vtkInternals::BuildBufferObjectsOfPiece(
  vtkAdaptiveRefinementMapper* mapper, vtkRenderer* ren, vtkActor* act)
{
  const relevo::FiniteBox& box = mapper->Internals->State.GetWhole()->PointBox;
  vtkNew<vtkDoubleArray> corners;
  corners->SetNumberOfComponents(3);
  corners->InsertNextTuple(box.Low.data());
  corners->InsertNextTuple(box.High.data());
  const auto method = mapper->ShiftScaleMethod;
  vtkNew<vtkOpenGLVertexBufferObject> whole;
  whole->SetCoordShiftAndScaleMethod(
    static_cast<vtkOpenGLVertexBufferObject::ShiftScaleMethod>(method));
  whole->UpdateShiftScale(corners);

  const bool isShifted = whole->GetCoordShiftAndScaleEnabled();
  relevo::ShiftPositions(mapper->VBOs, mapper->CurrentInput->GetPoints()->GetData(), ren,
    isShifted ? whole->GetShift() : std::vector<double>(3, 0.0),
    isShifted ? whole->GetScale() : std::vector<double>(3, 1.0));
  mapper->ShiftScaleMethod = static_cast<decltype(mapper->ShiftScaleMethod)>(
    vtkOpenGLVertexBufferObject::ShiftScaleMethod::MANUAL_SHIFT_SCALE);
  mapper->vtkBlockAttributesPolyDataMapper::BuildBufferObjects(ren, act);
  mapper->ShiftScaleMethod = method;
}

bool vtkAdaptiveRefinementMapper::GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  const vtkInternals& data = *this->Internals;
  const bool needed = this->Superclass::GetNeedToRebuildBufferObjects(ren, act);
  // With a shift and scale by the camera VTK moves the positions without asking.
  vtkOpenGLVertexBufferObject* positions = this->VBOs->GetVBO("vertexMC");
  const bool moved = data.UploadValid && positions &&
    data.UploadDependencies !=
      GetUploadDependencies(data.State.GetMeshTime(), this->GetBuildMTime(), positions);
  return needed || moved || data.UploadTime < data.State.GetMeshTime();
}

void vtkAdaptiveRefinementMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  // VTK comes here for every actor whose property is another than the last one's, too.
  vtkInternals& data = *this->Internals;
  if (data.State.GetWhole() && this->CurrentInput->GetNumberOfPoints() > 0 &&
    !FollowsCamera(this->ShiftScaleMethod))
  {
    vtkInternals::BuildBufferObjectsOfPiece(this, ren, act);
  }
  else
  {
    this->Superclass::BuildBufferObjects(ren, act);
  }
  data.UploadTime.Modified();
  vtkOpenGLVertexBufferObject* positions = this->VBOs->GetVBO("vertexMC");
  if (!data.State.IsMeshValid() || data.State.GetMesh().Faces.empty() || !positions)
  {
    data.UploadValid = false;
    return;
  }
  vtkPolyData* input = this->CurrentInput;
  vtkCellArray* cells[4] = { input->GetVerts(), input->GetLines(), input->GetPolys(),
    input->GetStrips() };
  this->CellCellMap->Update(cells, act->GetProperty()->GetRepresentation(), input->GetPoints());

  const relevo::Dependencies dependencies =
    GetUploadDependencies(data.State.GetMeshTime(), this->GetBuildMTime(), positions);
  if (!data.UploadValid || dependencies != data.UploadDependencies)
  {
    data.UploadDependencies = dependencies;
    data.UploadValid = this->UploadMesh(ren);
  }
  data.UploadValid = data.UploadValid && this->UploadFaces(ren, act);
  if (!data.UploadValid)
  {
    vtkErrorMacro("Cannot draw the input: " << data.Buffers.GetError() << ".");
  }
}

bool vtkAdaptiveRefinementMapper::UploadMesh(vtkRenderer* ren)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkAbstractArray* scalars = vtkInternals::GetScalarsToInterpolate(this);
  data.Colors.Clear();
  if (scalars &&
    !data.Colors.Upload(window, scalars, this->GetLookupTable(), this->ArrayComponent,
      this->ColorCoordinates != nullptr, this->Refinement->GetNoDataMagnitude()))
  {
    data.Colors.Clear(); // VTK's colours of the coarse points do
  }
  ++data.NumberOfBufferBuilds;
  return data.Buffers.UploadMesh(
    window, data.State.GetMesh(), this->Refinement->GetSurface(), this->VBOs->GetVBO("vertexMC"));
}

bool vtkAdaptiveRefinementMapper::UploadFaces(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const int representation = act->GetProperty()->GetRepresentation();
  if (data.Buffers.UseFaces(representation))
  {
    return true;
  }
  // The ids that VTK would draw cells with: they index its cell textures and its selections.
  const relevo::RefinementMesh& mesh = data.State.GetMesh();
  std::vector<int> primitiveOfCell(static_cast<size_t>(this->CurrentInput->GetNumberOfCells()), 0);
  for (size_t i = this->CellCellMap->GetSize(); i-- > 0;)
  {
    primitiveOfCell[this->CellCellMap->GetValue(i)] = static_cast<int>(i);
  }
  std::vector<int> primitives(mesh.Faces.size());
  for (size_t f = 0; f < primitives.size(); ++f)
  {
    primitives[f] = primitiveOfCell[mesh.Faces[f].Cell];
  }
  return data.Buffers.UploadFaces(
    vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()), mesh, primitives, representation);
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
  if (problem != this->Internals->ColorProblem)
  {
    this->Internals->ColorProblem = problem;
    if (!problem.empty())
    {
      vtkErrorMacro(<< problem << " The surface is drawn without these colours.");
    }
  }
  vtkNew<vtkPolyData> colorless;
  return this->Superclass::MapScalars(problem.empty() ? input : colorless, alpha, cellFlag);
}

vtkAbstractArray* vtkAdaptiveRefinementMapper::vtkInternals::GetScalarsToInterpolate(
  vtkAdaptiveRefinementMapper* mapper)
{
  if (mapper->VBOs->GetNumberOfComponents("scalarColor") == 0 && !mapper->ColorCoordinates)
  {
    return nullptr;
  }
  int cellFlag = 0;
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(mapper->GetInput(),
    mapper->ScalarMode, mapper->ArrayAccessMode, mapper->ArrayId, mapper->ArrayName, cellFlag);
  const bool direct = mapper->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (mapper->ColorMode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(scalars));
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
