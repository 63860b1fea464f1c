// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The public classes of FiltersRefinement, called in random order on random meshes: nothing
// crashes, and triangles have finite points.
#include "RelevoCheck.h"
#include "RelevoFuzzRecipe.h"
#include "RelevoTestMeshes.h"

#include "vtkCamera.h"
#include "vtkDepthTagFilter.h"
#include "vtkMatrix4x4.h"
#include "vtkPNTriangleSurface.h"
#include "vtkRefinementPatternSource.h"
#include "vtkRefinementPatternTable.h"
#include "vtkSilhouetteDepthTagMetric.h"

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
    return calls;
  }

  std::string FindFault()
  {
    return !RelevoFuzz::IsFinite(this->Refiner->GetOutput())
      ? "a triangle has a point that is not finite"
      : "";
  }

private:
  void NewInput()
  {
    auto mesh = RelevoFuzz::MakeMesh(this->D);
    this->Refiner->SetInputData(mesh);
    this->Tagger->SetInputData(mesh);
  }
  void NewRecipe()
  {
    this->Recipe.Renew();
    this->Refiner->SetRefinement(this->D.Once(20) ? nullptr : this->Recipe.Get());
  }
  void Update() { this->D.Once(3) ? this->Tagger->Update() : this->Refiner->Update(); }
  void Print()
  {
    std::ostringstream text;
    this->Recipe.Print(text);
    this->Refiner->Print(text);
    this->Tagger->Print(text);
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

  Dice& D;
  RelevoFuzz::RecipeCalls Recipe;
  vtkNew<vtkAdaptiveRefinementFilter> Refiner;
  vtkNew<vtkDepthTagFilter> Tagger;
  vtkNew<vtkRefinementPatternSource> Patterns;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkMatrix4x4> Matrix;
};

// An array of the same name takes the place of the normals, with more components.
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
  CHECK(RelevoMeshes::Refine(mesh, RelevoMeshes::MakeRecipe(2, surface))->GetNumberOfPolys() > 0);
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

int TestFuzzRefinement(int, char*[])
{
  RelevoCheck check;
  TestReplacedNormals(check);
  int calls = 0;
  CHECK(RelevoFuzz::Run<Machine>(1500, 40, calls) == 0);
  std::cout << calls << " calls\n";
  return check.GetResult();
}
