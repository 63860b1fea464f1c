// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The public classes of FiltersRefinement, called in random order on random meshes: nothing
// crashes, and triangles have finite points.
#include "RelevoCheck.h"
#include "RelevoFuzz.h"
#include "RelevoTestMeshes.h"

#include "vtkCamera.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDepthTagFilter.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkG1Surface.h"
#include "vtkLinearSurface.h"
#include "vtkMatrix4x4.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkProceduralSurface.h"
#include "vtkRefinementPatternSource.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScalarTaggedSurface.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkSphere.h"
#include "vtkViewDependentDepthTagMetric.h"

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
    this->AddRecipeCalls(calls);
    this->AddMetricCalls(calls);
    this->AddSurfaceCalls(calls);
    this->AddOtherCalls(calls);
    return calls;
  }

  // Triangles of the output whose points are no numbers.
  std::string FindFault()
  {
    vtkPolyData* output = this->Refiner->GetOutput();
    auto cells = vtk::TakeSmartPointer(output->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* ids;
      cells->GetCurrentCell(size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        double x[3];
        output->GetPoint(ids[i], x);
        if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
        {
          return "a triangle has a point that is not finite";
        }
      }
    }
    return {};
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
    this->Recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
    this->Recipe->SetMaximumLevel(this->D.Throw(4));
    this->Refiner->SetRefinement(this->D.Once(20) ? nullptr : this->Recipe.Get());
  }
  void Update() { this->D.Once(3) ? this->Tagger->Update() : this->Refiner->Update(); }
  void Print()
  {
    std::ostringstream text;
    this->Recipe->Print(text);
    this->Refiner->Print(text);
    this->Tagger->Print(text);
    for (vtkObject* object : this->GetMetrics())
    {
      object ? object->Print(text) : void();
    }
    for (vtkObject* object : this->GetSurfaces())
    {
      object ? object->Print(text) : void();
    }
  }
  std::vector<vtkDepthTagMetric*> GetMetrics()
  {
    return { nullptr, this->Distance, this->ScreenEdge, this->Curvature, this->Silhouette,
      this->ViewDependent, this->Variation, this->Region, this->Composite };
  }
  std::vector<vtkRefinementSurface*> GetSurfaces()
  {
    return { nullptr, this->Linear, this->PN, this->G1, this->Phong, this->Tagged,
      this->Procedural };
  }
  std::string Name()
  {
    return this->D.Choose(std::vector<std::string>{
      "Field", "Flow", "Normals", "Alpha", "Sharpness", "Bias", "no such array", "" });
  }

  void AddRecipeCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "SetMaximumLevel",
          [this] { this->Recipe->SetMaximumLevel(this->D.Once(9) ? 77 : this->D.Throw(4)); } },
        { "SetMetric", [this] { this->Recipe->SetMetric(this->D.Choose(this->GetMetrics())); } },
        { "SetSurface", [this] { this->Recipe->SetSurface(this->D.Choose(this->GetSurfaces())); } },
        { "SetDisplacement",
          [this] {
            this->Recipe->SetDisplacement(this->D.Once(2) ? nullptr : this->Displacement.Get());
          } },
        { "SetLevelRule", [this] { this->Recipe->SetLevelRule(this->D.Whole()); } },
        { "SetLevelOffset", [this] { this->Recipe->SetLevelOffset(this->D.Number()); } },
        { "SetSegmentPolicy", [this] { this->Recipe->SetSegmentPolicy(this->D.Whole()); } },
        { "SetGeomorphing", [this] { this->Recipe->SetGeomorphing(this->D.Whole()); } },
        { "SetNoDataMagnitude", [this] { this->Recipe->SetNoDataMagnitude(this->D.Number()); } },
        { "SetDepthTagArrayName",
          [this] { this->Recipe->SetDepthTagArrayName(this->Name().c_str()); } } });
  }
  void AddMetricCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "Distance",
          [this]
          {
            this->Distance->SetMaximumDistance(this->D.Number());
            this->Distance->SetFallOff(this->D.Whole());
            this->Distance->SetMeasure(this->D.Whole());
          } },
        { "ScreenEdge",
          [this]
          {
            this->ScreenEdge->SetReferenceLength(this->D.Number());
            this->ScreenEdge->SetMeasure(this->D.Whole());
          } },
        { "Curvature",
          [this]
          {
            this->Curvature->SetCurvatureType(this->D.Whole());
            this->Curvature->SetMinimumCurvature(this->D.Number());
            this->Curvature->SetMaximumCurvature(this->D.Number());
            this->Curvature->SetQuantiles(this->D.Number(), this->D.Number());
          } },
        { "Silhouette",
          [this]
          {
            this->Silhouette->SetCriterion(this->D.Whole());
            this->Silhouette->SetContourWidth(this->D.Number());
          } },
        { "ViewDependent",
          [this]
          {
            this->ViewDependent->SetMaximumSpread(this->D.Number());
            this->ViewDependent->SetEdgeOnWeight(this->D.Number());
          } },
        { "FieldVariation",
          [this]
          {
            this->Variation->SetArrayName(this->Name().c_str());
            this->Variation->SetMaximumVariation(this->D.Number());
            this->Variation->SetNoDataMagnitude(this->D.Number());
          } },
        { "Region",
          [this]
          {
            this->Region->SetImplicitFunction(this->D.Once(2) ? nullptr : this->Implicit.Get());
            this->Region->SetCenter(this->D.Number(), this->D.Number(), 0.0);
            this->Region->SetRadius(this->D.Number());
            this->Region->SetFallOff(this->D.Number());
          } },
        { "Composite",
          [this]
          {
            this->Composite->SetMode(this->D.Whole());
            this->Composite->AddMetric(this->D.Choose(this->GetMetrics()), this->D.Number());
          } },
        { "RemoveAllMetrics", [this] { this->Composite->RemoveAllMetrics(); } } });
  }
  void AddSurfaceCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "PN", [this] { this->PN->SetQuadraticNormals(this->D.Once(2)); } },
        { "G1", [this] { this->G1->SetGeometricNormals(this->D.Once(2)); } },
        { "Phong",
          [this]
          {
            this->Phong->SetAlpha(this->D.Number());
            this->Phong->SetAlphaArrayName(this->Name().c_str());
          } },
        { "ScalarTagged",
          [this]
          {
            this->Tagged->SetSharpnessArrayName(this->Name().c_str());
            this->Tagged->SetDirectionArrayName(this->Name().c_str());
          } },
        { "Procedural",
          [this]
          {
            this->Procedural->SetAmplitude(this->D.Number());
            this->Procedural->SetFrequency(this->D.Number());
            this->Procedural->SetBaseSurface(this->D.Choose(this->GetSurfaces()));
            this->Procedural->SetShaderFunction(this->D.Once(4) ? "nonsense" : nullptr);
          } } });
  }
  void AddOtherCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "displacement",
          [this]
          {
            this->Displacement->SetScale(this->D.Number());
            this->Displacement->SetOffset(this->D.Number());
            this->Displacement->SetHeightMap(this->D.Once(3) ? nullptr : this->Heights.Get());
            this->Displacement->SetNoDataPolicy(this->D.Whole());
          } },
        { "direction",
          [this]
          {
            this->D.Once(2)
              ? this->Displacement->SetDirectionToNormal()
              : this->Displacement->SetDirection(this->D.Number(), this->D.Number(), 1.0);
          } },
        { "heights",
          [this]
          {
            const double height = this->D.Number();
            this->Heights->Fill(1 + this->D.Throw(9), 1 + this->D.Throw(9),
              [height](double u, double v)
              { return std::isfinite(height) ? height * std::sin(9 * u + v) : 0.5; });
            this->D.Once(2) ? this->Heights->Punch([](int x, int y) { return (x + y) % 4 == 0; })
                            : void();
          } },
        { "camera",
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
            this->Tagger->SetMetric(this->D.Choose(this->GetMetrics()));
            this->Tagger->SetMaximumLevel(this->D.Whole());
            this->Tagger->SetLevelRule(this->D.Whole());
          } },
        { "patterns",
          [this]
          {
            this->Patterns->SetTable(this->D.Once(2) ? nullptr : this->Recipe->GetPatternTable());
            this->Patterns->SetLevels(this->D.Whole(), this->D.Throw(4), this->D.Throw(4));
            this->Patterns->Update();
            vtkNew<vtkPolyData> pattern;
            this->Recipe->GetPatternTable()->GetPattern(this->D.Whole(), 0, 1, pattern);
            this->Recipe->GetPatternTable()->Read(this->D.Once(2) ? nullptr : "no such file");
          } } });
  }

  Dice& D;
  vtkSmartPointer<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementFilter> Refiner;
  vtkNew<vtkDepthTagFilter> Tagger;
  vtkNew<vtkRefinementPatternSource> Patterns;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkNew<vtkSphere> Implicit;
  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkDistanceDepthTagMetric> Distance;
  vtkNew<vtkScreenEdgeDepthTagMetric> ScreenEdge;
  vtkNew<vtkCurvatureDepthTagMetric> Curvature;
  vtkNew<vtkSilhouetteDepthTagMetric> Silhouette;
  vtkNew<vtkViewDependentDepthTagMetric> ViewDependent;
  vtkNew<vtkFieldVariationDepthTagMetric> Variation;
  vtkNew<vtkRegionDepthTagMetric> Region;
  vtkNew<vtkCompositeDepthTagMetric> Composite;
  vtkNew<vtkLinearSurface> Linear;
  vtkNew<vtkPNTriangleSurface> PN;
  vtkNew<vtkG1Surface> G1;
  vtkNew<vtkPhongSurface> Phong;
  vtkNew<vtkScalarTaggedSurface> Tagged;
  vtkNew<vtkProceduralSurface> Procedural;
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
