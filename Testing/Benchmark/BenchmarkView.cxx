// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkView.h"

#include "BenchmarkMeasure.h"

#include "OpenGL/ContextFacts.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkFloatArray.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#ifdef BENCHMARK_HAS_EGL
#include "vtkEGLOffscreenRenderWindow.h"
#endif

BenchmarkView::BenchmarkView(int width, int height)
  : Width(width)
  , Height(height)
{
#ifdef BENCHMARK_HAS_EGL
  this->Window = vtkSmartPointer<vtkEGLOffscreenRenderWindow>::New();
#else
  this->Window = vtkSmartPointer<vtkRenderWindow>::New();
  this->Window->SetOffScreenRendering(1);
#endif
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(this->Width, this->Height);
  this->Renderer->SetBackground(0.1, 0.1, 0.2);
  this->Window->AddRenderer(this->Renderer);
  this->Window->Render();
  this->Window->WaitForCompletion();
}

BenchmarkView::~BenchmarkView() = default;

vtkSmartPointer<vtkActor> BenchmarkView::AddActor(vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  return actor;
}

void BenchmarkView::LookAt(const double bounds[6])
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, -0.6, 1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  this->Renderer->ResetCamera(bounds);
  camera->Zoom(1.45);
}

void BenchmarkView::LookAway()
{
  // VTK would skip props out of view.
  this->Renderer->GetCullers()->RemoveAllItems();
  this->Renderer->GetActiveCamera()->Yaw(180.0);
}

void BenchmarkView::MoveCamera(double degrees)
{
  this->Renderer->GetActiveCamera()->Azimuth(degrees);
}

double BenchmarkView::TimeFrame()
{
  const Stopwatch stopwatch;
  this->Renderer->ResetCameraClippingRange();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return stopwatch.GetSeconds();
}

std::vector<unsigned char> BenchmarkView::GetPicture()
{
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, this->Width - 1, this->Height - 1, 0, pixels);
  return std::vector<unsigned char>(
    pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

std::vector<float> BenchmarkView::GetDepths()
{
  vtkNew<vtkFloatArray> depths;
  this->Window->GetZbufferData(0, 0, this->Width - 1, this->Height - 1, depths);
  return std::vector<float>(
    depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues());
}

std::string BenchmarkView::GetOpenGLRenderer()
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
  window->MakeCurrent();
  return window->GetState()->GetRenderer() + ", OpenGL " + window->GetState()->GetVersion() +
    (relevo::IsHardwareRenderer() ? ", hardware" : ", software");
}
