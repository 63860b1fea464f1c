// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on budgets: GetNumberOfDrawnTriangles() counts triangles of faces in view, and
// only these use the budget.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSelection.h"
#include "vtkSphere.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

Mesh MakePlane(double x, int resolution)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(x, 0.0, 0.0);
  source->SetPoint1(x + 1.0, 0.0, 0.0);
  source->SetPoint2(x, 1.0, 0.0);
  source->SetResolution(resolution, resolution);
  source->Update();
  return source->GetOutput();
}

Mesh Append(const std::vector<Mesh>& meshes)
{
  vtkNew<vtkAppendPolyData> append;
  for (const Mesh& mesh : meshes)
  {
    append->AddInputData(mesh);
  }
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeFlatRecipe(int level, vtkDepthTagMetric* metric)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(level);
  recipe->SetMetric(metric);
  return recipe;
}

// Looks at the first of two adjacent planes; only this one is in view.
void LookDown(RelevoScene& scene, double x)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(x, 0.5, 0.0);
  camera->SetPosition(x, 0.2, 1.5);
  camera->SetClippingRange(0.1, 10.0);
}

// Counts points inside a frustum and beyond each of its planes.
struct MergedPoints
{
  int Points = 0;
  int Inside = 0;
  int Beyond[4] = { 0, 0, 0, 0 };

  void Add(const double planes[24], const double x[3])
  {
    ++this->Points;
    bool isInside = true;
    for (int i = 0; i < 4; ++i) // left, right, bottom, top
    {
      const double* p = planes + 4 * i;
      const bool isBeyond = p[0] * x[0] + p[1] * x[1] + p[2] * x[2] + p[3] < 0.0;
      this->Beyond[i] += isBeyond ? 1 : 0;
      isInside = isInside && !isBeyond;
    }
    this->Inside += isInside ? 1 : 0;
  }

  // Faces with all points beyond one plane are never drawn, and faces with a point inside always.
  // Other faces may still be out of view.
  bool IsOutside() const
  {
    return std::find(this->Beyond, this->Beyond + 4, this->Points) != this->Beyond + 4;
  }
};

// Compares the mapper's counts with the filter's mesh, grouped by coarse face.
void TestCounts(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(64, 64, 3);
  for (const bool isDisplaced : { false, true })
  {
    vtkNew<vtkDistanceDepthTagMetric> metric;
    metric->SetMaximumDistance(2.0);
    const auto recipe = MakeFlatRecipe(4, metric);
    const double reach = 0.02;
    recipe->SetDisplacement(isDisplaced ? MakeDisplacement(heights, reach) : nullptr);
    RelevoScene scene(RelevoScene::Refining);
    scene.Add(MakePlane(0.0, 40), recipe);
    for (const double angle : { 30.0, 5.0, 1.0 })
    {
      LookDown(scene, 0.4);
      scene.Renderer->GetActiveCamera()->SetViewAngle(angle);
      scene.Render();
      double planes[24];
      scene.Renderer->GetActiveCamera()->GetFrustumPlanes(
        scene.Renderer->GetTiledAspectRatio(), planes);

      vtkNew<vtkAdaptiveRefinementFilter> filter;
      filter->SetInputDataObject(scene.GetMapper(0)->GetInput());
      filter->SetRefinement(recipe);
      filter->SetCamera(scene.Renderer->GetActiveCamera());
      filter->SetViewportSize(scene.Renderer->GetSize());
      filter->Update();
      vtkPolyData* refined = filter->GetOutput();
      auto* ids =
        vtkIdTypeArray::SafeDownCast(refined->GetCellData()->GetArray("vtkOriginalCellIds"));
      // The two faces of a quad are counted as one cell, which gives wider limits.
      std::vector<MergedPoints> cells(
        static_cast<size_t>(scene.GetMapper(0)->GetNumberOfCoarseFaces()));
      std::vector<vtkIdType> triangles(cells.size(), 0);
      for (vtkIdType i = 0; i < refined->GetNumberOfCells(); ++i)
      {
        const auto cell = static_cast<size_t>(ids->GetValue(i));
        ++triangles[cell];
        vtkIdType size;
        const vtkIdType* points;
        refined->GetCellPoints(i, size, points);
        for (vtkIdType k = 0; k < size; ++k)
        {
          cells[cell].Add(planes, refined->GetPoint(points[k]));
        }
      }
      vtkIdType least = 0;
      vtkIdType most = 0;
      for (size_t cell = 0; cell < cells.size(); ++cell)
      {
        least += cells[cell].Inside == cells[cell].Points ? triangles[cell] : 0;
        most += cells[cell].IsOutside() && !isDisplaced ? 0 : triangles[cell];
      }
      Mapper* mapper = scene.GetMapper(0);
      const vtkIdType drawn = mapper->GetNumberOfDrawnTriangles();
      std::cout << "angle " << angle << ": " << least << " <= " << drawn << " <= " << most << " of "
                << refined->GetNumberOfPolys() << std::endl;
      CHECK_LESS_EQUAL(least, drawn);
      CHECK_LESS_EQUAL(drawn, most);
      CHECK_GREATER(drawn, 0);
      CHECK_EQUAL(drawn + mapper->GetNumberOfCulledTriangles(), refined->GetNumberOfPolys());
      CHECK(angle > 20.0 || 4 * drawn < refined->GetNumberOfPolys());
    }
  }
}

// A mesh that is partly in view, and a mesh of that part only, as a data set or in a composite data
// set.
void TestTarget(RelevoCheck& check, RelevoComparison& comparison, int method, bool isComposite)
{
  vtkNew<vtkDistanceDepthTagMetric> distance;
  distance->SetMaximumDistance(4.0);
  vtkNew<vtkScreenEdgeDepthTagMetric> edge;
  edge->SetReferenceLength(2.0);
  const auto inView = MakePlane(0.0, 12);
  const auto aside = MakePlane(6.0, 40);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, inView);
  blocks->SetBlock(1, aside);
  const auto both = Append({ inView, aside });
  for (vtkDepthTagMetric* metric : std::initializer_list<vtkDepthTagMetric*>{ distance, edge })
  {
    const auto recipe = MakeFlatRecipe(5, metric);
    RelevoScene whole(RelevoScene::Refining);
    RelevoScene part(RelevoScene::Refining);
    whole.Add(isComposite ? static_cast<vtkDataObject*>(blocks) : both.Get(), recipe);
    part.Add(inView, recipe);
    const bool isThorough = method == Mapper::METHOD_ARKFPI && !isComposite;
    for (const vtkIdType target :
      isThorough ? std::vector<vtkIdType>{ 20000, 6000 } : std::vector<vtkIdType>{ 6000 })
    {
      for (RelevoScene* scene : { &whole, &part })
      {
        scene->GetMapper(0)->SetMethod(method);
        scene->GetMapper(0)->SetTargetNumberOfTriangles(target);
        scene->GetMapper(0)->SetColorModeToMetric();
        LookDown(*scene, 0.5);
        scene->Render();
      }
      Mapper* mapper = whole.GetMapper(0);
      const auto drawn = static_cast<double>(mapper->GetNumberOfDrawnTriangles());
      if (method <= Mapper::METHOD_ARK) // their triangles are counted
      {
        CHECK_NEAR(drawn, static_cast<double>(target), 0.05 * static_cast<double>(target));
        CHECK_GREATER(mapper->GetNumberOfCulledTriangles(), 0);
      }
      CHECK_EQUAL(mapper->GetNumberOfCulledFaces(),
        part.GetMapper(0)->GetNumberOfCulledFaces() + 2 * 40 * 40);
      CHECK_EQUAL(mapper->GetLevelOffset(), part.GetMapper(0)->GetLevelOffset());
      CHECK_EQUAL(drawn, static_cast<double>(part.GetMapper(0)->GetNumberOfDrawnTriangles()));
      comparison.Compare("InView." + std::to_string(method) + (isComposite ? ".Composite." : ".") +
          metric->GetClassName() + "." + std::to_string(target),
        RelevoTolerance(), RelevoPicture(whole.Window), RelevoPicture(part.Window));
    }
  }
}

// Back faces of closed surfaces are culled, and picking uses the visible levels.
void TestBackFaces(RelevoCheck& check)
{
  const auto recipe = MakeFlatRecipe(5, nullptr);
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  metric->SetReferenceLength(1.0);
  recipe->SetMetric(metric);
  recipe->SetMaximumLevel(7);
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Sphere(40, 40), recipe);
  scene.ResetCameras();
  Mapper* mapper = scene.GetMapper(0);
  mapper->BackFaceCullingOn();
  constexpr vtkIdType target = 30000;
  mapper->SetTargetNumberOfTriangles(target);
  scene.Render();
  CHECK_GREATER(mapper->GetNumberOfCulledFaces(), 1000);
  CHECK_NEAR(static_cast<double>(mapper->GetNumberOfDrawnTriangles()), target, 0.05 * target);
  const double offset = mapper->GetLevelOffset();
  const vtkIdType selections = mapper->GetNumberOfSelections();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 299, 199);
  vtkSmartPointer<vtkSelection>::Take(selector->Select());
  CHECK_EQUAL(mapper->GetLevelOffset(), offset);
  CHECK_EQUAL(mapper->GetNumberOfSelections(), selections);
  scene.Render();
  CHECK_EQUAL(mapper->GetLevelOffset(), offset);
  CHECK_EQUAL(mapper->GetNumberOfSelections(), selections);

  // Back faces count if they are visible from inside, through the surface, or by a method that
  // draws them.
  scene.GetActor(0)->GetProperty()->SetOpacity(0.5);
  scene.Render();
  CHECK_LESS(mapper->GetLevelOffset(), offset);
  CHECK_EQUAL(mapper->GetNumberOfCulledFaces(), 0);
  scene.GetActor(0)->GetProperty()->SetOpacity(1.0);
  mapper->SetMethodToARK();
  scene.Render();
  CHECK_LESS(mapper->GetLevelOffset(), offset);
  CHECK_EQUAL(mapper->GetNumberOfCulledFaces(), 0);
  CHECK_NEAR(static_cast<double>(mapper->GetNumberOfDrawnTriangles()), target, 0.05 * target);
}

// Two renderers each use a target for their view. Still cameras select nothing.
void TestViews(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(64, 64, 5);
  const auto recipe = MakeFlatRecipe(5, nullptr);
  vtkNew<vtkSphere> sphere; // its metric does not depend on the view
  sphere->SetCenter(0.5, 0.5, 0.0);
  sphere->SetRadius(0.02);
  vtkNew<vtkRegionDepthTagMetric> metric;
  metric->SetImplicitFunction(sphere);
  metric->SetFallOff(0.7);
  recipe->SetDisplacement(MakeDisplacement(heights, 0.05));
  for (vtkDepthTagMetric* each :
    { static_cast<vtkDepthTagMetric*>(nullptr), static_cast<vtkDepthTagMetric*>(metric.Get()) })
  {
    recipe->SetMetric(each);
    RelevoScene scene(RelevoScene::Refining);
    vtkActor* actor = scene.Add(MakePlane(0.0, 40), recipe);
    Mapper* mapper = scene.GetMapper(0);
    mapper->SetTargetNumberOfTriangles(20000);
    LookDown(scene, 0.5);
    scene.Render();
    const double alone = mapper->GetLevelOffset();
    vtkRenderer* other = scene.AddRenderer(0.5, 0.0, 1.0, 1.0);
    scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
    other->AddActor(actor);
    other->GetActiveCamera()->SetFocalPoint(0.5, 0.5, 0.0);
    other->GetActiveCamera()->SetPosition(0.5, 0.4, 0.4);
    other->GetActiveCamera()->SetViewAngle(25.0);
    other->GetActiveCamera()->SetClippingRange(0.01, 10.0);
    scene.Render();
    CHECK_GREATER(mapper->GetLevelOffset(), alone); // the offset of the last view, a close-up
    if (each)
    {
      CHECK_NEAR(static_cast<double>(mapper->GetNumberOfDrawnTriangles()), 20000.0, 1000.0);
    }
    const vtkIdType selections = mapper->GetNumberOfSelections();
    scene.Render();
    scene.Render();
    CHECK_EQUAL(mapper->GetNumberOfSelections(), selections);
  }
}
}

int TestAdaptiveRefinementMapperInView(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestCounts(check);
  for (const bool isComposite : { false, true })
  {
    CHECK_CASE(isComposite);
    TestTarget(check, comparison, Mapper::METHOD_ARKFPI, isComposite);
  }
  for (int method = Mapper::METHOD_ARK; method <= Mapper::METHOD_UNIFORM; ++method)
  {
    TestTarget(check, comparison, method, false);
  }
  TestBackFaces(check);
  TestViews(check);
  return check.GetResult();
}
