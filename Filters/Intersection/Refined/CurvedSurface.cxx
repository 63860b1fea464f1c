// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Refined/CurvedSurface.h"

#include "Boxes/FaceTree.h"
#include "Changes/LatestTime.h"
#include "Evaluation/HoleFinder.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/RefinementEvaluator.h"
#include "Evaluation/RefinementPreparation.h"
#include "Mesh/FaceEdges.h"
#include "Mesh/SurfaceEdges.h"
#include "Patterns/RefinementPattern.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPTools.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
/// What triangles depend on. The recipe's metric may change with every frame.
struct CurvedSurface::Sources
{
  Sources(vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
    : Mesh(mesh)
    , Surface(recipe->GetSurface())
    , Displacement(recipe->GetDisplacement())
    , Family(GetRoundedPatternFamily(recipe))
    , MaximumLevel(recipe->GetMaximumLevel())
    , Time(GetLatestTime(mesh->GetMTime(), { this->Surface, this->Displacement }))
    , NumberOfPoints(mesh->GetNumberOfPoints())
    , NumberOfCells(mesh->GetNumberOfCells())
  {
  }
  bool operator==(const Sources& other) const
  {
    return this->Mesh == other.Mesh && this->Surface == other.Surface &&
      this->Displacement == other.Displacement && this->Family == other.Family &&
      this->MaximumLevel == other.MaximumLevel && this->Time == other.Time &&
      this->NumberOfPoints == other.NumberOfPoints && this->NumberOfCells == other.NumberOfCells;
  }

  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkRefinementSurface> Surface;
  vtkSmartPointer<vtkDisplacement> Displacement;
  std::shared_ptr<const PatternFamily> Family;
  int MaximumLevel;
  vtkMTimeType Time;
  // Cells that are inserted do not change a vtkCellArray's time.
  vtkIdType NumberOfPoints;
  vtkIdType NumberOfCells;
};

CurvedSurface::CurvedSurface() = default;
CurvedSurface::~CurvedSurface() = default;

bool CurvedSurface::Take(
  vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, std::string& error, std::string& warning)
{
  if (this->Taken && *this->Taken == Sources(mesh, recipe))
  {
    return true;
  }
  this->Taken.reset();
  this->Triangles = nullptr;
  this->IsMoved = false;
  this->Mesh = RefinementMesh();
  if (!PrepareMesh(mesh, recipe, nullptr, this->Mesh, error, warning))
  {
    return false;
  }
  auto sources = std::make_unique<Sources>(mesh, recipe);
  vtkTimeStamp now;
  now.Modified();
  this->Surface.Update(this->Mesh, now, recipe, nullptr);
  const SurfaceEdges edges(mesh);
  this->Steps.Take(
    this->Mesh, this->Surface, recipe, FindFaceEdges(this->Mesh, edges), edges.GetNumberOfEdges());
  this->Taken = std::move(sources);
  return true;
}

void CurvedSurface::Move(const Motion& motion)
{
  if (this->IsMoved && motion == this->Current)
  {
    return;
  }
  std::vector<Box> boxes(this->Mesh.Faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(boxes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType face = begin; face < end; ++face)
      {
        const FaceBox& local = this->Surface.GetBox(static_cast<int>(face));
        Box box;
        for (int c = 0; c < 3; ++c)
        {
          box.Low[c] = this->Mesh.Origin[c] + local.Low[c];
          box.High[c] = this->Mesh.Origin[c] + local.High[c];
        }
        boxes[face] = motion.MoveBox(box);
      }
    });
  if (this->IsMoved)
  {
    this->Tree.Fit(boxes);
  }
  else
  {
    this->Tree.Build(boxes);
  }
  this->Current = motion;
  this->IsMoved = true;
}

std::pair<vtkIdType, double> CurvedSurface::Refine(
  const std::vector<unsigned char>& areWanted, double tolerance)
{
  const std::pair<vtkIdType, double> shortfall = this->Steps.Choose(areWanted, tolerance);
  if (!this->Triangles || this->EdgeSteps != this->Steps.GetEdgeSteps())
  {
    this->BuildTriangles();
    this->EdgeSteps = this->Steps.GetEdgeSteps();
  }
  return shortfall;
}

void CurvedSurface::BuildPoints(
  const std::vector<vtkIdType>& firstPoints, std::vector<double>& points) const
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Mesh.Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int face = static_cast<int>(begin); face < end; ++face)
      {
        const FacePattern pattern = this->Steps.GetPattern(face);
        double* point = &points[3 * firstPoints[face]];
        for (int i = 0; i < pattern.Pattern->GetNumberOfVertices(); ++i)
        {
          float weights[3];
          float position[3];
          float normal[3];
          pattern.GetWeights(i, weights);
          this->Surface.GetEvaluator().Evaluate(face, weights, position, normal);
          for (int c = 0; c < 3; ++c)
          {
            *point++ = this->Mesh.Origin[c] + position[c];
          }
        }
      }
    });
}

void CurvedSurface::BuildTriangles()
{
  const int numberOfFaces = static_cast<int>(this->Mesh.Faces.size());
  std::vector<vtkIdType> firstPoints(this->Mesh.Faces.size() + 1, 0);
  for (int face = 0; face < numberOfFaces; ++face)
  {
    firstPoints[face + 1] =
      firstPoints[face] + this->Steps.GetPattern(face).Pattern->GetNumberOfVertices();
  }
  std::vector<double> places(3 * firstPoints.back());
  this->BuildPoints(firstPoints, places);

  vtkNew<vtkCellArray> polygons;
  this->Cells.clear();
  std::vector<unsigned char> out;
  for (int face = 0; face < numberOfFaces; ++face)
  {
    const FacePattern pattern = this->Steps.GetPattern(face);
    const int number = pattern.Pattern->GetNumberOfTriangles();
    out.assign(static_cast<std::size_t>(number), 0);
    if (this->Surface.GetHoles())
    {
      this->Surface.GetHoles()->Find(face, pattern, out.data());
    }
    for (int t = 0; t < number; ++t)
    {
      const unsigned int* vertices = &pattern.Pattern->Triangles[3 * static_cast<std::size_t>(t)];
      vtkIdType corners[3];
      const double* points[3];
      bool isFinite = true;
      for (int i = 0; i < 3; ++i)
      {
        corners[i] = firstPoints[face] + vertices[pattern.Mirrored ? 2 - i : i];
        points[i] = &places[3 * corners[i]];
        isFinite = isFinite &&
          std::all_of(points[i], points[i] + 3, [](double x) { return std::isfinite(x); });
      }
      const auto areOne = [&](int i, int j)
      { return std::equal(points[i], points[i] + 3, points[j]); };
      if (out[t] == 0 && isFinite && !areOne(0, 1) && !areOne(1, 2) && !areOne(2, 0))
      {
        polygons->InsertNextCell(3, corners);
        this->Cells.push_back(this->Mesh.Faces[face].Cell);
      }
    }
  }

  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(firstPoints.back());
  std::copy(places.begin(), places.end(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  this->Triangles = vtkSmartPointer<vtkPolyData>::New();
  this->Triangles->SetPoints(points);
  this->Triangles->SetPolys(polygons);
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("vtkOriginalCellIds");
  cells->SetNumberOfValues(static_cast<vtkIdType>(this->Cells.size()));
  std::copy(this->Cells.begin(), this->Cells.end(), cells->GetPointer(0));
  this->Triangles->GetCellData()->AddArray(cells);
}
}
