// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefPass promises: still frames are those of the delegate pass, and moving frames show
// reliefs with all other props on top.
#include "RelevoPassScene.h"
#include "RelevoPictures.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor2D.h"
#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"
#include "vtkTesting.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <utility>

namespace
{
// Number of pixels whose colours differ by more than the tolerance.
size_t CountOthers(const RelevoPicture& a, const RelevoPicture& b, int tolerance)
{
  size_t count = 0;
  for (size_t i = 0; i < a.GetNumberOfPixels(); ++i)
  {
    bool differs = false;
    for (size_t k = 3 * i; k < 3 * i + 3; ++k)
    {
      differs = differs || std::abs(a.Colors[k] - b.Colors[k]) > tolerance;
    }
    count += differs;
  }
  return count;
}

void Keep(const RelevoPicture& picture, const std::string& name, char* argv[], int argc)
{
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, argv);
  picture.Save(std::string(testing->GetTempDirectory()) + "/TestReliefPass-" + name + ".png");
}

// A translucent pane in front, and a mark in the window's plane.
void AddOthers(RelevoPassScene& scene)
{
  vtkNew<vtkPlaneSource> pane;
  pane->SetOrigin(-1.0, -3.0, 0.8);
  pane->SetPoint1(2.0, -3.0, 0.3);
  pane->SetPoint2(-1.0, 3.0, 0.3);
  pane->Update();
  vtkActor* actor = scene.Add(pane->GetOutput());
  actor->GetProperty()->SetOpacity(0.4);
  actor->GetProperty()->SetColor(0.2, 0.2, 1.0);
  vtkNew<vtkPlaneSource> mark;
  mark->SetOrigin(10.0, 10.0, 0.0);
  mark->SetPoint1(40.0, 10.0, 0.0);
  mark->SetPoint2(10.0, 30.0, 0.0);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(mark->GetOutputPort());
  vtkNew<vtkActor2D> annotation;
  annotation->SetMapper(mapper);
  scene.Renderer->AddViewProp(annotation);
}

void TestStill(RelevoCheck& check)
{
  RelevoPassScene scene;
  AddOthers(scene);
  const RelevoPicture before = scene.DrawStill();
  CHECK_EQUAL(scene.Pass->GetNumberOfCaptures(), 0);
  scene.DrawMoving();
  CHECK_EQUAL(scene.Pass->GetNumberOfCaptures(), 1);
  CHECK(RelevoPictures::Equal(scene.DrawStill(), before));
  vtkNew<vtkRenderStepsPass> delegate;
  scene.Renderer->SetPass(delegate);
  CHECK(RelevoPictures::Equal(scene.DrawStill(), before));
  scene.Renderer->SetPass(scene.Pass);
  scene.Pass->SetDelegatePass(delegate);
  CHECK_EQUAL(scene.Pass->GetDelegatePass(), delegate);
  CHECK(RelevoPictures::Equal(scene.DrawStill(), before));
  scene.DrawMoving();
  CHECK(RelevoPictures::Equal(scene.DrawStill(), before));
  scene.Renderer->SetPass(nullptr);
  CHECK_EQUAL(CountOthers(scene.DrawStill(), before, 2), 0);
}

// At the camera of the capture, each texel covers one pixel.
void TestMoving(RelevoCheck& check, int argc, char* argv[])
{
  for (bool parallel : { false, true })
  {
    RelevoPassScene scene;
    AddOthers(scene);
    scene.GetCamera()->SetParallelScale(3.5);
    scene.GetCamera()->SetParallelProjection(parallel);
    const RelevoPicture still = scene.DrawStill();
    const RelevoPicture moving = scene.DrawMoving();
    Keep(still, parallel ? "still-parallel" : "still", argv, argc);
    Keep(moving, parallel ? "moving-parallel" : "moving", argv, argc);
    const size_t others = CountOthers(moving, still, 8);
    std::cout << others << " pixels of the moving picture differ from the still one\n";
    CHECK_LESS(others, 600); // among 30000 pixels, along silhouettes
    CHECK(!RelevoPictures::Equal(moving, still));

    scene.GetCamera()->Azimuth(6.0);
    const RelevoPicture turned = scene.DrawStill();
    const RelevoPicture shown = scene.DrawMoving();
    Keep(turned, parallel ? "turned-parallel" : "turned", argv, argc);
    Keep(shown, parallel ? "shown-parallel" : "shown", argv, argc);
    CHECK_LESS(CountOthers(shown, turned, 24), 1500);
  }
}

// Lines and points have no surface for reliefs, so they are drawn directly, alone and in
// assemblies.
void TestLines(RelevoCheck& check)
{
  RelevoPassScene scene;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.0, 0.0, 2.0);
  sphere->SetRadius(1.5);
  sphere->Update();
  vtkActor* wires = scene.Add(sphere->GetOutput());
  wires->GetProperty()->SetRepresentationToWireframe();
  vtkNew<vtkPolyData> edges;
  edges->SetPoints(sphere->GetOutput()->GetPoints());
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 30, 1 });
  edges->SetLines(lines);
  vtkActor* line = scene.Add(edges);
  line->SetPosition(1.0, 1.0, 0.0);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(line);
  scene.Renderer->RemoveActor(line);
  scene.Renderer->AddActor(assembly);
  scene.GetCamera()->Zoom(1.5);
  scene.Pass->SetMaximumHoleShare(1.0);
  scene.DrawMoving();
  scene.GetCamera()->Azimuth(2.0);
  const RelevoPicture still = scene.DrawStill();
  const RelevoPicture moving = scene.DrawMoving();
  CHECK_EQUAL(scene.Pass->GetNumberOfCaptures(), 1);
  wires->VisibilityOff();
  assembly->VisibilityOff();
  const RelevoPicture without = scene.DrawStill();
  size_t number = 0;
  size_t others = 0;
  for (size_t i = 0; i < still.GetNumberOfPixels(); ++i)
  {
    const auto isSame = [&](const RelevoPicture& other)
    { return std::equal(&still.Colors[3 * i], &still.Colors[3 * i] + 3, &other.Colors[3 * i]); };
    if (!isSame(without)) // a pixel of a line
    {
      ++number;
      others += !isSame(moving);
    }
  }
  std::cout << number << " pixels of lines, " << others << " differ\n";
  CHECK_GREATER(number, 500);
  CHECK_EQUAL(others, 0);
}

// Draws nothing and counts its calls.
class CountingMapper : public vtkAbstractVolumeMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkAbstractVolumeMapper);
  using Superclass::GetBounds;
  double* GetBounds() override { return this->Box; }
  void Render(vtkRenderer*, vtkVolume*) override { ++this->NumberOfFrames; }
  void ReleaseGraphicsResources(vtkWindow*) override {}
  int NumberOfFrames = 0;

private:
  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
};
vtkStandardNewMacro(CountingMapper);

void TestVolume(RelevoCheck& check)
{
  RelevoPassScene scene;
  vtkNew<CountingMapper> mapper;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  mapper->SetInputDataObject(image);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  scene.Renderer->AddVolume(volume);
  scene.DrawStill();
  CHECK_EQUAL(mapper->NumberOfFrames, 1);
  scene.DrawMoving();
  CHECK_EQUAL(scene.Pass->GetNumberOfCaptures(), 1);
  CHECK_EQUAL(mapper->NumberOfFrames, 2);
}

void TestWithoutProps(RelevoCheck& check)
{
  RelevoPassScene scene;
  scene.DrawMoving();
  CHECK_EQUAL(scene.CountCaptures(), 0);
  scene.Renderer->RemoveAllViewProps();
  CHECK_EQUAL(scene.DrawMoving().CountForeground(), 0);
  CHECK_EQUAL(scene.Pass->GetNumberOfCaptures(), 1);
  RelevoErrors errors(scene.Pass);
  AddOthers(scene); // no opaque props
  const RelevoPicture still = scene.DrawStill();
  CHECK(RelevoPictures::Equal(scene.DrawMoving(), still));
  CHECK_EQUAL(scene.Pass->GetNumberOfCaptures(), 1);
  CHECK(errors.None());
}

// Props and cells visible in an area.
std::set<std::pair<vtkProp*, vtkIdType>> Select(vtkRenderer* renderer)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(50, 50, 150, 100);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::set<std::pair<vtkProp*, vtkIdType>> result;
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto* prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; k < ids->GetNumberOfTuples(); ++k)
    {
      result.insert({ prop, ids->GetValue(k) });
    }
  }
  return result;
}

// Selections return the scene's props, as without the pass.
void TestSelection(RelevoCheck& check)
{
  RelevoPassScene scene;
  const RelevoPicture before = scene.DrawMoving();
  scene.Window->SetDesiredUpdateRate(15.0);
  const auto selected = Select(scene.Renderer);
  CHECK(RelevoPictures::Equal(scene.DrawMoving(), before));
  CHECK_EQUAL(scene.Pass->GetNumberOfCaptures(), 1);
  scene.Renderer->SetPass(nullptr);
  CHECK_GREATER(selected.size(), 100);
  CHECK_EQUAL(Select(scene.Renderer), selected);
}

// Each renderer of a window, in its part.
void TestParts(RelevoCheck& check)
{
  RelevoPassScene scene;
  scene.Renderer->SetViewport(0.5, 0.2, 1.0, 0.9);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->AddActor(scene.Ball);
  scene.Window->AddRenderer(other);
  scene.Window->Render();
  const RelevoPicture still = scene.DrawStill();
  const RelevoPicture moving = scene.DrawMoving();
  CHECK_LESS(CountOthers(moving, still, 8), 300);
  CHECK_EQUAL(CountOthers(RelevoPictures::Crop(moving, 0, 0, 100, 150),
                RelevoPictures::Crop(still, 0, 0, 100, 150), 0),
    0);
}
}

int TestReliefPass(int argc, char* argv[])
{
  RelevoCheck check;
  TestStill(check);
  TestMoving(check, argc, argv);
  TestLines(check);
  TestVolume(check);
  TestWithoutProps(check);
  TestSelection(check);
  TestParts(check);
  return check.GetResult();
}
