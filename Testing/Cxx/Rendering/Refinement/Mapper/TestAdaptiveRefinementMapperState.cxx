// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves architecture.md: the mapper selects levels, uploads buffers and builds shaders only after
// the changes that require it. Its counters describe the last frame.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkPNTriangleSurface.h"
#include "vtkProperty.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkSelection.h"

#include <map>

namespace
{
using namespace RelevoMeshes;

// Counts its buffer and shader builds.
class CountingMapper : public vtkAdaptiveRefinementMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkAdaptiveRefinementMapper);
  int Buffers = 0;
  int Shaders = 0;

protected:
  void BuildBufferObjects(vtkRenderer* ren, vtkActor* act) override
  {
    ++this->Buffers;
    this->Superclass::BuildBufferObjects(ren, act);
  }
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override
  {
    ++this->Shaders;
    this->Superclass::ReplaceShaderValues(shaders, ren, act);
  }
};
vtkStandardNewMacro(CountingMapper);

struct View
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<CountingMapper> Mapper;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  int Buffers = 0;
  int Shaders = 0;
  vtkIdType Selections = 0;

  explicit View(vtkPolyData* mesh)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(200, 200);
    this->Window->AddRenderer(this->Renderer);
    this->Mapper->SetInputDataObject(mesh);
    this->Mapper->SetRefinement(this->Recipe);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->ResetCamera();
  }
  // Renders, and stores the work since the last call.
  void Render()
  {
    const int buffers = this->Mapper->Buffers;
    const int shaders = this->Mapper->Shaders;
    const vtkIdType selections = this->Mapper->GetNumberOfSelections();
    this->Window->Render();
    this->Buffers = this->Mapper->Buffers - buffers;
    this->Shaders = this->Mapper->Shaders - shaders;
    this->Selections = this->Mapper->GetNumberOfSelections() - selections;
  }
  bool DidNothing() const
  {
    return this->Buffers == 0 && this->Shaders == 0 && this->Selections == 0;
  }
};

vtkSmartPointer<vtkDisplacement> MakeDisplacement()
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(20, 30, 2);
  auto displacement = vtkSmartPointer<vtkDisplacement>::New();
  displacement->SetHeightMap(heights);
  displacement->SetScale(0.1);
  return displacement;
}

void TestFirstRender(RelevoCheck& check, View& view)
{
  CHECK_EQUAL(view.Mapper->GetNumberOfSelections(), 0);
  view.Render();
  CHECK_EQUAL(view.Buffers, 1);
  CHECK_GREATER_EQUAL(view.Shaders, 1);
  CHECK_EQUAL(view.Selections, 1);
}

// A moving camera and live parameters need no rebuild.
void TestLiveValues(RelevoCheck& check, View& view, vtkDisplacement* displacement)
{
  for (int i = 0; i < 3; ++i)
  {
    view.Render();
    CHECK(view.DidNothing());
    view.Renderer->GetActiveCamera()->Azimuth(10);
    view.Renderer->ResetCameraClippingRange();
    view.Render();
    CHECK(view.DidNothing());
    view.Actor->RotateX(10);
    view.Render();
    CHECK(view.DidNothing());
    displacement->SetScale(0.1 + 0.01 * i);
    view.Render();
    CHECK(view.DidNothing());
    displacement->SetOffset(0.1 * i);
    view.Render();
    CHECK(view.DidNothing());
  }
  view.Window->SetSize(240, 220);
  view.Render();
  CHECK_EQUAL(view.Selections, 0);
}

void TestLevelsAlone(RelevoCheck& check, View& view)
{
  view.Recipe->SetMaximumLevel(4);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  CHECK_EQUAL(view.Buffers, 0);
  CHECK_EQUAL(view.Shaders, 0);
}

// Levels are selected once for all passes of a frame.
void TestPasses(RelevoCheck& check, View& view)
{
  view.Renderer->UseDepthPeelingOn();
  view.Actor->GetProperty()->SetOpacity(0.5);
  view.Render();
  CHECK_EQUAL(view.Selections, 0);
  view.Render();
  CHECK_EQUAL(view.Selections, 0);
  CHECK_EQUAL(view.Buffers, 0);
}

// Hardware selection uses the same levels, too.
void TestSelection(RelevoCheck& check, View& view)
{
  view.Actor->GetProperty()->SetOpacity(1);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(view.Renderer);
  selector->SetArea(0, 0, 199, 199);
  const vtkIdType before = view.Mapper->GetNumberOfSelections();
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  CHECK_EQUAL(selection->GetNumberOfNodes(), 1);
  CHECK_EQUAL(view.Mapper->GetNumberOfSelections(), before);
  view.Render();
  CHECK_EQUAL(view.Selections, 0);
}

// A fixed direction instead of the normal needs another shader, but its value is live.
void TestDirection(RelevoCheck& check, View& view, vtkDisplacement* displacement)
{
  displacement->SetDirection(0, 0, 1);
  view.Render();
  CHECK_GREATER_EQUAL(view.Shaders, 1);
  displacement->SetDirection(0, 1, 1);
  view.Render();
  CHECK(view.DidNothing());
}

void TestReport(RelevoCheck& check, View& view)
{
  CHECK_EQUAL(view.Mapper->GetNumberOfCoarseFaces(), 12 * 2 * 7); // none flat at the poles
  CHECK_GREATER(view.Mapper->GetNumberOfUsedPatterns(), 5);
  CHECK_GREATER_EQUAL(view.Mapper->GetNumberOfDrawCalls(), view.Mapper->GetNumberOfUsedPatterns());
  CHECK_LESS_EQUAL(view.Mapper->GetNumberOfDrawCalls(), 2 * view.Mapper->GetNumberOfUsedPatterns());
  CHECK_GREATER(view.Mapper->GetSelectionTime(), 0);
  CHECK_LESS(view.Mapper->GetSelectionTime(), 10);
}

void TestDisplaced(RelevoCheck& check, vtkDisplacement* displacement)
{
  vtkNew<vtkPNTriangleSurface> surface;
  Mesh tagged = TexturedSphere(12, 8);
  AddTags(tagged, 4, 5);
  View view(tagged);
  view.Recipe->SetMaximumLevel(5);
  view.Recipe->SetSurface(surface);
  view.Recipe->SetDisplacement(displacement);
  TestFirstRender(check, view);
  TestLiveValues(check, view, displacement);
  TestLevelsAlone(check, view);
  TestPasses(check, view);
  TestSelection(check, view);
  TestDirection(check, view, displacement);
  TestReport(check, view);
}

// These levels depend on the actor's position, but not on the view.
void TestLevelsByPlace(RelevoCheck& check)
{
  vtkNew<vtkRegionDepthTagMetric> metric;
  metric->SetCenter(0.5, 0, 0);
  metric->SetRadius(0.3);
  View view(TexturedSphere(12, 8));
  view.Recipe->SetMaximumLevel(4);
  view.Recipe->SetMetric(metric);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  view.Renderer->GetActiveCamera()->Azimuth(10);
  view.Render();
  CHECK(view.DidNothing());
  const vtkIdType before = view.Mapper->GetNumberOfDrawnTriangles();
  view.Actor->SetPosition(-0.5, 0, 0);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  CHECK_EQUAL(view.Buffers, 0);
  CHECK_EQUAL(view.Shaders, 0);
  CHECK_LESS(view.Mapper->GetNumberOfDrawnTriangles(), before);
}

void TestCamera(RelevoCheck& check, View& view)
{
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  view.Render();
  CHECK(view.DidNothing());
  const vtkIdType few = view.Mapper->GetNumberOfDrawnTriangles();
  view.Renderer->GetActiveCamera()->Dolly(1.8);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  CHECK_EQUAL(view.Buffers, 0);
  CHECK_EQUAL(view.Shaders, 0);
  CHECK_GREATER(view.Mapper->GetNumberOfDrawnTriangles(), few);
}

void TestPlacement(RelevoCheck& check, View& view)
{
  view.Actor->SetPosition(0.1, 0, 0);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  view.Actor->SetScale(0.7);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
}

void TestViewport(RelevoCheck& check, View& view)
{
  view.Window->SetSize(300, 260);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  view.Renderer->SetViewport(0, 0, 0.5, 1);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
}

void TestOtherMetric(RelevoCheck& check, View& view, vtkDistanceDepthTagMetric* metric)
{
  metric->SetMaximumDistance(5);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  CHECK_EQUAL(view.Shaders, 0);
}

void TestOtherCamera(RelevoCheck& check, View& view)
{
  vtkNew<vtkCamera> other;
  other->DeepCopy(view.Renderer->GetActiveCamera());
  view.Renderer->SetActiveCamera(other);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
}

// Depth peeling and selection use the same camera many times.
void TestSameCamera(RelevoCheck& check, View& view)
{
  view.Renderer->UseDepthPeelingOn();
  view.Actor->GetProperty()->SetOpacity(0.5);
  view.Render();
  view.Render();
  CHECK_EQUAL(view.Selections, 0);
}

// An array of tags in the mesh has precedence and does not depend on the view.
void TestOwnTags(RelevoCheck& check, View& view, vtkPolyData* mesh)
{
  AddTags(mesh, 1, 3);
  mesh->Modified();
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  view.Renderer->GetActiveCamera()->Dolly(1.2);
  view.Render();
  CHECK(view.DidNothing());
}

// View-dependent levels.
void TestLevelsByView(RelevoCheck& check)
{
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(6);
  Mesh mesh = TexturedSphere(12, 8);
  View view(mesh);
  view.Recipe->SetMaximumLevel(6);
  view.Recipe->SetMetric(metric);
  TestCamera(check, view);
  TestPlacement(check, view);
  TestViewport(check, view);
  TestOtherMetric(check, view, metric);
  TestOtherCamera(check, view);
  TestSameCamera(check, view);
  TestOwnTags(check, view, mesh);
}

// Levels are cached for several cameras.
void TestSeveralCameras(RelevoCheck& check)
{
  vtkNew<vtkDistanceDepthTagMetric> metric;
  View view(TexturedSphere(12, 8));
  view.Recipe->SetMetric(metric);
  vtkNew<vtkRenderer> second;
  view.Renderer->SetViewport(0, 0, 0.5, 1);
  second->SetViewport(0.5, 0, 1, 1);
  second->AddActor(view.Actor);
  view.Window->AddRenderer(second);
  second->ResetCamera();
  second->GetActiveCamera()->Zoom(2);
  view.Render();
  CHECK_EQUAL(view.Selections, 2);
  view.Render();
  CHECK(view.DidNothing());
  second->GetActiveCamera()->Azimuth(20);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
  // A camera that is modified without a change.
  second->GetActiveCamera()->Modified();
  view.Renderer->GetActiveCamera()->Azimuth(20);
  view.Renderer->GetActiveCamera()->Azimuth(-20);
  view.Renderer->GetActiveCamera()->SetPosition(1, 2, 3);
  view.Render();
  CHECK_EQUAL(view.Selections, 1);
}

// Memory is that of the coarse mesh and one pattern, however many triangles are drawn.
void TestMemory(RelevoCheck& check, vtkDisplacement* displacement)
{
  Mesh plane = Plane(50, 40);
  const vtkTypeInt64 points = plane->GetNumberOfPoints();
  const vtkTypeInt64 faces = 2 * plane->GetNumberOfCells();
  View view(plane);
  view.Recipe->SetMaximumLevel(0);
  CHECK_EQUAL(view.Mapper->GetGraphicsMemorySize(), 0);
  view.Render();
  const vtkTypeInt64 coarse = view.Mapper->GetGraphicsMemorySize();
  CHECK_GREATER_EQUAL(coarse, points * 12 + faces * 12);
  CHECK_LESS_EQUAL(coarse, points * 100 + faces * 60);
  view.Recipe->SetMaximumLevel(6);
  view.Render();
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), faces * 4096);
  CHECK_LESS_EQUAL(view.Mapper->GetNumberOfDrawCalls(), 2);
  CHECK_EQUAL(view.Mapper->GetNumberOfUsedPatterns(), 1);
  const vtkTypeInt64 fine = view.Mapper->GetGraphicsMemorySize();
  CHECK_GREATER(fine, coarse);
  CHECK_LESS(fine, coarse + 200000);
  view.Recipe->SetDisplacement(displacement);
  view.Render();
  CHECK_GREATER_EQUAL(view.Mapper->GetGraphicsMemorySize(), fine + 20 * 30 * 4);
  view.Actor->ReleaseGraphicsResources(view.Window);
  CHECK_EQUAL(view.Mapper->GetGraphicsMemorySize(), 0);
  view.Render();
  CHECK_GREATER(view.Mapper->GetGraphicsMemorySize(), fine);
}
}

int TestAdaptiveRefinementMapperState(int, char*[])
{
  RelevoCheck check;
  const auto displacement = MakeDisplacement();
  TestDisplaced(check, displacement);
  TestLevelsByPlace(check);
  TestLevelsByView(check);
  TestSeveralCameras(check);
  TestMemory(check, displacement);
  return check.GetResult();
}
