// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefCapture promises to capture every kind of opaque prop as it appears.
#include "RelevoCaptureScene.h"
#include "RelevoCompositeMapper.h"

#include "vtkAssembly.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkReliefMapper.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>

namespace
{
using namespace RelevoVectors;
using Builder = std::function<void(RelevoCaptureScene&)>;

// Colours of texels equal those of a window of the capture's size, wherever something is visible.
std::vector<RelevoTexel> CompareWithWindow(
  RelevoCheck& check, const std::string& name, const Builder& build)
{
  RelevoCaptureScene scene;
  build(scene);
  scene.ResetCamera();
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(scene.GetCamera());
  camera->Azimuth(10.0);
  scene.Source->AddCamera(camera);
  const std::vector<RelevoTexel> texels = RelevoReadTexels(scene.Capture());
  const RelevoPicture picture = scene.Draw(camera, 160, 120);
  size_t shown = 0;
  for (float z : picture.Depths)
  {
    shown += z < 1.0f;
  }
  size_t others = 0;
  bool hasNormals = true;
  for (const RelevoTexel& texel : texels)
  {
    const unsigned char* pixel = &picture.Colors[3 * (160 * texel.Row + texel.Column)];
    others += !std::equal(pixel, pixel + 3, texel.Color);
    hasNormals = hasNormals && std::abs(dot(texel.Normal, texel.Normal) - 1.0) < 1e-5;
  }
  std::cout << name << ": " << texels.size() << " texels, " << others << " of other colours\n";
  if (texels.size() < 500 || texels.size() != shown || others > 0 || !hasNormals)
  {
    check.Fail(__FILE__, __LINE__, name + ": the capture differs from the picture");
  }
  return texels;
}

vtkSmartPointer<vtkPolyData> MakeSphere(double x, double y, double z, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, y, z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(30);
  sphere->SetPhiResolution(30);
  sphere->Update();
  return sphere->GetOutput();
}

void BuildAssembly(RelevoCaptureScene& scene)
{
  vtkNew<vtkAssembly> assembly;
  for (int i = 0; i < 3; ++i)
  {
    vtkActor* part = scene.Add(MakeSphere(i, 0.0, 0.0, 0.6));
    part->GetProperty()->SetColor(0.3 * i, 0.5, 0.9);
    assembly->AddPart(part);
    scene.Renderer->RemoveActor(part);
  }
  assembly->SetScale(1.0, 2.0, 1.0);
  assembly->RotateZ(20.0);
  scene.Renderer->AddActor(assembly);
}

void BuildBlocks(RelevoCaptureScene& scene)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 3; ++i)
  {
    blocks->SetBlock(i, MakeSphere(i, 0.0, 0.2 * i, 0.6));
  }
  vtkNew<RelevoCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockColor(2, 1.0, 0.2, 0.1);
  mapper->SetBlockVisibility(3, false);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
}

void BuildGlyphs(RelevoCaptureScene& scene)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(RelevoBumpyBall(12));
  mapper->SetSourceData(MakeSphere(0.0, 0.0, 0.0, 0.2));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
}

void BuildTextured(RelevoCaptureScene& scene)
{
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  vtkActor* actor = scene.Add(plane->GetOutput());
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 48; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] =
      static_cast<unsigned char>(80 + (37 * i) % 170);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  actor->SetTexture(texture);
}

void BuildLines(RelevoCaptureScene& scene)
{
  scene.Add(RelevoBumpyBall(40))->GetProperty()->SetRepresentationToWireframe();
  vtkActor* edges = scene.Add(MakeSphere(1.5, 0.0, 0.0, 0.8));
  edges->GetProperty()->EdgeVisibilityOn();
  edges->GetProperty()->SetLineWidth(2.0);
}

// Capturing a relief gives the captured object.
void TestRelief(RelevoCheck& check)
{
  RelevoCaptureScene first;
  first.Add(RelevoBumpyBall());
  first.ResetCamera();
  first.Source->AddCamera(first.GetCamera());
  first.Source->SetResolution(320, 240);
  const vtkSmartPointer<vtkImageData> relief = first.Capture();
  const auto texels = CompareWithWindow(check, "relief",
    [&](RelevoCaptureScene& scene)
    {
      vtkNew<vtkReliefMapper> mapper;
      mapper->SetMethodToRayMarch();
      mapper->SetInputData(relief);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      scene.Renderer->AddActor(actor);
    });
  for (const RelevoTexel& texel : texels)
  {
    const Vector x = texel.Point;
    const double radius = std::sqrt(dot(x, x));
    const Vector unit = (1.0 / radius) * x;
    const double expected =
      1.0 + 0.15 * std::sin(5.0 * unit[0]) * std::cos(4.0 * unit[1] - 3.0 * unit[2]);
    // Triangles span 6 degrees, and texels are 0.03 wide.
    if (!CHECK_NEAR(radius, expected, 0.03))
    {
      return;
    }
  }
}
}

int TestReliefCaptureProps(int, char*[])
{
  RelevoCheck check;
  CompareWithWindow(check, "assembly", BuildAssembly);
  CompareWithWindow(check, "blocks", BuildBlocks);
  CompareWithWindow(check, "glyphs", BuildGlyphs);
  CompareWithWindow(check, "textured", BuildTextured);
  CompareWithWindow(check, "lines and edges", BuildLines);
  TestRelief(check);
  return check.GetResult();
}
