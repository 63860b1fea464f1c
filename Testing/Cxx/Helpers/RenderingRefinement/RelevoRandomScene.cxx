// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoRandomScene.h"

#include "vtkDisplacement.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

RelevoRandomScene::RelevoRandomScene(unsigned int seed, RelevoScene::KindType kind,
  const std::vector<vtkRenderWindow*>& windows, std::ostream& log)
  : Kind(kind)
  , Dice(seed)
  , Choice{ this->Dice, log, this->Dice.Throw(2) ? 2 : 0, this->Limits }
{
  log << (this->Choice.Level ? "level 2\n" : "level 0\n");
  this->Windows.assign(windows.begin(), windows.begin() + (this->Dice.Once(4) ? 2 : 1));
  for (vtkRenderWindow* window : this->Windows)
  {
    window->SetSize(64 + 16 * this->Dice.Throw(3), 48 + 16 * this->Dice.Throw(2));
    this->AddRenderers(window);
  }
  for (int i = 1 + this->Dice.Throw(2); i > 0; --i)
  {
    this->AddActor();
  }
  for (vtkRenderer* renderer : this->Renderers)
  {
    RelevoRandomLook::PlaceCamera(this->Choice, renderer->GetActiveCamera());
  }
}

RelevoRandomScene::~RelevoRandomScene()
{
  for (vtkRenderWindow* window : this->Windows)
  {
    for (vtkRenderer* renderer : this->Renderers)
    {
      window->RemoveRenderer(renderer);
    }
    window->SetNumberOfLayers(1);
  }
}

void RelevoRandomScene::Render()
{
  for (auto& filter : this->Filters)
  {
    filter->Update();
  }
  const bool lastFirst = this->Dice.Throw(2);
  if (lastFirst)
  {
    std::reverse(this->Windows.begin(), this->Windows.end());
  }
  for (vtkRenderWindow* window : this->Windows)
  {
    window->Render();
  }
  this->Choice.Log << (lastFirst && this->Windows.size() > 1 ? " windows in turn\n" : "");
}

void RelevoRandomScene::Change()
{
  this->Choice.Log << " then";
  Group& group =
    this->Groups[static_cast<size_t>(this->Dice.Throw(static_cast<int>(this->Groups.size())))];
  Look& look =
    group.Looks[static_cast<size_t>(this->Dice.Throw(static_cast<int>(group.Looks.size())))];
  switch (this->Dice.Throw(6))
  {
    case 0:
      this->Choice.Log << " the window's size\n";
      this->Windows.front()->SetSize(50 + this->Dice.Throw(60), 40 + this->Dice.Throw(50));
      for (vtkRenderer* each : this->Renderers)
      {
        each->GetActiveCamera()->Modified(); // VTK 9.1 may keep matrices of the previous aspect
      }
      break;
    case 1:
      this->FillProperty(group, look);
      break;
    case 2:
    {
      std::vector<RelevoRandomMapping::Setting> settings;
      RelevoRandomMapping::AddColorSettings(this->Choice, settings);
      this->Apply(group, settings);
      for (Look& each : group.Looks)
      {
        this->FillProperty(group, each);
      }
      break;
    }
    case 3:
      this->PlaceActors(group, look);
      break;
    case 4:
      this->AddClippingPlane(group);
      break;
    default:
      RelevoRandomLook::PlaceCamera(this->Choice, this->ChooseRenderer()->GetActiveCamera());
  }
}

vtkRenderer* RelevoRandomScene::ChooseRenderer()
{
  return this
    ->Renderers[static_cast<size_t>(this->Dice.Throw(static_cast<int>(this->Renderers.size())))];
}

bool RelevoRandomScene::HasAnyOrder(const Group& group)
{
  return group.Method == vtkAdaptiveRefinementMapper::METHOD_SUAPT ||
    group.Method == vtkAdaptiveRefinementMapper::METHOD_UNIFORM;
}

void RelevoRandomScene::FillProperty(const Group& group, const Look& look)
{
  RelevoRandomLook::FillProperty(this->Choice, look.GetProperty(), HasAnyOrder(group));
}

void RelevoRandomScene::AddVertices(const Group& group, const Look& look)
{
  vtkProperty* property = look.GetProperty();
  property->SetVertexVisibility(this->Dice.Once(6) && this->Choice.Level == 0 &&
    !HasAnyOrder(group) && property->GetOpacity() == 1.0);
  this->Choice.Log << (property->GetVertexVisibility() ? "  vertices\n" : "");
}

void RelevoRandomScene::PlaceActors(const Group& group, const Look& look)
{
  RelevoRandomLook::PlaceActors(this->Choice, look, group.Looks.size() > 1);
}

void RelevoRandomScene::AddRenderers(vtkRenderWindow* window)
{
  const int layout = this->Dice.Throw(5);
  this->Choice.Log << "layout " << layout << "\n";
  auto add = [this, window](double xmin, double xmax, int layer)
  {
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    vtkNew<vtkCamera> camera; // prevents an automatic reset
    renderer->SetActiveCamera(camera);
    renderer->SetViewport(xmin, 0.0, xmax, 1.0);
    renderer->SetLayer(layer);
    renderer->SetBackground(0.2, 0.25, 0.3);
    renderer->SetUseDepthPeeling(1);
    renderer->SetMaximumNumberOfPeels(4);
    renderer->SetOcclusionRatio(0.0);
    renderer->SetTwoSidedLighting(this->Dice.Throw(5) != 0);
    if (this->Dice.Once(4))
    {
      vtkNew<vtkLight> light;
      light->SetPosition(3.0 * this->Dice.Signed(), 3.0, 2.0);
      light->SetPositional(this->Dice.Throw(2));
      light->SetColor(this->Dice.Share(), 1.0, this->Dice.Share());
      renderer->AddLight(light);
    }
    window->AddRenderer(renderer);
    this->Renderers.push_back(renderer);
  };
  if (layout == 0)
  {
    add(0.0, 0.45, 0);
    add(0.45, 1.0, 0);
    return;
  }
  add(0.0, 1.0, 0);
  if (layout == 1)
  {
    window->SetNumberOfLayers(2);
    add(0.2, 0.9, 1);
  }
}

RelevoRandomScene::Mesh RelevoRandomScene::MakeMesh()
{
  using namespace RelevoMeshes;
  RelevoDice& dice = this->Dice;
  const int kind = dice.Throw(14);
  Mesh mesh = kind == 0 ? Plane(3, 2)
    : kind == 1         ? Cube()
    : kind == 2         ? Cone()
    : kind == 3         ? Strips()
    : kind == 4         ? Mixed()
    : kind == 5         ? Moebius()
    : kind == 6         ? Torus(7, 5)
    : kind == 7         ? TexturedSphere(8, 6)
    : kind == 8         ? Explode(Sphere(7, 5))
    : kind == 9         ? NonManifold()
                        : Sphere(6 + dice.Throw(8), 5 + dice.Throw(5));
  const double centre[3] = { 0.6 * dice.Signed(), 0.6 * dice.Signed(), 0.6 * dice.Signed() };
  mesh = Moved(mesh, kind == 4 ? 0.3 : 1.0, centre, dice.Throw(2) ? VTK_DOUBLE : VTK_FLOAT);
  this->Limits.HasOtherCells = this->Limits.HasOtherCells || mesh->GetNumberOfVerts() > 0;
  const bool hasSplitPoints = kind == 1 || kind == 2 || kind == 7 || kind == 8;
  this->Limits.HasTies = this->Limits.HasTies || (this->Choice.Level > 0 && hasSplitPoints);
  const bool isFlat = dice.Once(6);
  for (vtkIdType i = 0; isFlat && i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    mesh->GetPoints()->SetPoint(i, x[0], x[1], 0.02 * x[2]);
  }
  const bool hasNormals = dice.Throw(4) != 0;
  if (!hasNormals)
  {
    mesh->GetPointData()->SetNormals(nullptr);
  }
  const bool isTagged = this->Choice.Level > 0 && dice.Throw(2);
  if (isTagged)
  {
    AddTags(mesh, static_cast<unsigned int>(dice.Throw(1000)), this->Choice.Level);
  }
  this->Choice.Log << "  mesh " << kind << (isFlat ? " flattened" : "")
                   << (hasNormals ? "" : " without normals") << (isTagged ? " tagged\n" : "\n");
  RelevoRandomMapping::AddScalars(this->Choice, mesh);
  return mesh;
}

vtkSmartPointer<vtkAdaptiveRefinement> RelevoRandomScene::MakeRecipe(
  const std::vector<Mesh>& meshes)
{
  vtkSmartPointer<vtkRefinementSurface> surface;
  if (this->Choice.Level > 0 && this->Dice.Throw(2))
  {
    surface = vtkSmartPointer<vtkPNTriangleSurface>::New();
    this->Choice.Log << "  PN triangles\n";
  }
  auto recipe = RelevoMeshes::MakeRecipe(this->Choice.Level, surface);
  if (this->Choice.Level > 0 && this->Dice.Once(4))
  {
    this->AddDisplacement(recipe, meshes);
  }
  return recipe;
}

void RelevoRandomScene::AddDisplacement(
  vtkAdaptiveRefinement* recipe, const std::vector<Mesh>& meshes)
{
  RelevoDice& dice = this->Dice;
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(0.2 * dice.Signed());
  displacement->SetScale(0.4 * dice.Share());
  const double direction[3] = { dice.Signed(), dice.Signed(), 1.0 };
  const bool alongNormal = dice.Throw(2);
  if (!alongNormal)
  {
    displacement->SetDirection(direction);
  }
  auto heights = vtk::TakeSmartPointer(RelevoHeights::New());
  heights->FillRandom(5, 4, static_cast<unsigned int>(dice.Throw(1000)));
  displacement->SetHeightMap(heights);
  for (vtkPolyData* mesh : meshes)
  {
    if (!mesh->GetPointData()->GetTCoords())
    {
      RelevoMeshes::AddTextureCoordinates(mesh,
        [](const double* x) {
          return std::array<double, 2>{ { 0.5 + 0.4 * x[0], 0.5 + 0.4 * x[1] } };
        });
    }
  }
  recipe->SetDisplacement(displacement);
  this->Choice.Log << (alongNormal ? "  displaced along normals\n" : "  displaced\n");
}

void RelevoRandomScene::AddActor()
{
  const int numberOfBlocks = this->Dice.Once(4) ? 2 : 1;
  const int numberOfLooks = this->Dice.Once(4) ? 2 : 1;
  this->Choice.Log << " actor of " << numberOfBlocks
                   << (numberOfLooks > 1 ? ", mapper shared\n" : "\n");
  std::vector<Mesh> meshes;
  for (int i = 0; i < numberOfBlocks; ++i)
  {
    meshes.push_back(this->MakeMesh());
  }
  auto recipe = this->MakeRecipe(meshes);
  std::vector<RelevoRandomMapping::Setting> settings;
  RelevoRandomMapping::AddColorSettings(this->Choice, settings);

  Group group;
  group.Method = this->Choice.Level == 0 ? this->Dice.Throw(6) : 0;
  const bool culls = this->Dice.Throw(2);
  this->Choice.Log << "  method " << group.Method << (culls ? " culls\n" : "\n");
  if (this->Kind == RelevoScene::Refining)
  {
    this->AddRefiningMapper(group, meshes, recipe);
    auto* mapper = vtkAdaptiveRefinementMapper::SafeDownCast(group.Mappers.front());
    mapper->SetMethod(group.Method);
    mapper->SetBackFaceCulling(culls);
  }
  else
  {
    this->AddTwins(group, meshes, recipe, numberOfLooks);
  }
  this->AddLooks(group, numberOfLooks);
  this->Apply(group, settings);
  for (Look& look : group.Looks)
  {
    this->FillProperty(group, look);
    this->AddVertices(group, look);
    this->PlaceActors(group, look);
    RelevoRandomLook::AddTexture(this->Choice, look);
    vtkRenderer* renderer = this->ChooseRenderer();
    for (vtkActor* actor : look.Actors)
    {
      renderer->AddActor(actor);
    }
  }
  if (this->Dice.Once(4))
  {
    this->AddClippingPlane(group);
  }
  this->Groups.push_back(group);
}

void RelevoRandomScene::AddRefiningMapper(
  Group& group, const std::vector<Mesh>& meshes, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (size_t i = 0; i < meshes.size(); ++i)
  {
    blocks->SetBlock(static_cast<unsigned int>(2 * i), meshes[i]);
  }
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  mapper->SetRefinement(recipe);
  mapper->SetInputDataObject(
    meshes.size() > 1 ? blocks.Get() : static_cast<vtkDataObject*>(meshes.front()));
  group.Mappers.push_back(mapper.Get());
}

void RelevoRandomScene::AddTwins(
  Group& group, const std::vector<Mesh>& meshes, vtkAdaptiveRefinement* recipe, int numberOfLooks)
{
  for (size_t i = 0; i < numberOfLooks * meshes.size(); ++i)
  {
    vtkPolyData* mesh = meshes[i % meshes.size()];
    vtkNew<vtkPolyDataMapper> mapper;
    if (this->Choice.Level > 0)
    {
      auto filter = vtkSmartPointer<vtkAdaptiveRefinementFilter>::New();
      filter->SetRefinement(recipe);
      filter->SetInputData(mesh);
      mapper->SetInputConnection(filter->GetOutputPort());
      this->Filters.push_back(filter);
    }
    else
    {
      mapper->SetInputData(mesh);
    }
    group.Mappers.push_back(mapper.Get());
  }
}

void RelevoRandomScene::AddLooks(Group& group, int count)
{
  const size_t most = std::max<size_t>(group.Mappers.size(), static_cast<size_t>(count));
  const size_t actors = most / static_cast<size_t>(count);
  for (size_t i = 0; i < most; ++i)
  {
    if (i % actors == 0)
    {
      group.Looks.emplace_back();
    }
    vtkNew<vtkActor> actor;
    actor->SetMapper(group.Mappers[i % group.Mappers.size()]);
    if (i % actors > 0)
    {
      actor->SetProperty(group.Looks.back().GetProperty());
    }
    group.Looks.back().Actors.push_back(actor.Get());
  }
}

void RelevoRandomScene::Apply(
  Group& group, const std::vector<RelevoRandomMapping::Setting>& settings)
{
  for (vtkPolyDataMapper* mapper : group.Mappers)
  {
    for (const RelevoRandomMapping::Setting& set : settings)
    {
      set(mapper);
    }
  }
}

void RelevoRandomScene::AddClippingPlane(Group& group)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(this->Dice.Signed(), this->Dice.Signed(), 0.3);
  plane->SetOrigin(0.2 * this->Dice.Signed(), 0.0, 0.0);
  for (vtkPolyDataMapper* mapper : group.Mappers)
  {
    mapper->RemoveAllClippingPlanes();
    mapper->AddClippingPlane(plane);
  }
  this->Choice.Log << "  clipped\n";
}
