// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoCaptureScene.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cmath>

using RelevoVectors::Vector;

RelevoCaptureScene::RelevoCaptureScene(int width, int height)
{
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(0.1, 0.2, 0.3);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(3.0, -5.0, 4.0);
  this->Renderer->AddLight(light);
  this->Source->SetRenderer(this->Renderer);
  this->Source->SetResolution(160, 120);
}

vtkActor* RelevoCaptureScene::Add(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.6, 0.3);
  this->Renderer->AddActor(actor);
  return actor;
}

void RelevoCaptureScene::ResetCamera()
{
  // Before its first frame, a window has no reliable size for vtkRenderer::ResetCamera().
  const vtkBoundingBox box(this->Renderer->ComputeVisiblePropBounds());
  double middle[3];
  box.GetCenter(middle);
  vtkCamera* camera = this->GetCamera();
  camera->SetFocalPoint(middle);
  camera->SetPosition(middle[0], middle[1], middle[2] + 2.0 * box.GetDiagonalLength());
  camera->SetParallelScale(0.5 * box.GetDiagonalLength());
  camera->Azimuth(35.0);
  camera->Elevation(25.0);
  this->Renderer->ResetCameraClippingRange();
}

vtkImageData* RelevoCaptureScene::Capture(unsigned int block)
{
  this->Source->Update();
  vtkMultiBlockDataSet* reliefs = this->Source->GetOutput();
  return block < reliefs->GetNumberOfBlocks() ? vtkImageData::SafeDownCast(reliefs->GetBlock(block))
                                              : nullptr;
}

RelevoPicture RelevoCaptureScene::Draw(vtkCamera* camera, int width, int height)
{
  const vtkSmartPointer<vtkCamera> before = this->GetCamera();
  int size[2];
  std::copy_n(this->Window->GetSize(), 2, size);
  this->Window->SetSize(width, height);
  this->Renderer->SetActiveCamera(camera);
  this->Renderer->ResetCameraClippingRange();
  this->Window->Render();
  RelevoPicture picture(this->Window);
  this->Renderer->SetActiveCamera(before);
  this->Window->SetSize(size);
  return picture;
}

std::vector<RelevoTexel> RelevoReadTexels(vtkImageData* relief)
{
  std::vector<RelevoTexel> texels;
  vtkDataArray* depths = relief->GetPointData()->GetArray("Depth");
  vtkDataArray* colors = relief->GetPointData()->GetArray("Color");
  vtkDataArray* normals = relief->GetPointData()->GetArray("Normals");
  vtkDataArray* m = relief->GetFieldData()->GetArray("ReliefMatrix");
  const bool isPerspective =
    relief->GetFieldData()->GetArray("ReliefProjection")->GetComponent(0, 0) == 1.0;
  int size[3];
  relief->GetDimensions(size);
  for (vtkIdType i = 0; i < relief->GetNumberOfPoints(); ++i)
  {
    const double d = depths->GetComponent(i, 0);
    if (!std::isfinite(d))
    {
      continue;
    }
    RelevoTexel texel{};
    texel.Column = static_cast<int>(i % size[0]);
    texel.Row = static_cast<int>(i / size[0]);
    const double factor = isPerspective ? d : 1.0;
    const double place[4] = { texel.Column * factor, texel.Row * factor, d, 1.0 };
    for (int row = 0; row < 3; ++row)
    {
      for (int k = 0; k < 4; ++k)
      {
        texel.Point[row] += m->GetVariantValue(4 * row + k).ToDouble() * place[k];
      }
      const double side = m->GetVariantValue(4 * row).ToDouble() * factor;
      texel.Width += side * side;
      texel.Color[row] = static_cast<unsigned char>(colors->GetComponent(i, row));
      texel.Normal[row] = normals ? normals->GetComponent(i, row) : 0.0;
    }
    texel.Width = std::sqrt(texel.Width);
    texels.push_back(texel);
  }
  return texels;
}

vtkSmartPointer<vtkPolyData> RelevoBumpyBall(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.0);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  vtkPolyData* ball = source->GetOutput();
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    Vector x;
    ball->GetPoint(i, x.data());
    const double radius = 1.0 + 0.15 * std::sin(5.0 * x[0]) * std::cos(4.0 * x[1] - 3.0 * x[2]);
    ball->GetPoints()->SetPoint(i, radius * x[0], radius * x[1], radius * x[2]);
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(ball);
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}
