// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveCurveMapper promises the features of other mappers: culling, bounds, clipping planes,
// blocks, selections, large coordinates, and changes of windows.
#include "RelevoCurveScene.h"
#include "RelevoCurves.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <array>

namespace
{
using Mapper = vtkAdaptiveCurveMapper;

constexpr vtkIdType NumberOfCurves = 24;

bool IsSame(const RelevoPicture& a, const RelevoPicture& b)
{
  return a.Colors == b.Colors && a.Depths == b.Depths;
}

void TestCulling(RelevoCheck& check)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  scene.Mapper->SetRadius(0.05);
  scene.Draw();
  CHECK_EQUAL(scene.Mapper->GetNumberOfCurves(), NumberOfCurves);
  CHECK_EQUAL(scene.Mapper->GetNumberOfCulledCurves(), 0);
  for (int representation : { Mapper::LINES, Mapper::RIBBONS, Mapper::TUBES })
  {
    CHECK_CASE(representation);
    scene.Mapper->SetRepresentation(representation);
    for (double zoom : { 1.0, 3.0, 10.0 })
    {
      CHECK_CASE(zoom);
      scene.GetCamera()->SetViewAngle(30.0 / zoom);
      scene.Mapper->FrustumCullingOn();
      const RelevoPicture culled = scene.Draw();
      const vtkIdType hidden = scene.Mapper->GetNumberOfCulledCurves();
      CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnSegments(), (NumberOfCurves - hidden) * 16);
      CHECK_EQUAL(scene.Mapper->GetNumberOfCulledSegments(), hidden * 16);
      scene.Mapper->FrustumCullingOff();
      CHECK(IsSame(scene.Draw(), culled));
      CHECK_EQUAL(scene.Mapper->GetNumberOfCulledCurves(), 0);
      CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnSegments(), NumberOfCurves * 16);
      CHECK_EQUAL(scene.Mapper->GetNumberOfCulledSegments(), 0);
      CHECK(zoom == 1.0 ? hidden == 0 : hidden > (zoom == 3.0 ? 0 : 8));
    }
  }
}

// An unchanged scene evaluates, uploads and builds nothing. After a change of the recipe, only
// levels are evaluated.
void TestChanges(RelevoCheck& check)
{
  const auto curves = RelevoMakeCurves(3);
  RelevoCurveScene scene(curves);
  scene.Draw();
  const auto count = [&scene]()
  {
    scene.Draw();
    return std::array<vtkIdType, 3>{ { scene.Mapper->GetNumberOfSelections(),
      scene.Mapper->GetNumberOfBufferBuilds(), scene.Mapper->GetNumberOfShaderBuilds() } };
  };
  const auto first = count();
  CHECK(first[0] == 1 && first[1] == 1 && first[2] == 1);
  scene.GetCamera()->Azimuth(10.0);
  CHECK_EQUAL(count(), first);
  scene.Recipe->SetMaximumLevel(2);
  const auto second = count();
  CHECK(second[0] == 2 && second[1] == 1);
  CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnSegments(), NumberOfCurves * 4);
  CHECK_EQUAL(scene.Mapper->GetNumberOfDrawCalls(), 1);
  curves->GetPoints()->SetPoint(0, 0.0, 0.0, 3.0);
  curves->GetPoints()->Modified();
  CHECK_EQUAL(count()[1], 2);
  // Memory includes 4 control points of 3 floats, and a number for each visible curve.
  const vtkTypeInt64 points = NumberOfCurves * 4 * 12;
  CHECK_GREATER_EQUAL(scene.Mapper->GetGraphicsMemorySize(), points);
  CHECK_LESS(scene.Mapper->GetGraphicsMemorySize(), points + NumberOfCurves * 4 + 8192);
}

void TestBounds(RelevoCheck& check)
{
  const auto curves = RelevoMakeCurves(3);
  RelevoCurveScene scene(curves);
  double hull[6];
  curves->GetBounds(hull);
  const double* bounds = scene.Mapper->GetBounds();
  for (int i = 0; i < 6; ++i)
  {
    CHECK_NEAR(bounds[i], hull[i], 1e-12);
  }
  scene.Mapper->SetRepresentationToTubes();
  scene.Mapper->SetRadius(0.25);
  bounds = scene.Mapper->GetBounds();
  for (int i = 0; i < 6; ++i)
  {
    CHECK_NEAR(bounds[i], hull[i] + (i % 2 ? 0.25 : -0.25), 1e-12);
  }
}

void TestClipping(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  scene.Mapper->SetRadius(0.05);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.7);
  plane->SetNormal(0.1, 0.2, -1.0);
  for (int representation : { Mapper::LINES, Mapper::TUBES })
  {
    CHECK_CASE(representation);
    scene.Mapper->SetRepresentation(representation);
    scene.Actor->GetProperty()->SetLighting(representation != Mapper::LINES);
    scene.Mapper->RemoveAllClippingPlanes();
    const size_t whole = scene.Draw().CountForeground();
    scene.Mapper->AddClippingPlane(plane);
    const RelevoPicture clipped = scene.Draw();
    CHECK_LESS(clipped.CountForeground(), 0.8 * whole);
    CHECK_GREATER(clipped.CountForeground(), 0.2 * whole);
    comparison.Compare("clipped", { 2, 1e-6, 10 }, clipped, scene.DrawTwin());
  }
}

// The mapper's coincident offset draws lines on a surface in front of it or behind it.
void TestCoincidentOffset(RelevoCheck& check)
{
  const auto flat = RelevoMakeCurves(3);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    double x[3];
    flat->GetPoint(i, x);
    flat->GetPoints()->SetPoint(i, x[0], 0.0, x[2]);
  }
  RelevoCurveScene scene(flat);
  scene.Actor->GetProperty()->LightingOff();
  const size_t whole = scene.Draw().CountForeground();
  const auto corners = RelevoNewGrid({ { -4, 0, -4 }, { 4, 0, -4 }, { 4, 0, 4 }, { -4, 0, 4 } });
  vtkNew<vtkCellArray> square;
  square->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(corners->GetPoints());
  surface->SetPolys(square);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  scene.Renderer->AddActor(actor);
  const int resolve = vtkMapper::GetResolveCoincidentTopology();
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  for (double units : { -1000.0, 5000.0 })
  {
    CHECK_CASE(units);
    scene.Mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, units);
    CHECK_EQUAL(scene.Draw().CountForeground(), (units < 0.0 ? whole : 0));
  }
  vtkMapper::SetResolveCoincidentTopology(resolve);
}

// Large coordinates keep their accuracy.
void TestFarAway(RelevoComparison& comparison)
{
  const auto near = RelevoMakeCurves(3);
  const auto far = RelevoMakeCurves(3);
  for (vtkIdType i = 0; i < far->GetNumberOfPoints(); ++i)
  {
    double x[3];
    far->GetPoint(i, x);
    far->GetPoints()->SetPoint(i, x[0] + 4194304.0, x[1] - 8388608.0, x[2]);
  }
  RelevoCurveScene first(near);
  RelevoCurveScene second(far);
  for (RelevoCurveScene* scene : { &first, &second })
  {
    scene->Mapper->SetRadius(0.05);
    scene->Mapper->SetRepresentationToTubes();
    scene->Renderer->ResetCamera();
  }
  comparison.Compare("far away", { 3, 1e-4, 60 }, second.Draw(), first.Draw());
}

// Each pixel of a curve selects its cell, the same as in the twin.
void TestSelection(RelevoCheck& check, bool isTessellated)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto curves = RelevoMakeCurves(3);
  blocks->SetBlock(1, curves);
  RelevoCurveScene scene(blocks);
  scene.Mapper->SetRadius(0.05);
  scene.Mapper->SetMethod(isTessellated ? 1 : 0);
  for (int representation : { Mapper::LINES, Mapper::RIBBONS, Mapper::TUBES })
  {
    scene.Mapper->SetRepresentation(representation);
    scene.Draw();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    const int* size = scene.Window->GetSize();
    selector->SetArea(0, 0, size[0] - 1, size[1] - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    auto selection = vtk::TakeSmartPointer(selector->Select());
    if (!CHECK_EQUAL(selection->GetNumberOfNodes(), 1))
    {
      return;
    }
    vtkSelectionNode* node = selection->GetNode(0);
    CHECK_EQUAL(node->GetProperties()->Get(vtkSelectionNode::PROP()), scene.Actor);
    CHECK_EQUAL(node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX()), 2);
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    // All curves except those hidden by others are selected.
    CHECK_GREATER(ids->GetNumberOfValues(), NumberOfCurves - 6);
    for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    {
      CHECK_GREATER_EQUAL(ids->GetValue(i), 0);
      CHECK_LESS(ids->GetValue(i), NumberOfCurves);
    }
    // The middle of a curve that is not hidden.
    double world[4] = { 0.0, 0.0, 0.0, 1.0 };
    int found = 0;
    for (vtkIdType cell = 0; cell < NumberOfCurves; ++cell)
    {
      double weights[4];
      int part = 0;
      const double middle[3] = { 0.5, 0.0, 0.0 };
      curves->GetCell(cell)->EvaluateLocation(part, middle, world, weights);
      scene.Renderer->SetWorldPoint(world);
      scene.Renderer->WorldToDisplay();
      const double* display = scene.Renderer->GetDisplayPoint();
      selector->SetArea(static_cast<int>(display[0]) - 1, static_cast<int>(display[1]) - 1,
        static_cast<int>(display[0]) + 1, static_cast<int>(display[1]) + 1);
      auto here = vtk::TakeSmartPointer(selector->Select());
      auto* list = here->GetNumberOfNodes() == 1
        ? vtkIdTypeArray::SafeDownCast(here->GetNode(0)->GetSelectionList())
        : nullptr;
      found += list && list->LookupValue(cell) >= 0 ? 1 : 0;
    }
    CHECK_GREATER(found, NumberOfCurves - 6);
  }
}

// Blocks look the same as single inputs.
void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, RelevoMakeCurves(3));
  blocks->SetBlock(2, RelevoMakeCurves(4));
  RelevoCurveScene both(blocks);
  both.Draw();
  CHECK_EQUAL(both.Mapper->GetNumberOfCurves(), 2 * NumberOfCurves);
  CHECK_EQUAL(both.Mapper->GetNumberOfDrawnSegments(), 2 * NumberOfCurves * 16);
  CHECK_EQUAL(both.Mapper->GetNumberOfDrawCalls(), 2);
  const vtkIdType builds = both.Mapper->GetNumberOfBufferBuilds();
  const RelevoPicture picture = both.Draw();
  blocks->SetBlock(2, nullptr);
  const RelevoPicture one = both.Draw();
  CHECK_EQUAL(both.Mapper->GetNumberOfCurves(), NumberOfCurves);
  CHECK_EQUAL(both.Mapper->GetNumberOfBufferBuilds(), builds);
  CHECK_LESS(one.CountForeground(), picture.CountForeground());
  RelevoCurveScene alone(RelevoMakeCurves(3));
  alone.GetCamera()->DeepCopy(both.GetCamera());
  CHECK(IsSame(alone.Draw(), one));
}

// A mapper that moves to another window or was released draws the same picture.
void TestWindows(RelevoCheck& check)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  scene.Mapper->SetRadius(0.05);
  for (int method : { Mapper::METHOD_INSTANCING, Mapper::METHOD_HARDWARE_TESSELLATION })
  {
    CHECK_CASE(method);
    scene.Mapper->SetMethod(method);
    scene.Mapper->SetRepresentationToTubes();
    const RelevoPicture first = scene.Draw();
    scene.Mapper->ReleaseGraphicsResources(scene.Window);
    CHECK(IsSame(scene.Draw(), first));
    {
      RelevoCurveScene other(RelevoMakeCurves(3));
      other.GetCamera()->DeepCopy(scene.GetCamera());
      other.Renderer->RemoveActor(other.Actor);
      other.Renderer->AddActor(scene.Actor);
      other.Window->Render();
      CHECK(IsSame(RelevoPicture(other.Window), first));
    }
    CHECK(IsSame(scene.Draw(), first));
  }
}
}

int TestAdaptiveCurveMapperFeatures(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestCulling(check);
  TestChanges(check);
  TestBounds(check);
  TestClipping(check, comparison);
  TestCoincidentOffset(check);
  TestFarAway(comparison);
  TestSelection(check, false);
  TestSelection(check, true);
  TestBlocks(check);
  TestWindows(check);
  return check.GetResult();
}
