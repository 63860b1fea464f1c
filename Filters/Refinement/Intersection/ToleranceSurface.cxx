// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Intersection/ToleranceSurface.h"

#include "Boxes/BoxTree.h"
#include "Changes/LatestTime.h"
#include "Evaluation/HoleFinder.h"
#include "Evaluation/MeshPreparation.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/RefinementEvaluator.h"
#include "Intersection/RefinedSurface.h"
#include "Intersection/ToleranceSteps.h"
#include "Mesh/FaceEdges.h"
#include "Mesh/RefinementMesh.h"
#include "Mesh/SurfaceEdges.h"
#include "Patterns/RefinementPattern.h"
#include "Recipe/RecipeLevels.h"
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

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
/// The dependencies of the triangles. The recipe's metric may change in each frame and is not one.
struct ToleranceSources
{
  ToleranceSources(vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
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
  bool operator==(const ToleranceSources& other) const
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
  // Inserting cells does not change the modification time of a vtkCellArray.
  vtkIdType NumberOfPoints;
  vtkIdType NumberOfCells;
};
}

struct ToleranceSurface::Internals
{
  std::unique_ptr<ToleranceSources> Taken; // nullptr if no mesh is set
  RefinementMesh Mesh;
  RefinedSurface Surface;
  ToleranceSteps Steps;
  std::vector<unsigned char> EdgeSteps; // of the triangles
};

ToleranceSurface::ToleranceSurface()
  : Data(new Internals)
{
}

ToleranceSurface::~ToleranceSurface() = default;

bool ToleranceSurface::Take(
  vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, std::string& error, std::string& warning)
{
  if (this->Data->Taken && *this->Data->Taken == ToleranceSources(mesh, recipe))
  {
    return true;
  }
  this->Data->Taken.reset();
  this->Triangles = nullptr;
  this->Data->Mesh = RefinementMesh();
  if (!PrepareMesh(mesh, recipe, nullptr, this->Data->Mesh, error, warning))
  {
    return false;
  }
  auto sources = std::make_unique<ToleranceSources>(mesh, recipe);
  this->BuildTime.Modified();
  this->Data->Surface.Update(this->Data->Mesh, this->BuildTime, recipe, nullptr);
  const SurfaceEdges edges(mesh);
  this->Data->Steps.Take(this->Data->Mesh, this->Data->Surface, recipe,
    FindFaceEdges(this->Data->Mesh, edges), edges.GetNumberOfEdges());
  this->Data->Taken = std::move(sources);
  return true;
}

vtkPolyData* ToleranceSurface::GetTriangles() const
{
  return this->Triangles;
}

int ToleranceSurface::GetNumberOfFaces() const
{
  return static_cast<int>(this->Data->Mesh.Faces.size());
}

void ToleranceSurface::GetFaceBounds(int face, double low[3], double high[3]) const
{
  const FloatBox& local = this->Data->Surface.GetBox(face);
  for (int c = 0; c < 3; ++c)
  {
    low[c] = this->Data->Mesh.Origin[c] + local.Low[c];
    high[c] = this->Data->Mesh.Origin[c] + local.High[c];
  }
}

std::pair<vtkIdType, double> ToleranceSurface::Refine(
  const std::vector<unsigned char>& areWanted, double tolerance)
{
  const std::pair<vtkIdType, double> warning = this->Data->Steps.Choose(areWanted, tolerance);
  if (!this->Triangles || this->Data->EdgeSteps != this->Data->Steps.GetEdgeSteps())
  {
    this->BuildTriangles();
    this->Data->EdgeSteps = this->Data->Steps.GetEdgeSteps();
  }
  return warning;
}

void ToleranceSurface::BuildPoints(
  const std::vector<vtkIdType>& firstPoints, std::vector<double>& points) const
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Data->Mesh.Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int face = static_cast<int>(begin); face < end; ++face)
      {
        const FacePattern pattern = this->Data->Steps.GetPattern(face);
        double* point = &points[3 * firstPoints[face]];
        for (int i = 0; i < pattern.Pattern->GetNumberOfVertices(); ++i)
        {
          float weights[3];
          float position[3];
          float normal[3];
          pattern.GetWeights(i, weights);
          this->Data->Surface.GetEvaluator().Evaluate(face, weights, position, normal);
          for (int c = 0; c < 3; ++c)
          {
            *point++ = this->Data->Mesh.Origin[c] + position[c];
          }
        }
      }
    });
}

void ToleranceSurface::BuildTriangles()
{
  const int numberOfFaces = static_cast<int>(this->Data->Mesh.Faces.size());
  std::vector<vtkIdType> firstPoints(this->Data->Mesh.Faces.size() + 1, 0);
  for (int face = 0; face < numberOfFaces; ++face)
  {
    firstPoints[face + 1] =
      firstPoints[face] + this->Data->Steps.GetPattern(face).Pattern->GetNumberOfVertices();
  }
  std::vector<double> places(3 * firstPoints.back());
  this->BuildPoints(firstPoints, places);

  vtkNew<vtkCellArray> polygons;
  this->Cells.clear();
  std::vector<unsigned char> out;
  for (int face = 0; face < numberOfFaces; ++face)
  {
    const FacePattern pattern = this->Data->Steps.GetPattern(face);
    const int number = pattern.Pattern->GetNumberOfTriangles();
    out.assign(static_cast<std::size_t>(number), 0);
    if (this->Data->Surface.GetHoles())
    {
      this->Data->Surface.GetHoles()->Find(face, pattern, out.data());
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
        this->Cells.push_back(this->Data->Mesh.Faces[face].Cell);
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
