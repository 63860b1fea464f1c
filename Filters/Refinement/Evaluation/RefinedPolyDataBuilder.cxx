// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/RefinedPolyDataBuilder.h"

#include "Arrays/CellDataCopy.h"
#include "Arrays/GhostCells.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/PointDataInterpolation.h"
#include "Evaluation/SurfaceFields.h"
#include "Mesh/MicroArrays.h"
#include "Mesh/PatchArrays.h"
#include "Patterns/RefinementPattern.h"
#include "Surfaces/SurfaceFieldShading.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace relevo
{
namespace
{
void MarkPoints(vtkCellArray* cells, std::vector<vtkIdType>& marks)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      marks[static_cast<size_t>(ids[i])] = 0;
    }
  }
}
}

RefinedPolyDataBuilder::RefinedPolyDataBuilder(vtkPolyData* input, RefinementMesh& mesh,
  const PatternSelection& selection, vtkAdaptiveRefinement* recipe, const FaceLoop& forFaces)
  : Input(input)
  , Mesh(mesh)
  , Recipe(recipe)
  , ForFaces(forFaces)
  , Topology(mesh, selection, input->GetNumberOfPoints())
  , Evaluator(mesh, recipe)
{
  if (!mesh.Normals.empty())
  {
    NormalSplits splits(
      mesh, recipe->GetSurface(), this->Evaluator, this->Topology, input->GetNumberOfPoints());
    this->Topology.Split(splits.GetPoints());
    this->Values = splits.TakeValues();
  }
  this->NumberOfPoints = this->Topology.GetNumberOfPoints();
  const HeightValidity validity = GetHoles(recipe->GetDisplacement());
  if (validity.Samples)
  {
    this->Finder = std::make_unique<HoleFinder>(mesh, validity);
  }
}

RefinedPolyDataBuilder::~RefinedPolyDataBuilder() = default;

bool RefinedPolyDataBuilder::Build(vtkPolyData* output)
{
  if (!this->CountTriangles() || !this->BuildTriangles())
  {
    return false;
  }
  // Holes and ghost cells leave unused points. Non-finite points cannot be used.
  const auto isFinite = [](float x) { return std::isfinite(x); };
  const vtkIdType numberOfCells = this->Input->GetNumberOfCells();
  if (this->Finder || numberOfCells == 0 || GhostCells(this->Input).AreAmong(0, numberOfCells) ||
    !std::all_of(this->Mesh.Points.begin(), this->Mesh.Points.end(), isFinite))
  {
    this->NumberUsedPoints();
  }
  if (this->Recipe->GetDisplacement() &&
    this->Input->GetNumberOfVerts() + this->Input->GetNumberOfLines() > 0)
  {
    this->SeparateOtherCells();
  }
  if (!this->BuildPoints(output))
  {
    return false;
  }
  this->BuildCells(output);
  this->BuildCellData(output);
  output->GetFieldData()->PassData(this->Input->GetFieldData());
  PatchArrays::Remove(output);
  RemoveMicroArrays(output);
  return true;
}

bool RefinedPolyDataBuilder::CountTriangles()
{
  const size_t numberOfFaces = this->Mesh.Faces.size();
  this->FirstTriangles.assign(numberOfFaces + 1, 0);
  const bool hasHoles = this->Finder != nullptr;
  this->Holes.resize(hasHoles ? numberOfFaces : 0);
  const bool done = this->ForFaces(hasHoles ? 0.2 : 0.02,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        const int face = static_cast<int>(f);
        const FacePattern& pattern = this->Topology.GetPattern(face);
        vtkIdType count = pattern.Pattern->GetNumberOfTriangles();
        if (hasHoles && this->Finder->MayHave(face))
        {
          this->Holes[f].resize(static_cast<size_t>(count));
          count -= this->Finder->Find(face, pattern, this->Holes[f].data());
        }
        this->FirstTriangles[f + 1] = count;
      }
    });
  for (size_t f = 0; f < numberOfFaces; ++f)
  {
    this->FirstTriangles[f + 1] += this->FirstTriangles[f];
  }
  return done;
}

bool RefinedPolyDataBuilder::BuildTriangles()
{
  this->Connectivity->SetNumberOfValues(3 * this->GetNumberOfTriangles());
  return this->ForFaces(0.2,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> points;
      for (vtkIdType f = begin; f < end; ++f)
      {
        const int face = static_cast<int>(f);
        const RefinementPattern& pattern = *this->Topology.GetPattern(face).Pattern;
        this->Topology.GetPoints(face, points);
        const int second = this->Topology.GetPattern(face).Mirrored ? 2 : 1;
        const unsigned char* holes =
          this->Holes.empty() || this->Holes[f].empty() ? nullptr : this->Holes[f].data();
        vtkIdType* next = this->Connectivity->GetPointer(3 * this->FirstTriangles[f]);
        for (int t = 0; t < pattern.GetNumberOfTriangles(); ++t)
        {
          if (holes && holes[t])
          {
            continue;
          }
          const unsigned int* vertices = &pattern.Triangles[3 * static_cast<size_t>(t)];
          *next++ = points[vertices[0]];
          *next++ = points[vertices[second]];
          *next++ = points[vertices[3 - second]];
        }
      }
    });
}

void RefinedPolyDataBuilder::NumberUsedPoints()
{
  this->NewIds.assign(static_cast<size_t>(this->NumberOfPoints), -1);
  vtkIdType* ids = this->Connectivity->GetPointer(0);
  const vtkIdType numberOfIds = this->Connectivity->GetNumberOfValues();
  for (vtkIdType i = 0; i < numberOfIds; ++i)
  {
    this->NewIds[static_cast<size_t>(ids[i])] = 0;
  }
  const std::vector<vtkIdType> marks = this->MarkPointsOfOtherCells();
  for (size_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i] == 0 && !this->Topology.IsCorner(static_cast<vtkIdType>(i)))
    {
      this->NewIds[i] = 0;
    }
  }
  this->NumberOfPoints = 0;
  for (vtkIdType& id : this->NewIds)
  {
    id = id < 0 ? -1 : this->NumberOfPoints++;
  }
  for (vtkIdType i = 0; i < numberOfIds; ++i)
  {
    ids[i] = this->GetNewId(ids[i]);
  }
  this->ReplaceUnusedOriginals();
}

void RefinedPolyDataBuilder::ReplaceUnusedOriginals()
{
  vtkIdType copy = this->Topology.GetFirstCopy();
  for (const RefinedTopology::PointCopy& point : this->Topology.GetCopies())
  {
    vtkIdType& original = this->NewIds[static_cast<size_t>(point.Original)];
    original = original < 0 ? this->GetNewId(copy) : original;
    ++copy;
  }
}

std::vector<vtkIdType> RefinedPolyDataBuilder::MarkPointsOfOtherCells() const
{
  std::vector<vtkIdType> marks(static_cast<size_t>(this->Input->GetNumberOfPoints()), -1);
  vtkNew<vtkPolyData> own;
  own->ShallowCopy(this->Input);
  EmptyGhosts(this->Input, own);
  MarkPoints(own->GetVerts(), marks);
  MarkPoints(own->GetLines(), marks);
  return marks;
}

void RefinedPolyDataBuilder::SeparateOtherCells()
{
  this->IdsOfOtherCells = this->MarkPointsOfOtherCells();
  for (size_t i = 0; i < this->IdsOfOtherCells.size(); ++i)
  {
    const vtkIdType point = static_cast<vtkIdType>(i);
    if (this->IdsOfOtherCells[i] == 0)
    {
      this->IdsOfOtherCells[i] =
        this->Topology.IsCorner(point) ? this->NumberOfPoints++ : this->GetNewId(point);
    }
  }
}

bool RefinedPolyDataBuilder::BuildPoints(vtkPolyData* output)
{
  const bool isFloat =
    this->Input->GetPoints() && this->Input->GetPoints()->GetDataType() == VTK_FLOAT;
  this->Points->SetDataType(isFloat || !this->Input->GetPoints() ? VTK_FLOAT : VTK_DOUBLE);
  this->Points->SetNumberOfPoints(this->NumberOfPoints);

  vtkNew<vtkPointData> inputData; // interpolated data: all except the normals, which are evaluated
  inputData->ShallowCopy(this->Input->GetPointData());
  if (!this->Mesh.Normals.empty())
  {
    inputData->SetNormals(nullptr);
    inputData->RemoveArray("Normals");
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetNumberOfTuples(this->NumberOfPoints);
  }
  const PointDataInterpolation data(inputData, this->Input->GetNumberOfPoints(),
    output->GetPointData(), this->NumberOfPoints, this->Recipe->GetNoDataMagnitude());
  this->ShortArrays = data.GetShortArrays();
  const SurfaceFields fields(this->Recipe->GetSurface(), this->Input,
    this->Recipe->GetNoDataMagnitude(), output->GetPointData());

  const bool done = this->ForFaces(0.6,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<RefinedPoint> points;
      for (vtkIdType f = begin; f < end; ++f)
      {
        this->BuildFacePoints(static_cast<int>(f), points, data, fields);
      }
    });
  if (data.HasSerialArrays())
  {
    std::vector<RefinedPoint> points;
    for (int face = 0; done && face < this->Topology.GetNumberOfFaces(); ++face)
    {
      this->GetPointsToBuild(face, points);
      data.InterpolateSerial(this->Mesh.Faces[face].Corners, points);
    }
  }
  this->BuildOtherPoints(data);
  this->BuildCopies(output->GetPointData());
  if (!this->Mesh.Normals.empty())
  {
    output->GetPointData()->SetNormals(this->Normals);
  }
  output->SetPoints(this->Points);
  return done;
}

void RefinedPolyDataBuilder::GetPointsToBuild(int face, std::vector<RefinedPoint>& points) const
{
  this->Topology.GetOwnedPoints(face, points);
  if (!this->NewIds.empty())
  {
    for (RefinedPoint& point : points)
    {
      point.Id = this->GetNewId(point.Id);
    }
    points.erase(std::remove_if(points.begin(), points.end(),
                   [](const RefinedPoint& point) { return point.Id < 0; }),
      points.end());
  }
}

// This includes a degenerate edge of a patch.
bool RefinedPolyDataBuilder::IsAtCorner(
  const int corners[3], const RefinedPoint& point, int nearest) const
{
  float weight = 0.0f;
  for (int i = 0; i < 3; ++i)
  {
    const bool isThere =
      this->Mesh.GetMergedPoint(corners[i]) == this->Mesh.GetMergedPoint(corners[nearest]);
    weight += isThere ? point.Weights[i] : 0.0f;
  }
  return weight == 1.0f;
}

void RefinedPolyDataBuilder::BuildFacePoints(int face, std::vector<RefinedPoint>& points,
  const PointDataInterpolation& data, const SurfaceFields& fields)
{
  this->GetPointsToBuild(face, points);
  const int* corners = this->Mesh.Faces[face].Corners;
  vtkRefinementSurface* surface = this->Recipe->GetSurface();
  const bool moved =
    this->Recipe->GetDisplacement() || (surface && !surface->InterpolatesCorners());
  for (const RefinedPoint& point : points)
  {
    NormalSplits::Value value;
    const auto original = static_cast<size_t>(point.Original);
    if (original < this->Values.size() && this->Values[original].IsKnown)
    {
      value = this->Values[original];
    }
    else
    {
      this->Evaluator.Evaluate(face, point.Weights, &value.Position.x, &value.Normal.x);
    }
    double place[3];
    const int nearest = point.GetNearestCorner();
    if (!moved && this->IsAtCorner(corners, point, nearest))
    {
      // Surfaces interpolate the coarse points: keep all their digits. Adding 0 converts -0 to 0,
      // as in evaluated points.
      this->Input->GetPoint(corners[nearest], place);
      for (double& coordinate : place)
      {
        coordinate += 0.0;
      }
    }
    else
    {
      for (int c = 0; c < 3; ++c)
      {
        place[c] = this->Mesh.Origin[c] + value.Position[c];
      }
    }
    this->Points->SetPoint(point.Id, place);
    if (!this->Mesh.Normals.empty())
    {
      this->Normals->SetTypedTuple(point.Id, &value.Normal.x);
    }
  }
  data.Interpolate(corners, points);
  if (!fields.IsEmpty())
  {
    fields.Evaluate(this->Mesh.GetSurfaceFace(face), points);
  }
}

void RefinedPolyDataBuilder::BuildCopies(vtkPointData* data)
{
  vtkIdType copy = this->Topology.GetFirstCopy();
  for (const RefinedTopology::PointCopy& point : this->Topology.GetCopies())
  {
    const vtkIdType id = this->GetNewId(copy++);
    const vtkIdType original = this->GetNewId(point.Original);
    if (id < 0)
    {
      continue;
    }
    for (int a = 0; id != original && a < data->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = data->GetAbstractArray(a);
      array->SetTuple(id, original, array);
    }
    this->Points->SetPoint(id, this->Points->GetPoint(original));
    this->Normals->SetTypedTuple(id, &point.Normal.x);
  }
}

// These are the points of vertices and lines, and unused points. Faces do not move them.
void RefinedPolyDataBuilder::BuildOtherPoints(const PointDataInterpolation& data)
{
  for (vtkIdType i = 0; i < this->Input->GetNumberOfPoints(); ++i)
  {
    const vtkIdType id = this->Topology.IsCorner(i)
      ? (this->IdsOfOtherCells.empty() ? -1 : this->IdsOfOtherCells[static_cast<size_t>(i)])
      : this->GetNewId(i);
    if (id < 0)
    {
      continue;
    }
    this->Points->SetPoint(id, this->Input->GetPoint(i));
    data.Copy(i, id);
    data.CopySerial(i, id);
    if (!this->Mesh.Normals.empty())
    {
      this->Normals->SetTypedTuple(id, &this->Mesh.Normals[3 * static_cast<size_t>(i)]);
    }
  }
}

void RefinedPolyDataBuilder::CopyCells(vtkCellArray* from, vtkIdType firstCell, vtkCellArray* to)
{
  const GhostCells ghosts(this->Input);
  to->AllocateEstimate(from->GetNumberOfCells(), 2);
  auto cells = vtk::TakeSmartPointer(from->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    const vtkIdType cell = firstCell + cells->GetCurrentCellId();
    if (ghosts.Has(cell))
    {
      continue;
    }
    this->OtherCells.push_back(cell);
    cells->GetCurrentCell(size, ids);
    to->InsertNextCell(static_cast<int>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      to->InsertCellPoint(this->IdsOfOtherCells.empty()
          ? this->GetNewId(ids[i])
          : this->IdsOfOtherCells[static_cast<size_t>(ids[i])]);
    }
  }
}

void RefinedPolyDataBuilder::BuildCells(vtkPolyData* output)
{
  if (this->Input->GetNumberOfVerts() > 0)
  {
    vtkNew<vtkCellArray> verts;
    this->CopyCells(this->Input->GetVerts(), 0, verts);
    output->SetVerts(verts);
  }
  if (this->Input->GetNumberOfLines() > 0)
  {
    vtkNew<vtkCellArray> lines;
    this->CopyCells(this->Input->GetLines(), this->Input->GetNumberOfVerts(), lines);
    output->SetLines(lines);
  }
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(this->GetNumberOfTriangles() + 1);
  vtkSMPTools::For(0, this->GetNumberOfTriangles() + 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType* values = offsets->GetPointer(0);
      for (vtkIdType i = begin; i < end; ++i)
      {
        values[i] = 3 * i;
      }
    });
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, this->Connectivity);
  output->SetPolys(polys);
}

void RefinedPolyDataBuilder::BuildCellData(vtkPolyData* output)
{
  // The order of cells is vertices, lines, triangles.
  const vtkIdType others = static_cast<vtkIdType>(this->OtherCells.size());
  const vtkIdType numberOfCells = others + this->GetNumberOfTriangles();
  vtkNew<vtkIdTypeArray> originals;
  originals->SetNumberOfValues(numberOfCells);
  vtkIdType* ids = originals->GetPointer(0);
  std::copy(this->OtherCells.begin(), this->OtherCells.end(), ids);
  for (size_t f = 0; f < this->Mesh.Faces.size(); ++f)
  {
    std::fill(ids + others + this->FirstTriangles[f], ids + others + this->FirstTriangles[f + 1],
      static_cast<vtkIdType>(this->Mesh.Faces[f].Cell));
  }

  // The normals of flat coarse cells are not those of curved refined cells.
  vtkRefinementSurface* surface = this->Recipe->GetSurface();
  const bool keepNormals =
    !this->Recipe->GetDisplacement() && !(surface && surface->NeedsNormals());
  CopyCellData(this->Input, originals, keepNormals, output->GetCellData(), this->ShortArrays);
  this->RefineCellData(output->GetCellData());
}

void RefinedPolyDataBuilder::RefineCellData(vtkCellData* data)
{
  auto shading = dynamic_cast<SurfaceFieldShading*>(this->Recipe->GetSurface());
  struct Field
  {
    vtkSmartPointer<vtkDataArray> Values;
    vtkDataArray* Array;
  };
  std::vector<Field> fields;
  for (int a = 0; shading && a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    const auto values = array ? shading->FindCellValues(this->Input, array) : nullptr;
    if (values)
    {
      fields.push_back({ values, array });
    }
  }
  if (fields.empty())
  {
    return;
  }
  const auto others = static_cast<vtkIdType>(this->OtherCells.size());
  const auto refine = [&](size_t f)
  {
    const FacePattern& facePattern = this->Topology.GetPattern(static_cast<int>(f));
    const RefinementPattern& pattern = *facePattern.Pattern;
    vtkIdType cell = others + this->FirstTriangles[f];
    for (int t = 0; t < pattern.GetNumberOfTriangles(); ++t)
    {
      if (!this->Holes.empty() && !this->Holes[f].empty() && this->Holes[f][t] != 0)
      {
        continue;
      }
      float centre[3] = { 0.0f, 0.0f, 0.0f };
      for (size_t corner = 3 * static_cast<size_t>(t); corner < 3 * static_cast<size_t>(t) + 3;
           ++corner)
      {
        float weights[3];
        facePattern.GetWeights(static_cast<int>(pattern.Triangles[corner]), weights);
        for (int c = 0; c < 3; ++c)
        {
          centre[c] += weights[c] / 3.0f;
        }
      }
      const vtkIdType tuple =
        shading->FindCellTuple(this->Mesh.GetSurfaceFace(static_cast<int>(f)), centre);
      for (const Field& field : fields)
      {
        field.Array->SetTuple(cell, tuple, field.Values);
      }
      ++cell;
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Mesh.Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        refine(static_cast<size_t>(f));
      }
    });
}
}
