// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinementFilter.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkArrayListTemplate.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPatternSelection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementEvaluator.h"
#include "vtkRefinementMesh.h"
#include "vtkRefinementPattern.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRefinementSurface.h"
#include "vtkRefinementView.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{
using relevo::EdgeCorners;
using relevo::PatternGroup;
using relevo::PatternSelection;
using relevo::RefinementEvaluator;
using relevo::RefinementFace;
using relevo::RefinementMesh;

constexpr const char* OriginalCellIds = "vtkOriginalCellIds";

// How the faces' patterns share points: the input's points come first, then the points inside each
// edge, then those inside each face.
class RefinedTopology
{
public:
  RefinedTopology(
    RefinementMesh& mesh, const PatternSelection& selection, vtkRefinementPatternTable* table)
    : Mesh(mesh)
  {
    const size_t numberOfFaces = mesh.Faces.size();
    this->Patterns.resize(numberOfFaces);
    this->Codes.resize(numberOfFaces);
    this->Mirrored.resize(numberOfFaces);
    for (const PatternGroup& group : selection.Groups)
    {
      const vtkRefinementPattern& pattern = relevo::GetGroupPattern(table, group);
      for (int i = group.Offset; i < group.Offset + group.Count; ++i)
      {
        const unsigned int face = selection.Instances[i] >> 3;
        this->Patterns[face] = &pattern;
        this->Codes[face] = static_cast<unsigned char>(selection.Instances[i] & 7u);
        this->Mirrored[face] = group.Mirrored ? 1 : 0;
      }
    }
    mesh.BuildEdges();
  }

  // Give ids to all points; returns their number.
  vtkIdType NumberPoints(vtkIdType numberOfInputPoints)
  {
    vtkIdType next = numberOfInputPoints;
    this->EdgePoints.resize(static_cast<size_t>(this->Mesh.GetNumberOfEdges()));
    for (size_t e = 0; e < this->EdgePoints.size(); ++e)
    {
      const int owner = this->Mesh.EdgeOwners[e];
      this->EdgePoints[e] = next;
      next += this->GetSegments(owner / 3, owner % 3) - 1;
    }
    this->FacePoints.resize(this->Mesh.Faces.size());
    for (size_t f = 0; f < this->FacePoints.size(); ++f)
    {
      this->FacePoints[f] = next;
      next += this->Patterns[f]->GetNumberOfVertices() -
        this->Patterns[f]->GetNumberOfBorderVertices();
    }
    this->PointOwners.assign(static_cast<size_t>(numberOfInputPoints), -1);
    for (size_t f = this->Mesh.Faces.size(); f-- > 0;)
    {
      for (int corner : this->Mesh.Faces[f].Corners)
      {
        this->PointOwners[corner] = static_cast<int>(f);
      }
    }
    return next;
  }

  // A pattern vertex on a face: its point, its weights for the sorted corners, and whether this
  // face is the one to evaluate it.
  struct Vertex
  {
    vtkIdType Point;
    float Weights[3];
    bool Owned;
  };

  Vertex GetVertex(int face, int vertex) const
  {
    const vtkRefinementPattern& pattern = *this->Patterns[face];
    Vertex result;
    RefinementEvaluator::PermuteWeights(
      &pattern.Vertices[3 * static_cast<size_t>(vertex)], this->Codes[face], result.Weights);
    const float* w = result.Weights;
    if (vertex < 3)
    {
      const int corner = w[0] > 0.0f ? 0 : (w[1] > 0.0f ? 1 : 2);
      result.Point = this->Mesh.Faces[face].Corners[corner];
      result.Owned = this->PointOwners[result.Point] == face;
    }
    else if (vertex < pattern.GetNumberOfBorderVertices())
    {
      const int edge = w[2] == 0.0f ? 0 : (w[0] == 0.0f ? 1 : 2);
      const int id = this->Mesh.FaceEdges[3 * static_cast<size_t>(face) + edge];
      const long step =
        std::lround(w[EdgeCorners[edge][1]] * static_cast<float>(this->GetSegments(face, edge)));
      result.Point = this->EdgePoints[id] + step - 1;
      result.Owned = this->Mesh.EdgeOwners[id] == 3 * face + edge;
    }
    else
    {
      result.Point = this->FacePoints[face] + vertex - pattern.GetNumberOfBorderVertices();
      result.Owned = true;
    }
    return result;
  }

  const vtkRefinementPattern& GetPattern(int face) const { return *this->Patterns[face]; }
  int GetCode(int face) const { return this->Codes[face]; }
  bool IsMirrored(int face) const { return this->Mirrored[face] != 0; }

private:
  // Segments of a face's edge between sorted corners.
  int GetSegments(int face, int edge) const
  {
    const auto& order = relevo::GetCornerOrder(this->Codes[face]);
    // The pattern's edge i joins its corners i and i + 1 and lacks corner i + 2.
    const int lacking = 3 - order[EdgeCorners[edge][0]] - order[EdgeCorners[edge][1]];
    return this->Patterns[face]->Segments[(lacking + 1) % 3];
  }

  const RefinementMesh& Mesh;
  std::vector<const vtkRefinementPattern*> Patterns;
  std::vector<unsigned char> Codes;
  std::vector<unsigned char> Mirrored;
  std::vector<vtkIdType> EdgePoints;
  std::vector<vtkIdType> FacePoints;
  std::vector<int> PointOwners;
};

// Append an input's vertices or lines under new point ids.
void CopyCells(vtkCellArray* from, vtkCellArray* to, const std::vector<vtkIdType>& newIds)
{
  auto cells = vtk::TakeSmartPointer(from->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    to->InsertNextCell(static_cast<int>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      to->InsertCellPoint(newIds.empty() ? ids[i] : newIds[ids[i]]);
    }
  }
}

void MarkCells(vtkCellArray* cells, std::vector<vtkIdType>& used)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      used[ids[i]] = 0;
    }
  }
}

// Turn marks (0 where used, -1 elsewhere) into consecutive ids; returns their number.
vtkIdType NumberMarked(std::vector<vtkIdType>& marks)
{
  vtkIdType next = 0;
  for (vtkIdType& mark : marks)
  {
    mark = mark < 0 ? -1 : next++;
  }
  return next;
}
}

vtkStandardNewMacro(vtkAdaptiveRefinementFilter);

vtkAdaptiveRefinementFilter::vtkAdaptiveRefinementFilter() = default;
vtkAdaptiveRefinementFilter::~vtkAdaptiveRefinementFilter() = default;

void vtkAdaptiveRefinementFilter::SetRefinement(vtkAdaptiveRefinement* refinement)
{
  if (this->Refinement != refinement)
  {
    this->Refinement = refinement;
    this->Modified();
  }
}

vtkAdaptiveRefinement* vtkAdaptiveRefinementFilter::GetRefinement()
{
  return this->Refinement;
}

void vtkAdaptiveRefinementFilter::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

vtkCamera* vtkAdaptiveRefinementFilter::GetCamera()
{
  return this->Camera;
}

void vtkAdaptiveRefinementFilter::SetModelToWorld(vtkMatrix4x4* matrix)
{
  if (this->ModelToWorld != matrix)
  {
    this->ModelToWorld = matrix;
    this->Modified();
  }
}

vtkMatrix4x4* vtkAdaptiveRefinementFilter::GetModelToWorld()
{
  return this->ModelToWorld;
}

vtkMTimeType vtkAdaptiveRefinementFilter::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* part :
    { static_cast<vtkObject*>(this->Refinement), static_cast<vtkObject*>(this->Camera),
      static_cast<vtkObject*>(this->ModelToWorld) })
  {
    time = part ? std::max(time, part->GetMTime()) : time;
  }
  return time;
}

int vtkAdaptiveRefinementFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkAdaptiveRefinement* recipe = this->Refinement;
  if (!recipe)
  {
    vtkErrorMacro("No recipe: call SetRefinement() with a vtkAdaptiveRefinement.");
    return 0;
  }
  if (recipe->GetDisplacement() && !recipe->GetDisplacement()->Update())
  {
    vtkErrorMacro("The displacement's height map could not be read.");
    return 0;
  }

  RefinementMesh mesh;
  if (!mesh.Build(input, recipe))
  {
    vtkErrorMacro("Cannot refine the input: " << mesh.GetError() << ".");
    return 0;
  }
  if (mesh.GetNumberOfDroppedTriangles() > 0)
  {
    vtkWarningMacro(<< mesh.GetNumberOfDroppedTriangles()
                    << " degenerate cells or triangles dropped (two corners at one place, fewer "
                       "than three points, or non-finite coordinates).");
  }
  std::vector<float> tags;
  std::string error;
  vtkRefinementView view;
  view.Camera = this->Camera;
  view.ModelToWorld = this->ModelToWorld;
  std::copy_n(this->ViewportSize, 2, view.ViewportSize);
  if (input->GetNumberOfPoints() > 0 &&
    !relevo::ComputeDepthTags(recipe, input, mesh, view, tags, error))
  {
    vtkErrorMacro("Cannot refine the input: " << error << ".");
    return 0;
  }
  PatternSelection selection;
  selection.Select(mesh, tags, recipe->GetMaximumLevel());
  this->UpdateProgress(0.1);

  RefinedTopology topology(mesh, selection, recipe->GetPatternTable());
  const RefinementEvaluator evaluator(mesh, recipe);
  const vtkIdType numberOfFaces = static_cast<vtkIdType>(mesh.Faces.size());
  vtkIdType numberOfPoints = topology.NumberPoints(input->GetNumberOfPoints());

  // Work on the faces in parallel, a part at a time so that progress and abort come through.
  double progress = 0.1;
  auto forFaces = [&](double share, const std::function<void(vtkIdType, vtkIdType)>& work)
  {
    constexpr int parts = 10;
    for (int part = 0; part < parts && !this->GetAbortExecute(); ++part)
    {
      vtkSMPTools::For(
        part * numberOfFaces / parts, (part + 1) * numberOfFaces / parts, work);
      progress += share / parts;
      this->UpdateProgress(progress);
    }
  };

  // Triangles per face, less those over no-data.
  std::vector<vtkIdType> faceTriangles(static_cast<size_t>(numberOfFaces) + 1, 0);
  const bool holes = recipe->GetDisplacement() && recipe->GetDisplacement()->HasHoles();
  std::vector<std::vector<unsigned char>> left(
    holes ? static_cast<size_t>(numberOfFaces) : size_t(0));
  forFaces(0.1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        const int face = static_cast<int>(f);
        const vtkRefinementPattern& pattern = topology.GetPattern(face);
        vtkIdType count = pattern.GetNumberOfTriangles();
        if (holes && evaluator.MayHaveHoles(face))
        {
          left[f].resize(static_cast<size_t>(count));
          count -= evaluator.FindHoles(face, topology.GetCode(face), pattern, left[f].data());
        }
        faceTriangles[f + 1] = count;
      }
    });
  for (vtkIdType f = 0; f < numberOfFaces; ++f)
  {
    faceTriangles[f + 1] += faceTriangles[f];
  }
  const vtkIdType numberOfTriangles = faceTriangles.back();

  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(3 * numberOfTriangles);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(numberOfTriangles + 1);
  forFaces(0.2,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> points;
      for (vtkIdType f = begin; f < end; ++f)
      {
        const int face = static_cast<int>(f);
        const vtkRefinementPattern& pattern = topology.GetPattern(face);
        points.resize(static_cast<size_t>(pattern.GetNumberOfVertices()));
        for (size_t v = 0; v < points.size(); ++v)
        {
          points[v] = topology.GetVertex(face, static_cast<int>(v)).Point;
        }
        const bool mirrored = topology.IsMirrored(face);
        vtkIdType* next = connectivity->GetPointer(3 * faceTriangles[f]);
        for (int t = 0; t < pattern.GetNumberOfTriangles(); ++t)
        {
          if (holes && !left[f].empty() && left[f][t])
          {
            continue;
          }
          const unsigned int* v = &pattern.Triangles[3 * static_cast<size_t>(t)];
          *next++ = points[v[0]];
          *next++ = points[v[mirrored ? 2 : 1]];
          *next++ = points[v[mirrored ? 1 : 2]];
        }
      }
    });
  vtkSMPTools::For(0, numberOfTriangles + 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        offsets->SetValue(i, 3 * i);
      }
    });

  // Holes leave points that nothing uses: give new ids to the others.
  std::vector<vtkIdType> newIds;
  if (holes)
  {
    newIds.assign(static_cast<size_t>(numberOfPoints), -1);
    for (vtkIdType i = 0; i < 3 * numberOfTriangles; ++i)
    {
      newIds[connectivity->GetValue(i)] = 0;
    }
    MarkCells(input->GetVerts(), newIds);
    MarkCells(input->GetLines(), newIds);
    numberOfPoints = NumberMarked(newIds);
    for (vtkIdType i = 0; i < 3 * numberOfTriangles; ++i)
    {
      connectivity->SetValue(i, newIds[connectivity->GetValue(i)]);
    }
  }

  // Points and their data.
  vtkNew<vtkPoints> points;
  const bool isFloat = input->GetPoints() && input->GetPoints()->GetDataType() == VTK_FLOAT;
  points->SetDataType(isFloat || !input->GetPoints() ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(numberOfPoints);

  vtkNew<vtkPointData> inputData; // what is interpolated: all but the normals evaluated here
  inputData->ShallowCopy(input->GetPointData());
  vtkPointData* outputData = output->GetPointData();
  vtkSmartPointer<vtkFloatArray> normals;
  if (!mesh.Normals.empty())
  {
    if (vtkDataArray* given = inputData->GetNormals())
    {
      inputData->SetNormals(nullptr);
      for (int a = inputData->GetNumberOfArrays(); a-- > 0;)
      {
        if (inputData->GetAbstractArray(a) == given)
        {
          inputData->RemoveArray(a);
        }
      }
    }
    inputData->RemoveArray("Normals");
    normals = vtkSmartPointer<vtkFloatArray>::New();
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(numberOfPoints);
    normals->Fill(0.0);
  }
  outputData->InterpolateAllocate(inputData, numberOfPoints);
  ArrayList arrays;
  arrays.AddArrays(numberOfPoints, inputData, outputData);
  // Arrays that are not numeric, such as strings, take the nearest corner's value.
  std::vector<std::pair<vtkAbstractArray*, vtkAbstractArray*>> others;
  for (int a = 0; a < outputData->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = outputData->GetAbstractArray(a);
    if (!vtkDataArray::SafeDownCast(array) && array->GetName())
    {
      array->SetNumberOfTuples(numberOfPoints);
      others.emplace_back(inputData->GetAbstractArray(array->GetName()), array);
    }
  }

  const bool displaced = recipe->GetDisplacement() != nullptr;
  auto setPoint = [&](vtkIdType id, int face, const RefinedTopology::Vertex& vertex)
  {
    float position[3];
    float normal[3];
    evaluator.Evaluate(face, vertex.Weights, position, normal);
    double point[3];
    for (int c = 0; c < 3; ++c)
    {
      point[c] = mesh.Origin[c] + position[c];
    }
    points->SetPoint(id, point);
    if (normals)
    {
      normals->SetTypedTuple(id, normal);
    }
  };
  forFaces(0.5,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        const int face = static_cast<int>(f);
        const int* corners = mesh.Faces[f].Corners;
        const vtkIdType ids[3] = { corners[0], corners[1], corners[2] };
        for (int v = 0; v < topology.GetPattern(face).GetNumberOfVertices(); ++v)
        {
          const RefinedTopology::Vertex vertex = topology.GetVertex(face, v);
          const vtkIdType id = newIds.empty() ? vertex.Point : newIds[vertex.Point];
          if (!vertex.Owned || id < 0)
          {
            continue;
          }
          setPoint(id, face, vertex);
          if (v < 3)
          {
            arrays.Copy(vertex.Point, id);
            if (!displaced)
            {
              // Adding zero makes -0 a plain 0, as in evaluated points.
              double point[3];
              input->GetPoint(vertex.Point, point);
              points->SetPoint(id, point[0] + 0.0, point[1] + 0.0, point[2] + 0.0);
            }
          }
          else
          {
            const double weights[3] = { vertex.Weights[0], vertex.Weights[1], vertex.Weights[2] };
            arrays.Interpolate(3, ids, weights, id);
          }
        }
      }
    });
  // Points of no face: those of vertices and lines, and unused ones.
  std::vector<unsigned char> ofFace(static_cast<size_t>(input->GetNumberOfPoints()), 0);
  for (const RefinementFace& face : mesh.Faces)
  {
    for (int corner : face.Corners)
    {
      ofFace[corner] = 1;
    }
  }
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const vtkIdType id = newIds.empty() ? i : newIds[i];
    if (!ofFace[i] && id >= 0)
    {
      points->SetPoint(id, input->GetPoint(i));
      arrays.Copy(i, id);
      if (normals)
      {
        normals->SetTypedTuple(id, &mesh.Normals[3 * static_cast<size_t>(i)]);
      }
    }
  }
  for (auto& pair : others)
  {
    for (int f = 0; f < numberOfFaces; ++f)
    {
      for (int v = 0; v < topology.GetPattern(f).GetNumberOfVertices(); ++v)
      {
        const RefinedTopology::Vertex vertex = topology.GetVertex(f, v);
        const vtkIdType id = newIds.empty() ? vertex.Point : newIds[vertex.Point];
        if (vertex.Owned && id >= 0)
        {
          const auto nearest = std::max_element(vertex.Weights, vertex.Weights + 3);
          pair.second->SetTuple(
            id, mesh.Faces[f].Corners[nearest - vertex.Weights], pair.first);
        }
      }
    }
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      const vtkIdType id = newIds.empty() ? i : newIds[i];
      if (!ofFace[i] && id >= 0)
      {
        pair.second->SetTuple(id, i, pair.first);
      }
    }
  }

  if (normals)
  {
    outputData->SetNormals(normals);
  }
  else if (vtkDataArray* interpolated = outputData->GetNormals())
  {
    vtkSMPTools::For(0, numberOfPoints,
      [&](vtkIdType begin, vtkIdType end)
      {
        double normal[3];
        for (vtkIdType i = begin; i < end; ++i)
        {
          interpolated->GetTuple(i, normal);
          vtkMath::Normalize(normal);
          interpolated->SetTuple(i, normal);
        }
      });
    interpolated->SetName("Normals");
  }
  output->SetPoints(points);

  // Cells and their data: vertices, lines, triangles.
  if (input->GetNumberOfVerts() > 0)
  {
    vtkNew<vtkCellArray> verts;
    CopyCells(input->GetVerts(), verts, newIds);
    output->SetVerts(verts);
  }
  if (input->GetNumberOfLines() > 0)
  {
    vtkNew<vtkCellArray> lines;
    CopyCells(input->GetLines(), lines, newIds);
    output->SetLines(lines);
  }
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, connectivity);
  output->SetPolys(polys);

  const vtkIdType numberOfOthers = input->GetNumberOfVerts() + input->GetNumberOfLines();
  vtkNew<vtkIdTypeArray> originalCells;
  originalCells->SetName(OriginalCellIds);
  originalCells->SetNumberOfValues(numberOfOthers + numberOfTriangles);
  vtkNew<vtkIdList> cells;
  cells->SetNumberOfIds(numberOfOthers + numberOfTriangles);
  auto setOriginal = [&](vtkIdType cell, vtkIdType original)
  {
    originalCells->SetValue(cell, original);
    cells->SetId(cell, original);
  };
  for (vtkIdType i = 0; i < numberOfOthers; ++i)
  {
    setOriginal(i, i);
  }
  for (vtkIdType f = 0; f < numberOfFaces; ++f)
  {
    for (vtkIdType t = faceTriangles[f]; t < faceTriangles[f + 1]; ++t)
    {
      setOriginal(numberOfOthers + t, mesh.Faces[f].Cell);
    }
  }
  vtkCellData* outputCells = output->GetCellData();
  outputCells->CopyAllOn();
  outputCells->CopyAllocate(input->GetCellData(), cells->GetNumberOfIds());
  if (input->GetCellData()->GetNumberOfArrays() > 0 && cells->GetNumberOfIds() > 0)
  {
    outputCells->CopyData(input->GetCellData(), cells, 0);
  }
  outputCells->RemoveArray(OriginalCellIds);
  outputCells->AddArray(originalCells);
  // Normals of flat coarse cells are not those of what they were refined to.
  if (displaced || (recipe->GetSurface() && recipe->GetSurface()->NeedsNormals()))
  {
    outputCells->SetNormals(nullptr);
  }
  output->GetFieldData()->PassData(input->GetFieldData());

  if (this->GetAbortExecute())
  {
    output->Initialize();
  }
  this->UpdateProgress(1.0);
  return 1;
}

void vtkAdaptiveRefinementFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Refinement: " << this->Refinement.Get() << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ModelToWorld: " << this->ModelToWorld.Get() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n";
}
