// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefCapture promises errors and warnings for scenes that it cannot capture, and for props
// that it leaves out.
#include "RelevoCaptureScene.h"
#include "RelevoWarnings.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor2D.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"

#include <cmath>
#include <limits>

namespace
{
bool Fails(vtkReliefCapture* source, const char* words)
{
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive());
  source->Update();
  return errors.Said(words) && source->GetOutput()->GetNumberOfBlocks() == 0;
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkReliefCapture> source;
  CHECK(Fails(source, "There is no renderer"));
  {
    vtkNew<vtkRenderer> renderer;
    source->SetRenderer(renderer);
    CHECK(Fails(source, "not in a window"));
  }
  CHECK_EQUAL(source->GetRenderer(), nullptr);
  CHECK(Fails(source, "There is no renderer"));

  RelevoCaptureScene scene;
  CHECK(Fails(scene.Source, "nothing to capture"));
  vtkActor* actor = scene.Add(RelevoBumpyBall(20));
  scene.ResetCamera();
  actor->VisibilityOff();
  CHECK(Fails(scene.Source, "nothing to capture"));
  actor->VisibilityOn();
  scene.Source->RemoveAllCameras();
  CHECK(Fails(scene.Source, "no cameras"));
  scene.Source->SetCamerasToBox();
  scene.Source->SetResolution(1000000, 8);
  CHECK(Fails(scene.Source, "1000000 x 8 texels is larger than the largest framebuffer"));
  scene.Source->SetResolution(32);
  CHECK_NOT_EQUAL(scene.Capture(), nullptr);
  RelevoErrors errors(scene.Source);
  scene.Source->SetResolution(0);
  CHECK(errors.Said("Resolution must be at least 1 x 1"));
  scene.Source->AddCamera(nullptr);
  CHECK(errors.Said("Cannot add the camera"));
  CHECK_EQUAL(scene.Source->GetNumberOfCameras(), 6);
}

// Cameras that see something give reliefs, whatever the others see.
void TestCameras(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Add(RelevoBumpyBall(20));
  scene.ResetCamera();
  vtkNew<vtkCamera> away;
  away->SetPosition(5.0, 0.0, 0.0);
  away->SetFocalPoint(10.0, 0.0, 0.0);
  scene.Source->AddCamera(away);
  {
    RelevoErrors executive(scene.Source->GetExecutive());
    RelevoErrors errors(scene.Source);
    scene.Source->Update();
    CHECK(errors.Said("None of the cameras sees anything"));
  }
  vtkNew<vtkCamera> singular;
  vtkNew<vtkMatrix4x4> zero;
  zero->Zero();
  singular->SetExplicitProjectionTransformMatrix(zero);
  singular->UseExplicitProjectionTransformMatrixOn();
  scene.Source->AddCamera(singular);
  scene.Source->AddCamera(scene.GetCamera());
  RelevoErrors errors(scene.Source);
  scene.Source->Update();
  CHECK(errors.Said("The matrices of camera 1 are singular"));
  vtkMultiBlockDataSet* output = scene.Source->GetOutput();
  CHECK_EQUAL(output->GetNumberOfBlocks(), 3);
  CHECK(!output->GetBlock(0) && !output->GetBlock(1) && output->GetBlock(2));
}

// The mapper of a volume that has bounds but draws nothing.
class BoxMapper : public vtkAbstractVolumeMapper
{
public:
  static BoxMapper* New();
  vtkTypeMacro(BoxMapper, vtkAbstractVolumeMapper);
  using Superclass::GetBounds;
  double* GetBounds() override { return this->Box; }
  void Render(vtkRenderer*, vtkVolume*) override {}
  void ReleaseGraphicsResources(vtkWindow*) override {}

private:
  double Box[6] = { -2.0, 2.0, -2.0, 2.0, -2.0, 2.0 };
};
vtkStandardNewMacro(BoxMapper);

void TestLeftOut(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Add(RelevoBumpyBall());
  scene.ResetCamera();
  scene.Source->AddCamera(scene.GetCamera());
  const std::vector<RelevoTexel> alone = RelevoReadTexels(scene.Capture());

  // Larger, translucent balls around it are not captured.
  for (int i = 0; i < 2; ++i)
  {
    vtkActor* pane = scene.Add(RelevoBumpyBall());
    pane->SetScale(1.5);
    pane->GetProperty()->SetOpacity(0.5);
  }
  vtkActor* hidden = scene.Add(RelevoBumpyBall());
  hidden->SetScale(1.4);
  hidden->VisibilityOff();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(RelevoBumpyBall());
  vtkNew<vtkActor2D> annotation;
  annotation->SetMapper(mapper);
  annotation->SetPosition(50.0, 50.0);
  scene.Renderer->AddViewProp(annotation);
  vtkNew<BoxMapper> box;
  vtkNew<vtkVolume> volume;
  volume->SetMapper(box);
  scene.Renderer->AddVolume(volume);
  RelevoWarnings warnings(scene.Source);
  const std::vector<RelevoTexel> again = RelevoReadTexels(scene.Capture());
  CHECK_EQUAL(warnings.Number, 1);
  CHECK_NOT_EQUAL(
    warnings.Text.find("translucent parts of 2 props, and 1 volumes"), std::string::npos);
  CHECK_EQUAL(again.size(), alone.size());
  for (size_t i = 0; i < std::min(again.size(), alone.size()); ++i)
  {
    CHECK_EQUAL(again[i].Point, alone[i].Point);
    CHECK(std::equal(again[i].Color, again[i].Color + 3, alone[i].Color));
  }
  // One message reports all of them.
  scene.Source->Modified();
  scene.Source->Update();
  CHECK_EQUAL(warnings.Number, 1);
  hidden->VisibilityOn();
  hidden->GetProperty()->SetOpacity(0.9);
  scene.Source->Update();
  CHECK_EQUAL(warnings.Number, 2);
}

// Texels where nothing is visible.
void TestBackground(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Add(RelevoBumpyBall());
  scene.ResetCamera();
  scene.Source->AddCamera(scene.GetCamera());
  vtkImageData* relief = scene.Capture();
  auto* depths = relief->GetPointData()->GetArray("Depth");
  auto* colors = vtkUnsignedCharArray::SafeDownCast(relief->GetPointData()->GetArray("Color"));
  auto* normals = relief->GetPointData()->GetArray("Normals");
  CHECK_EQUAL(depths->GetDataType(), VTK_FLOAT);
  CHECK_EQUAL(normals->GetDataType(), VTK_FLOAT);
  CHECK(colors && colors->GetNumberOfComponents() == 3);
  vtkIdType number = 0;
  for (vtkIdType i = 0; i < relief->GetNumberOfPoints(); ++i)
  {
    if (std::isnan(depths->GetComponent(i, 0)))
    {
      ++number;
      CHECK_EQUAL(colors->GetComponent(i, 0), 0.0);
      CHECK_EQUAL(normals->GetComponent(i, 0), 0.0);
    }
  }
  CHECK_GREATER(number, 10000);
  CHECK_LESS(number, 17000);
  CHECK(std::isnan(depths->GetComponent(0, 0)));
}
}

int TestReliefCaptureErrors(int, char*[])
{
  RelevoCheck check;
  TestErrors(check);
  TestCameras(check);
  TestLeftOut(check);
  TestBackground(check);
  return check.GetResult();
}
