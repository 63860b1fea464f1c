// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that a mapper shared by several actors, renderers and windows draws each of them like a
// separate mapper.
#include "RelevoMethods.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"
#include "RelevoTextures.h"

#include "vtkCellArray.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using namespace RelevoMeshes;

const RelevoTolerance Tight{ 1, 5e-7, 0 };

// A sphere inside a polyline with vertices, with normals and texture coordinates.
Mesh MakeMesh()
{
  Mesh mesh = TexturedSphere(9, 7);
  vtkPointData* data = mesh->GetPointData();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> vertices;
  constexpr int NumberOfPoints = 12;
  lines->InsertNextCell(NumberOfPoints);
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / NumberOfPoints;
    const double normal[3] = { std::cos(angle), std::sin(angle), 0.0 };
    const vtkIdType point =
      mesh->GetPoints()->InsertNextPoint(0.8 * normal[0], 0.8 * normal[1], 0.1 * (i % 3));
    data->GetNormals()->InsertNextTuple(normal);
    data->GetTCoords()->InsertNextTuple2(i / 12.0, 0.5);
    lines->InsertCellPoint(point);
    vertices->InsertNextCell({ point });
  }
  mesh->SetLines(lines);
  mesh->SetVerts(vertices);
  return mesh;
}

// A combination of actor properties.
struct Look
{
  std::string Name;
  std::function<void(vtkActor*)> Apply;
};

std::vector<Look> MakeLooks()
{
  const auto with = [](void (*change)(vtkProperty*))
  { return [change](vtkActor* actor) { change(actor->GetProperty()); }; };
  return { { "Edges", with([](vtkProperty* p) { p->EdgeVisibilityOn(); }) },
    { "Vertices",
      with(
        [](vtkProperty* p)
        {
          p->EdgeVisibilityOn();
          p->VertexVisibilityOn();
          p->SetPointSize(6);
        }) },
    { "Surface", with([](vtkProperty* p) { p->SetColor(0.3, 0.5, 1.0); }) },
    { "Wireframe", with([](vtkProperty* p) { p->SetRepresentationToWireframe(); }) },
    { "Tubes",
      with(
        [](vtkProperty* p)
        {
          p->SetRepresentationToWireframe();
          p->RenderLinesAsTubesOn();
          p->SetLineWidth(4);
        }) },
    { "Points",
      with(
        [](vtkProperty* p)
        {
          p->SetRepresentationToPoints();
          p->SetPointSize(5);
        }) },
    { "Flat", with([](vtkProperty* p) { p->SetInterpolationToFlat(); }) },
    { "FlatWireframe",
      with(
        [](vtkProperty* p)
        {
          p->SetRepresentationToWireframe();
          p->SetInterpolationToFlat();
        }) },
    { "Unlit", with([](vtkProperty* p) { p->LightingOff(); }) },
    { "PBR", with([](vtkProperty* p) { p->SetInterpolationToPBR(); }) },
    { "Translucent", with([](vtkProperty* p) { p->SetOpacity(0.5); }) },
    { "Textured", [](vtkActor* actor) { actor->SetTexture(RelevoTextures::MakeMotley()); } },
    { "OwnShader",
      [](vtkActor* actor)
      {
        actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
          "//VTK::Light::Impl\n  gl_FragData[0].rgb = gl_FragData[0].bgr;\n", false);
      } },
    { "TwoSided",
      [](vtkActor* actor)
      {
        vtkNew<vtkProperty> back;
        back->SetColor(1, 0, 0);
        actor->SetBackfaceProperty(back);
        actor->GetProperty()->FrontfaceCullingOn();
      } } };
}

// Four actors with looks A and B: A on the left, B in the middle, where there are two lights, and
// both on the right.
class Scene : public RelevoScene
{
public:
  Scene(KindType kind, bool isShared, vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr)
    : RelevoScene(kind)
    , IsShared(isShared)
    , Data(mesh)
  {
    this->Window->SetSize(360, 120);
    this->Renderer->SetViewport(0, 0, 1.0 / 3.0, 1);
    vtkRenderer* middle = this->AddRenderer(1.0 / 3.0, 0, 2.0 / 3.0, 1);
    vtkRenderer* right = this->AddRenderer(2.0 / 3.0, 0, 1, 1);
    for (vtkRenderer* renderer : { this->Renderer.Get(), middle, right, right })
    {
      const bool isFirst = this->GetNumberOfActors() == 0;
      vtkActor* actor = this->Add(renderer, mesh, recipe);
      if (this->IsShared && !isFirst)
      {
        actor->SetMapper(this->GetActor(0)->GetMapper());
      }
    }
    this->GetActor(3)->SetPosition(0.3, 0.9, 0.2);
    for (const std::array<double, 3>& position :
      { std::array<double, 3>{ { 5, 1, 1 } }, std::array<double, 3>{ { -2, 3, 4 } } })
    {
      vtkNew<vtkLight> light;
      light->SetPosition(position.data());
      light->SetIntensity(0.6);
      middle->AddLight(light);
    }
  }

  void SetLooks(const Look& a, const Look& b)
  {
    for (size_t i = 0; i < 4; ++i)
    {
      vtkActor* actor = this->GetActor(i);
      vtkNew<vtkProperty> property;
      actor->SetProperty(property);
      actor->SetTexture(nullptr);
      actor->SetBackfaceProperty(nullptr);
      actor->GetShaderProperty()->ClearAllShaderReplacements();
      (i % 2 ? b : a).Apply(actor);
    }
  }

  // New mappers that have not drawn yet.
  void RenewMappers()
  {
    vtkSmartPointer<vtkMapper> last;
    for (size_t i = 0; i < 4; ++i)
    {
      if (!this->IsShared || !last)
      {
        last = this->MakeMapper(this->GetActor(i)->GetMapper());
      }
      this->GetActor(i)->SetMapper(last);
    }
  }

  void SwapProperties()
  {
    for (size_t i = 0; i < 4; i += 2)
    {
      vtkActor* a = this->GetActor(i);
      vtkActor* b = this->GetActor(i + 1);
      vtkSmartPointer<vtkProperty> property = a->GetProperty();
      a->SetProperty(b->GetProperty());
      b->SetProperty(property);
      vtkSmartPointer<vtkTexture> texture = a->GetTexture();
      a->SetTexture(b->GetTexture());
      b->SetTexture(texture);
    }
  }

  RelevoPicture Draw()
  {
    this->Render();
    return RelevoPicture(this->Window);
  }

private:
  vtkSmartPointer<vtkMapper> MakeMapper(vtkMapper* last)
  {
    if (this->Kind == Twin)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(last->GetInputConnection(0, 0));
      return mapper.Get();
    }
    auto mapper = vtk::TakeSmartPointer(NewMapper(this->Data));
    mapper->BackFaceCullingOff();
    mapper->SetRefinement(vtkAdaptiveRefinementMapper::SafeDownCast(last)->GetRefinement());
    mapper->SetSelectionDevice(GetSelectionDevice());
    mapper->SetMethod(GetMethod());
    mapper->SetInputDataObject(this->Data);
    return mapper;
  }

  const bool IsShared;
  vtkDataObject* Data;
};

// Pairs of looks, with new mappers or mappers that have drawn other looks. The references are
// separate mappers of VTK.
void TestLooks(RelevoComparison& comparison, const std::string& prefix, vtkPolyData* mesh,
  const std::vector<Look>& looks)
{
  Scene twin(RelevoScene::Twin, false, mesh);
  twin.ResetCameras();
  Scene scene(RelevoScene::Refining, true, mesh);
  scene.CopyCameras(twin);
  for (size_t a = 0; a < looks.size(); ++a)
  {
    for (size_t b = a + 1; b < looks.size(); ++b)
    {
      const std::string name = prefix + looks[a].Name + "." + looks[b].Name;
      const bool isNew = (a + b) % 2 == 0;
      // vtkPolyDataMapper does not detect that vertices become visible.
      twin.RenewMappers();
      if (isNew)
      {
        scene.RenewMappers();
      }
      twin.SetLooks(looks[a], looks[b]);
      scene.SetLooks(looks[a], looks[b]);
      const RelevoPicture expected = twin.Draw();
      for (int frame = 1; frame <= 3; ++frame)
      {
        comparison.Compare(name + ".Frame" + std::to_string(frame), Tight, scene.Draw(), expected);
      }
      scene.SwapProperties();
      twin.SwapProperties();
      twin.RenewMappers();
      comparison.Compare(name + ".Swapped", Tight, scene.Draw(), twin.Draw());
    }
  }
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeViewRecipe()
{
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(5);
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(3);
  recipe->SetMetric(metric);
  recipe->SetSurface(surface);
  return recipe.Get();
}

// Refined polydata and blocks, with every method and both selection devices, equal the pictures of
// separate mappers bit for bit.
void TestRefined(RelevoCheck& check, RelevoComparison& comparison)
{
  const std::vector<Look> looks = MakeLooks();
  const auto find = [&looks](const std::string& name)
  {
    return *std::find_if(
      looks.begin(), looks.end(), [&name](const Look& look) { return look.Name == name; });
  };
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeMesh());
  const double offset[3] = { 0.4, 0.2, 0.7 };
  blocks->SetBlock(1, Moved(MakeMesh(), 0.5, offset, VTK_FLOAT));
  Mesh mesh = MakeMesh();
  const auto recipe = MakeViewRecipe();
  using Mapper = vtkAdaptiveRefinementMapper;
  std::vector<int> methods = RelevoMethods::GetMethods();
  methods.push_back(Mapper::METHOD_HARDWARE_TESSELLATION);
  for (vtkDataObject* data :
    { static_cast<vtkDataObject*>(mesh.Get()), static_cast<vtkDataObject*>(blocks.Get()) })
  {
    Scene shared(RelevoScene::Refining, true, data, recipe);
    Scene separate(RelevoScene::Refining, false, data, recipe);
    separate.ResetCameras();
    shared.CopyCameras(separate);
    for (int method : methods)
    {
      for (int device : { Mapper::SELECTION_DEVICE_CPU, Mapper::SELECTION_DEVICE_GPU })
      {
        if (device == Mapper::SELECTION_DEVICE_GPU && method != Mapper::METHOD_ARKFPI)
        {
          continue; // not available
        }
        for (const auto& pair : { std::array<std::string, 2>{ { "Surface", "Wireframe" } },
               std::array<std::string, 2>{ { "Flat", "Edges" } },
               std::array<std::string, 2>{ { "Points", "Textured" } } })
        {
          for (Scene* scene : { &shared, &separate })
          {
            scene->RenewMappers();
            scene->SetLooks(find(pair[0]), find(pair[1]));
            for (size_t i = 0; i < scene->GetNumberOfActors(); ++i)
            {
              scene->GetMapper(i)->SetMethod(method);
              scene->GetMapper(i)->SetSelectionDevice(device);
            }
          }
          const std::string name = std::string("Shared.") + RelevoMethods::GetName(method) +
            (data == mesh ? "" : ".Blocks") + ".Device" + std::to_string(device) + "." + pair[0] +
            "." + pair[1];
          vtkIdType buffers = 0;
          vtkIdType shaders = 0;
          vtkIdType selections = 0;
          Mapper* mapper = shared.GetMapper(0);
          for (int frame = 1; frame <= 4; ++frame)
          {
            const RelevoPicture expected = separate.Draw();
            comparison.Compare(
              name + ".Frame" + std::to_string(frame), { 0, 0, 0 }, shared.Draw(), expected);
            if (frame >= 3 &&
              (mapper->GetNumberOfBufferBuilds() != buffers ||
                mapper->GetNumberOfShaderBuilds() != shaders ||
                mapper->GetNumberOfSelections() != selections))
            {
              check.Fail(__FILE__, __LINE__,
                name + ": built anew: " +
                  std::to_string(mapper->GetNumberOfBufferBuilds() - buffers) + " buffers, " +
                  std::to_string(mapper->GetNumberOfShaderBuilds() - shaders) + " shaders, " +
                  std::to_string(mapper->GetNumberOfSelections() - selections) + " selections");
            }
            buffers = mapper->GetNumberOfBufferBuilds();
            shaders = mapper->GetNumberOfShaderBuilds();
            selections = mapper->GetNumberOfSelections();
          }
        }
      }
    }
  }
}

// Windows by turns, in which two actors share their mapper. The other actors stay the same.
void TestWindows(RelevoComparison& comparison)
{
  const std::vector<Look> looks = MakeLooks();
  Mesh mesh = MakeMesh();
  const auto recipe = MakeViewRecipe();
  for (vtkAdaptiveRefinement* used : { static_cast<vtkAdaptiveRefinement*>(nullptr), recipe.Get() })
  {
    Scene first(RelevoScene::Refining, true, mesh, used);
    first.SetLooks(looks[0], looks[1]);
    first.ResetCameras();
    const RelevoPicture expected = first.Draw();
    Scene second(RelevoScene::Refining, true, mesh, used);
    second.CopyCameras(first);
    second.SetLooks(looks[0], looks[1]);
    // The middle actor keeps its mapper.
    for (size_t i : { 0, 2, 3 })
    {
      second.GetActor(i)->SetMapper(first.GetActor(0)->GetMapper());
    }
    const std::string name = used ? "Shared.WindowsRefined." : "Shared.Windows.";
    for (int frame = 1; frame <= 3; ++frame)
    {
      const std::string number = std::to_string(frame);
      comparison.Compare(name + "Second" + number, { 0, 0, 0 }, second.Draw(), expected);
      comparison.Compare(name + "First" + number, { 0, 0, 0 }, first.Draw(), expected);
    }
  }
}
}

int TestAdaptiveRefinementMapperShared(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  std::vector<Look> looks = MakeLooks();
  TestLooks(comparison, "Shared.Edges.", TexturedSphere(9, 7),
    { looks.begin(),
      std::find_if(
        looks.begin(), looks.end(), [](const Look& look) { return look.Name == "Tubes"; }) });
  // If there are lines and vertices, VTK 9.1 hides edges of other faces.
  looks.erase(looks.begin(), looks.begin() + 2);
  TestLooks(comparison, "Shared.", MakeMesh(), looks);
  TestRefined(check, comparison);
  TestWindows(comparison);
  return check.GetResult();
}
