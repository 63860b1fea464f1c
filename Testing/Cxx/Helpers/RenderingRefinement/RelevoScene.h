// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The same scene drawn by vtkAdaptiveRefinementMapper and by vtkPolyDataMapper, to compare.
#ifndef RelevoScene_h
#define RelevoScene_h

#include "RelevoCheck.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTestUtilities.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// What a window shows.
struct RelevoPicture
{
  int Size[2] = { 0, 0 };
  std::vector<unsigned char> Colors; // 3 per pixel
  std::vector<float> Depths;

  explicit RelevoPicture(vtkRenderWindow* window)
  {
    std::copy_n(window->GetSize(), 2, this->Size);
    vtkNew<vtkUnsignedCharArray> colors;
    window->GetPixelData(0, 0, this->Size[0] - 1, this->Size[1] - 1, 0, colors);
    this->Colors.assign(colors->GetPointer(0), colors->GetPointer(0) + colors->GetNumberOfValues());
    vtkNew<vtkFloatArray> depths;
    window->GetZbufferData(0, 0, this->Size[0] - 1, this->Size[1] - 1, depths);
    this->Depths.assign(depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues());
  }

  RelevoPicture(int width, int height)
    : Size{ width, height }
    , Colors(static_cast<size_t>(3) * width * height, 0)
    , Depths(static_cast<size_t>(width) * height, 1.0f)
  {
  }

  size_t GetNumberOfPixels() const { return this->Depths.size(); }

  // Pixels of another colour than the lower left one.
  size_t CountForeground() const
  {
    size_t count = 0;
    for (size_t i = 0; i < this->GetNumberOfPixels(); ++i)
    {
      count += std::equal(&this->Colors[0], &this->Colors[0] + 3, &this->Colors[3 * i]) ? 0 : 1;
    }
    return count;
  }

  void Save(const std::string& fileName) const
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
};

// How far two pictures may differ: pixels whose colour or depth differ by more are counted.
struct RelevoTolerance
{
  int Color = 0;
  double Depth = 0.0;
  size_t Pixels = 0;
};

// A window with renderers whose actors are refining (their mapper is a
// vtkAdaptiveRefinementMapper) or their twins (a vtkPolyDataMapper).
class RelevoScene
{
public:
  enum KindType
  {
    Refining,
    Twin
  };

  explicit RelevoScene(KindType kind)
    : Kind(kind)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(300, 300);
    this->Renderer->SetBackground(0.1, 0.2, 0.3);
    this->AddRenderer(this->Renderer);
  }

  // An actor of the mesh. Without a recipe its mapper refines to level 0, and the twin's draws the
  // coarse mesh; with one, the twin's draws what vtkAdaptiveRefinementFilter makes of the mesh.
  vtkActor* Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr)
  {
    return this->Add(this->Renderer, mesh, recipe);
  }
  vtkActor* Add(vtkRenderer* renderer, vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr)
  {
    vtkNew<vtkActor> actor;
    if (this->Kind == Refining)
    {
      auto mapper = vtk::TakeSmartPointer(NewMapper(mesh));
      mapper->BackFaceCullingOff(); // single pixels may differ: TestAdaptiveRefinementMapperCulling
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

  // The mapper of a refining actor. Tests of other modules run again with a subclass.
  inline static vtkAdaptiveRefinementMapper* (*NewMapper)(vtkDataObject*) = [](vtkDataObject*)
  { return vtkAdaptiveRefinementMapper::New(); };

  // Where faces choose their patterns: tests run again with RELEVO_TEST_SELECTION_DEVICE=2, for
  // the GPU.
  static int GetSelectionDevice()
  {
    const char* device = std::getenv("RELEVO_TEST_SELECTION_DEVICE");
    return device ? std::atoi(device) : vtkAdaptiveRefinementMapper::SELECTION_DEVICE_AUTOMATIC;
  }

  // How faces are drawn: tests run again with RELEVO_TEST_METHOD=4, for hardware tessellation.
  static int GetMethod()
  {
    const char* method = std::getenv("RELEVO_TEST_METHOD");
    return method ? std::atoi(method) : vtkAdaptiveRefinementMapper::METHOD_ARKFPI;
  }

  vtkRenderer* AddRenderer(double xmin, double ymin, double xmax, double ymax)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(xmin, ymin, xmax, ymax);
    this->AddRenderer(renderer);
    return renderer;
  }
  const std::vector<vtkRenderer*>& GetRenderers() const { return this->Renderers; }

  // What the mappers find out by themselves.
  void UpdateFilters()
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

  // See everything, from the side that MoveCamera says.
  void ResetCameras()
  {
    for (vtkRenderer* renderer : this->Renderers)
    {
      this->UpdateFilters();
      renderer->ResetCamera();
      this->MoveCamera(renderer->GetActiveCamera());
      renderer->ResetCameraClippingRange();
    }
  }

  void CopyCameras(const RelevoScene& other)
  {
    for (size_t i = 0; i < this->Renderers.size(); ++i)
    {
      this->Renderers[i]->GetActiveCamera()->DeepCopy(other.Renderers[i]->GetActiveCamera());
    }
  }

  void Render()
  {
    this->UpdateFilters();
    this->Window->Render();
  }

  // Triangles drawn, or polygons of the filters' outputs.
  vtkIdType CountTriangles()
  {
    vtkIdType count = 0;
    for (vtkActor* actor : this->Actors)
    {
      if (auto* mapper = vtkAdaptiveRefinementMapper::SafeDownCast(actor->GetMapper()))
      {
        count += mapper->GetNumberOfDrawnTriangles();
      }
    }
    for (auto& filter : this->Filters)
    {
      count += filter.first->GetOutput()->GetNumberOfPolys();
    }
    return count;
  }
  size_t GetNumberOfFilters() const { return this->Filters.size(); }
  size_t GetNumberOfActors() const { return this->Actors.size(); }
  vtkActor* GetActor(size_t i) { return this->Actors[i]; }
  vtkAdaptiveRefinementMapper* GetMapper(size_t i)
  {
    return vtkAdaptiveRefinementMapper::SafeDownCast(this->Actors[i]->GetMapper());
  }

  // All polydata of a composite data set in one.
  static vtkSmartPointer<vtkPolyData> Append(vtkDataObject* data)
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

  const KindType Kind;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  // Applied to each camera after it was reset to show everything.
  std::function<void(vtkCamera*)> MoveCamera = [](vtkCamera* camera)
  {
    camera->Azimuth(25.0);
    camera->Elevation(20.0);
  };

private:
  void AddRenderer(vtkRenderer* renderer)
  {
    vtkNew<vtkCamera> camera;
    renderer->SetActiveCamera(camera);
    this->Window->AddRenderer(renderer);
    this->Renderers.push_back(renderer);
  }

  std::vector<vtkRenderer*> Renderers;
  std::vector<vtkActor*> Actors;
  std::vector<
    std::pair<vtkSmartPointer<vtkAdaptiveRefinementFilter>, std::pair<vtkActor*, vtkRenderer*>>>
    Filters;
};

// Draws scenes twice and compares the pictures; keeps both and their difference when they differ.
class RelevoComparison
{
public:
  using Builder = std::function<void(RelevoScene&)>;

  RelevoComparison(RelevoCheck& check, int argc, char* argv[])
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

  bool Fail(const std::string& text) { return this->Check.Fail(__FILE__, __LINE__, text); }

  // To write into.
  const std::string& GetFolder() const { return this->Folder; }

  // A change of a scene that was drawn already.
  struct Step
  {
    std::string Name;
    Builder Change;
  };

  // Draw the scene with refining mappers and with their twins, from the same cameras; then again
  // after each step.
  bool Compare(const std::string& name, const RelevoTolerance& tolerance, const Builder& build,
    const std::vector<Step>& steps = {})
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

  bool Compare(const std::string& name, const RelevoTolerance& tolerance,
    const RelevoPicture& actual, const RelevoPicture& expected)
  {
    if (actual.Size[0] != expected.Size[0] || actual.Size[1] != expected.Size[1])
    {
      return this->Check.Fail(__FILE__, __LINE__, name + ": pictures of different size");
    }
    // Other methods start a triangle at another corner, which leaves the last bits open.
    const bool isExact = RelevoScene::GetMethod() == vtkAdaptiveRefinementMapper::METHOD_ARKFPI;
    const double depthTolerance = tolerance.Depth + (isExact ? 0.0 : 2e-6);
    const size_t mostPixels = tolerance.Pixels + (isExact ? 0 : 2);
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
      return this->Check.Fail(__FILE__, __LINE__, name + ": there is next to nothing to see");
    }
    if (pixels <= mostPixels)
    {
      return true;
    }
    const std::string file = this->Folder + "/" + name;
    actual.Save(file + ".png");
    expected.Save(file + ".expected.png");
    difference.Save(file + ".difference.png");
    return this->Check.Fail(__FILE__, __LINE__, text.str() + "; see " + file + "*.png");
  }

private:
  bool CompareNow(const std::string& name, const RelevoTolerance& tolerance, RelevoScene& refining,
    RelevoScene& twin)
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
      text << name << ": " << refining.CountTriangles() << " triangles drawn, the filter's are "
           << twin.CountTriangles();
      same = this->Check.Fail(__FILE__, __LINE__, text.str());
    }
    return same;
  }

  RelevoCheck& Check;
  std::string Folder;
  std::string Only;
};

#endif
