// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random calls of the public classes of FiltersRefinement, on random meshes, never
// crash. Points of triangles stay finite, and the locator finds existing cells.
#include "RelevoCheck.h"
#include "RelevoFuzzRecipe.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkDepthTagFilter.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkRefinedCellLocator.h"
#include "vtkRefinementPatternSource.h"
#include "vtkRefinementPatternTable.h"
#include "vtkSilhouetteDepthTagMetric.h"

#include <cmath>
#include <sstream>

namespace
{
using RelevoFuzz::Call;
using RelevoFuzz::Dice;

class Machine
{
public:
  explicit Machine(Dice& dice)
    : D(dice)
    , Recipe(dice)
  {
    this->NewRecipe();
    this->Refiner->SetCamera(this->Camera);
    this->Tagger->SetCamera(this->Camera);
    this->NewInput();
  }

  std::vector<Call> GetCalls()
  {
    std::vector<Call> calls = { { "input", [this] { this->NewInput(); } },
      { "recipe", [this] { this->NewRecipe(); } }, { "update", [this] { this->Update(); } },
      { "update", [this] { this->Update(); } }, { "update", [this] { this->Update(); } },
      { "print", [this] { this->Print(); } } };
    this->Recipe.AddTo(calls);
    this->AddOtherCalls(calls);
    this->AddLocatorCalls(calls);
    return calls;
  }

  std::string FindError()
  {
    return !RelevoFuzz::IsFinite(this->Refiner->GetOutput())
      ? "a triangle has a point that is not finite"
      : this->Error;
  }

private:
  void NewInput()
  {
    auto mesh = RelevoFuzz::MakeMesh(this->D);
    this->Refiner->SetInputData(mesh);
    this->Tagger->SetInputData(mesh);
    this->Locator->SetDataSet(mesh);
  }
  void NewRecipe()
  {
    this->Recipe.Renew();
    this->Refiner->SetRefinement(this->D.Once(20) ? nullptr : this->Recipe.Get());
    this->Locator->SetRefinement(this->D.Once(20) ? nullptr : this->Recipe.Get());
  }
  void Update() { this->D.Once(3) ? this->Tagger->Update() : this->Refiner->Update(); }
  void Print()
  {
    std::ostringstream text;
    this->Recipe.Print(text);
    this->Refiner->Print(text);
    this->Tagger->Print(text);
    this->Locator->Print(text);
  }
  void AddOtherCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "camera",
          [this]
          {
            this->Camera->SetPosition(this->D.Number(), this->D.Number(), this->D.Number());
            this->Camera->SetParallelProjection(this->D.Throw(2));
            this->Refiner->SetCamera(this->D.Once(5) ? nullptr : this->Camera.Get());
            this->Refiner->SetViewportSize(this->D.Whole(), this->D.Whole());
            this->Tagger->SetViewportSize(this->D.Whole(), this->D.Whole());
          } },
        { "matrix",
          [this]
          {
            this->Matrix->SetElement(this->D.Throw(3), this->D.Throw(4), this->D.Number());
            this->Refiner->SetModelToWorld(this->D.Once(3) ? nullptr : this->Matrix.Get());
            this->Locator->SetModelToWorld(this->D.Once(3) ? nullptr : this->Matrix.Get());
            this->Locator->SetCamera(this->D.Once(3) ? nullptr : this->Camera.Get());
            this->Locator->SetViewportSize(this->D.Whole(), this->D.Whole());
          } },
        { "DepthTagFilter",
          [this]
          {
            this->Tagger->SetMetric(this->Recipe.ChooseMetric());
            this->Tagger->SetMaximumLevel(this->D.Whole());
            this->Tagger->SetLevelRule(this->D.Whole());
          } },
        { "patterns",
          [this]
          {
            this->Patterns->SetTable(
              this->D.Once(2) ? nullptr : this->Recipe.Get()->GetPatternTable());
            this->Patterns->SetLevels(this->D.Whole(), this->D.Throw(4), this->D.Throw(4));
            this->Patterns->Update();
            vtkNew<vtkPolyData> pattern;
            this->Recipe.Get()->GetPatternTable()->GetPattern(this->D.Whole(), 0, 1, pattern);
            this->Recipe.Get()->GetPatternTable()->Read(this->D.Once(2) ? nullptr : "no such file");
          } } });
  }

  void AddLocatorCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "line", [this] { this->FindLine(); } }, { "nearest", [this] { this->FindNearest(); } },
        { "locator's structure",
          [this]
          {
            this->D.Once(2) ? this->Locator->BuildLocator() : this->Locator->FreeSearchStructure();
            vtkNew<vtkPolyData> surface;
            this->Locator->GenerateRepresentation(this->D.Whole(), surface);
          } } });
  }
  // The cell found must exist, and the point found must be finite.
  void CheckFound(vtkIdType cell, const double x[3])
  {
    vtkDataSet* mesh = this->Locator->GetDataSet();
    if (cell < 0 || cell >= mesh->GetNumberOfCells() || !std::isfinite(x[0] + x[1] + x[2]))
    {
      this->Error = "the locator finds what does not exist";
    }
  }
  double Coordinate() { return this->D.Once(4) ? this->D.Number() : 4.0 * this->D.Share() - 2.0; }
  void FindLine()
  {
    const double from[3] = { this->Coordinate(), this->Coordinate(), this->Coordinate() };
    const double to[3] = { this->Coordinate(), this->Coordinate(), this->Coordinate() };
    const double tolerance = this->D.Once(2) ? 0.0 : std::abs(this->D.Number());
    double t;
    double x[3];
    double pcoords[3];
    int subId;
    vtkIdType cell;
    if (this->Locator->IntersectWithLine(
          from, to, tolerance, t, x, pcoords, subId, cell, this->Cell))
    {
      this->CheckFound(cell, x);
    }
    vtkNew<vtkIdList> cells;
    this->Locator->FindCellsAlongLine(from, to, tolerance, cells);
  }
  void FindNearest()
  {
    double x[3] = { this->Coordinate(), this->Coordinate(), this->Coordinate() };
    double nearest[3] = { 0.0, 0.0, 0.0 };
    double distance2;
    int subId;
    int inside;
    vtkIdType cell = -1;
    this->Locator->FindClosestPoint(x, nearest, this->Cell, cell, subId, distance2);
    cell >= 0 ? this->CheckFound(cell, nearest) : void();
    if (this->Locator->FindClosestPointWithinRadius(
          x, std::abs(this->D.Number()), nearest, this->Cell, cell, subId, distance2, inside))
    {
      this->CheckFound(cell, nearest);
    }
    double box[6] = { x[0], this->Coordinate(), x[1], this->Coordinate(), x[2],
      this->Coordinate() };
    vtkNew<vtkIdList> cells;
    this->Locator->FindCellsWithinBounds(box, cells);
  }

  Dice& D;
  std::string Error;
  RelevoFuzz::RecipeCalls Recipe;
  vtkNew<vtkRefinedCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
  vtkNew<vtkAdaptiveRefinementFilter> Refiner;
  vtkNew<vtkDepthTagFilter> Tagger;
  vtkNew<vtkRefinementPatternSource> Patterns;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkMatrix4x4> Matrix;
};

// An array with the name of the normals, but more components, replaces them.
void TestReplacedNormals(RelevoCheck& check)
{
  RelevoMeshes::Mesh mesh = RelevoMeshes::Sphere(8, 6);
  vtkNew<vtkFloatArray> other;
  other->SetName("Normals");
  other->SetNumberOfComponents(64);
  other->SetNumberOfTuples(mesh->GetNumberOfPoints());
  other->Fill(1.0);
  mesh->GetPointData()->AddArray(other);
  vtkNew<vtkPNTriangleSurface> surface;
  CHECK_GREATER(
    RelevoMeshes::Refine(mesh, RelevoMeshes::MakeRecipe(2, surface))->GetNumberOfPolys(), 0);
  vtkNew<vtkDepthTagFilter> tagger;
  vtkNew<vtkSilhouetteDepthTagMetric> metric;
  vtkNew<vtkCamera> camera;
  tagger->SetInputData(mesh);
  tagger->SetMetric(metric);
  tagger->SetCamera(camera);
  tagger->Update();
  CHECK(tagger->GetOutput()->GetPointData()->GetArray("DepthTag"));
}
}

RELEVO_FUZZ_TARGET(Machine)

int TestFuzzRefinement(int, char*[])
{
  RelevoCheck check;
  TestReplacedNormals(check);
  int calls = 0;
  CHECK_EQUAL(RelevoFuzz::Run<Machine>(1500, 40, calls), 0);
  std::cout << calls << " calls\n";
  return check.GetResult();
}
