// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoScene.h"

#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkTestUtilities.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

RelevoPicture::RelevoPicture(vtkRenderWindow* window)
{
  std::copy_n(window->GetSize(), 2, this->Size);
  vtkNew<vtkUnsignedCharArray> colors;
  window->GetPixelData(0, 0, this->Size[0] - 1, this->Size[1] - 1, 0, colors);
  this->Colors.assign(colors->GetPointer(0), colors->GetPointer(0) + colors->GetNumberOfValues());
  vtkNew<vtkFloatArray> depths;
  window->GetZbufferData(0, 0, this->Size[0] - 1, this->Size[1] - 1, depths);
  this->Depths.assign(depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues());
}

RelevoPicture::RelevoPicture(int width, int height)
  : Size{ width, height }
  , Colors(static_cast<size_t>(3) * width * height, 0)
  , Depths(static_cast<size_t>(width) * height, 1.0f)
{
}

size_t RelevoPicture::CountForeground() const
{
  size_t count = 0;
  for (size_t i = 0; i < this->GetNumberOfPixels(); ++i)
  {
    count += std::equal(&this->Colors[0], &this->Colors[0] + 3, &this->Colors[3 * i]) ? 0 : 1;
  }
  return count;
}

void RelevoPicture::Save(const std::string& fileName) const
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(this->Size[0], this->Size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(this->Colors.begin(), this->Colors.end(),
    static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(image);
  writer->Write();
}

RelevoScene::RelevoScene(KindType kind)
  : Kind(kind)
{
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(300, 300);
  this->Renderer->SetBackground(0.1, 0.2, 0.3);
  this->AddRenderer(this->Renderer);
}

vtkActor* RelevoScene::Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe)
{
  return this->Add(this->Renderer, mesh, recipe);
}

vtkActor* RelevoScene::Add(
  vtkRenderer* renderer, vtkDataObject* mesh, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkActor> actor;
  if (this->Kind == Refining)
  {
    auto mapper = vtk::TakeSmartPointer(NewMapper(mesh));
    // Single pixels may differ, see TestAdaptiveRefinementMapperCulling.
    mapper->BackFaceCullingOff();
    vtkSmartPointer<vtkAdaptiveRefinement> used = recipe;
    if (!used)
    {
      used = vtkSmartPointer<vtkAdaptiveRefinement>::New();
      used->SetMaximumLevel(0);
    }
    mapper->SetRefinement(used);
    mapper->SetSelectionDevice(GetSelectionDevice());
    mapper->SetMethod(GetMethod());
    mapper->SetInputDataObject(mesh);
    actor->SetMapper(mapper);
  }
  else
  {
    vtkNew<vtkPolyDataMapper> mapper;
    vtkSmartPointer<vtkPolyData> whole = Append(mesh);
    if (recipe)
    {
      vtkNew<vtkAdaptiveRefinementFilter> filter;
      filter->SetRefinement(recipe);
      filter->SetInputData(whole);
      mapper->SetInputConnection(filter->GetOutputPort());
      this->Filters.push_back({ filter, { actor.Get(), renderer } });
    }
    else
    {
      mapper->SetInputData(whole);
    }
    actor->SetMapper(mapper);
  }
  renderer->AddActor(actor);
  this->Actors.push_back(actor.Get());
  return actor;
}

int RelevoScene::GetSelectionDevice()
{
  const char* device = std::getenv("RELEVO_TEST_SELECTION_DEVICE");
  return device ? std::atoi(device) : vtkAdaptiveRefinementMapper::SELECTION_DEVICE_AUTOMATIC;
}

int RelevoScene::GetMethod()
{
  const char* method = std::getenv("RELEVO_TEST_METHOD");
  return method ? std::atoi(method) : vtkAdaptiveRefinementMapper::METHOD_ARKFPI;
}

vtkRenderer* RelevoScene::AddRenderer(double xmin, double ymin, double xmax, double ymax)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(xmin, ymin, xmax, ymax);
  this->AddRenderer(renderer);
  return renderer;
}

void RelevoScene::UpdateFilters()
{
  for (auto& filter : this->Filters)
  {
    vtkActor* actor = filter.second.first;
    vtkRenderer* renderer = filter.second.second;
    filter.first->SetCamera(renderer->GetActiveCamera());
    filter.first->SetViewportSize(renderer->GetSize());
    vtkNew<vtkMatrix4x4> matrix;
    actor->GetMatrix(matrix);
    filter.first->SetModelToWorld(matrix);
  }
}

void RelevoScene::ResetCameras()
{
  for (vtkRenderer* renderer : this->Renderers)
  {
    this->UpdateFilters();
    renderer->ResetCamera();
    this->MoveCamera(renderer->GetActiveCamera());
    renderer->ResetCameraClippingRange();
  }
}

void RelevoScene::CopyCameras(const RelevoScene& other)
{
  for (size_t i = 0; i < this->Renderers.size(); ++i)
  {
    this->Renderers[i]->GetActiveCamera()->DeepCopy(other.Renderers[i]->GetActiveCamera());
  }
}

void RelevoScene::Render()
{
  this->UpdateFilters();
  this->Window->Render();
}

vtkIdType RelevoScene::CountTriangles()
{
  vtkIdType count = 0;
  for (vtkActor* actor : this->Actors)
  {
    if (auto* mapper = vtkAdaptiveRefinementMapper::SafeDownCast(actor->GetMapper()))
    {
      count += mapper->GetNumberOfDrawnTriangles() + mapper->GetNumberOfCulledTriangles();
    }
  }
  for (auto& filter : this->Filters)
  {
    count += filter.first->GetOutput()->GetNumberOfPolys();
  }
  return count;
}

vtkAdaptiveRefinementMapper* RelevoScene::GetMapper(size_t i)
{
  return vtkAdaptiveRefinementMapper::SafeDownCast(this->Actors[i]->GetMapper());
}

vtkSmartPointer<vtkPolyData> RelevoScene::Append(vtkDataObject* data)
{
  vtkSmartPointer<vtkPolyData> mesh = vtkPolyData::SafeDownCast(data);
  vtkCompositeDataSet* blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (mesh || !blocks)
  {
    return mesh;
  }
  vtkNew<vtkAppendPolyData> append;
  auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    append->AddInputDataObject(iterator->GetCurrentDataObject());
  }
  append->Update();
  return append->GetOutput();
}

void RelevoScene::AddRenderer(vtkRenderer* renderer)
{
  vtkNew<vtkCamera> camera;
  renderer->SetActiveCamera(camera);
  this->Window->AddRenderer(renderer);
  this->Renderers.push_back(renderer);
}

RelevoComparison::RelevoComparison(RelevoCheck& check, int argc, char* argv[])
  : Check(check)
{
  char* folder = vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", ".");
  this->Folder = folder;
  delete[] folder;
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == "--only")
    {
      this->Only = argv[i + 1];
    }
  }
}

bool RelevoComparison::Compare(const std::string& name, const RelevoTolerance& tolerance,
  const Builder& build, const std::vector<Step>& steps)
{
  if (!this->Only.empty() && name.find(this->Only) == std::string::npos)
  {
    return true;
  }
  RelevoScene twin(RelevoScene::Twin);
  build(twin);
  twin.ResetCameras();
  RelevoScene refining(RelevoScene::Refining);
  build(refining);
  bool same = this->CompareNow(name, tolerance, refining, twin);
  for (const Step& step : steps)
  {
    step.Change(twin);
    step.Change(refining);
    same = this->CompareNow(name + "." + step.Name, tolerance, refining, twin) && same;
  }
  return same;
}

bool RelevoComparison::Compare(const std::string& name, const RelevoTolerance& tolerance,
  const RelevoPicture& actual, const RelevoPicture& expected)
{
  if (actual.Size[0] != expected.Size[0] || actual.Size[1] != expected.Size[1])
  {
    return this->Check.Fail(__FILE__, __LINE__, name + ": pictures have different sizes");
  }
  // Other methods start a triangle at another corner, which may change the last bits.
  const bool isExact = RelevoScene::GetMethod() == vtkAdaptiveRefinementMapper::METHOD_ARKFPI;
  const double depthTolerance = tolerance.Depth + (isExact ? 0.0 : 2e-6);
  const size_t maximumPixels = tolerance.Pixels + (isExact ? 0 : 2);
  RelevoPicture difference(actual.Size[0], actual.Size[1]);
  size_t pixels = 0;
  int largestColor = 0;
  double largestDepth = 0.0;
  for (size_t i = 0; i < actual.GetNumberOfPixels(); ++i)
  {
    int color = 0;
    for (size_t c = 3 * i; c < 3 * i + 3; ++c)
    {
      color = std::max(color, std::abs(actual.Colors[c] - expected.Colors[c]));
    }
    const double depth = std::abs(static_cast<double>(actual.Depths[i]) - expected.Depths[i]);
    largestColor = std::max(largestColor, color);
    largestDepth = std::max(largestDepth, depth);
    if (color > tolerance.Color || !(depth <= depthTolerance))
    {
      ++pixels;
      difference.Colors[3 * i] = static_cast<unsigned char>(128 + std::min(color, 127));
      difference.Colors[3 * i + 1] = depth > depthTolerance ? 255 : 0;
    }
  }
  std::ostringstream text;
  text << name << ": " << pixels << " of " << actual.GetNumberOfPixels()
       << " pixels differ; largest difference of colours " << largestColor << ", of depths "
       << largestDepth;
  std::cout << text.str() << std::endl;
  // Empty pictures would always agree.
  if (expected.CountForeground() < expected.GetNumberOfPixels() / 1000)
  {
    return this->Check.Fail(__FILE__, __LINE__, name + ": the picture is almost empty");
  }
  if (pixels <= maximumPixels)
  {
    return true;
  }
  const std::string file = this->Folder + "/" + name;
  actual.Save(file + ".png");
  expected.Save(file + ".expected.png");
  difference.Save(file + ".difference.png");
  return this->Check.Fail(__FILE__, __LINE__, text.str() + "; see " + file + "*.png");
}

bool RelevoComparison::CompareNow(const std::string& name, const RelevoTolerance& tolerance,
  RelevoScene& refining, RelevoScene& twin)
{
  twin.Render();
  const RelevoPicture expected(twin.Window);
  refining.CopyCameras(twin);
  refining.Render();
  const RelevoPicture actual(refining.Window);
  bool same = this->Compare(name, tolerance, actual, expected);
  if (twin.GetNumberOfFilters() == refining.GetNumberOfActors() &&
    refining.CountTriangles() != twin.CountTriangles())
  {
    std::ostringstream text;
    text << name << ": " << refining.CountTriangles() << " triangles drawn, the filter has "
         << twin.CountTriangles();
    same = this->Check.Fail(__FILE__, __LINE__, text.str());
  }
  return same;
}
