// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes made of random actors, mappers, properties, cameras and renderers: the same for the same
// seed, once with refining mappers and once with vtkPolyDataMapper.
#ifndef RelevoRandomScene_h
#define RelevoRandomScene_h

#include "RelevoRandomMapping.h"
#include "RelevoScene.h"

#include "vtkDisplacement.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <memory>
#include <ostream>
#include <string>
#include <vector>

class RelevoRandomScene
{
public:
  // Renderers are added to the window, and leave it with the scene. What is made is written down.
  RelevoRandomScene(
    unsigned int seed, RelevoScene::KindType kind, vtkRenderWindow* window, std::ostream& log)
    : Kind(kind)
    , Window(window)
    , Dice(seed)
    , Choice{ this->Dice, log, this->Dice.Throw(2) ? 2 : 0, this->IsTranslucent }
  {
    log << (this->Choice.Level ? "level 2\n" : "level 0\n");
    window->SetSize(64 + 16 * this->Dice.Throw(3), 48 + 16 * this->Dice.Throw(2));
    this->AddRenderers();
    for (int i = 1 + this->Dice.Throw(2); i > 0; --i)
    {
      this->AddActor();
    }
    for (vtkRenderer* renderer : this->Renderers)
    {
      this->PlaceCamera(renderer);
    }
  }
  ~RelevoRandomScene()
  {
    for (vtkRenderer* renderer : this->Renderers)
    {
      this->Window->RemoveRenderer(renderer);
    }
    this->Window->SetNumberOfLayers(1);
  }
  RelevoRandomScene(const RelevoRandomScene&) = delete;
  void operator=(const RelevoRandomScene&) = delete;

  void Render()
  {
    for (auto& filter : this->Filters)
    {
      filter->Update();
    }
    this->Window->Render();
  }

  int GetLevel() const { return this->Choice.Level; }

  // Something else, before the next frame.
  void Change()
  {
    this->Choice.Log << " then";
    Group& group =
      this->Groups[static_cast<size_t>(this->Dice.Throw(static_cast<int>(this->Groups.size())))];
    vtkRenderer* renderer = this->Renderers[static_cast<size_t>(
      this->Dice.Throw(static_cast<int>(this->Renderers.size())))];
    switch (this->Dice.Throw(6))
    {
      case 0:
        this->Choice.Log << " the window's size\n";
        this->Window->SetSize(50 + this->Dice.Throw(60), 40 + this->Dice.Throw(50));
        for (vtkRenderer* each : this->Renderers)
        {
          each->GetActiveCamera()->Modified(); // VTK 9.1 may keep the matrices of the old aspect
        }
        break;
      case 1:
        this->FillProperty(group.Actors.front()->GetProperty());
        break;
      case 2:
      {
        std::vector<RelevoRandomMapping::Setting> settings;
        RelevoRandomMapping::AddColorSettings(this->Choice, settings);
        this->Apply(group, settings);
        this->FillProperty(group.Actors.front()->GetProperty());
        break;
      }
      case 3:
        this->PlaceActors(group);
        break;
      case 4:
        this->AddClippingPlane(group);
        break;
      default:
        this->PlaceCamera(renderer);
    }
  }

private:
  using Mesh = RelevoMeshes::Mesh;

  // The actor of a mesh or of blocks; the twin has an actor for each block, of the same property.
  struct Group
  {
    std::vector<vtkSmartPointer<vtkActor>> Actors;
    std::vector<vtkPolyDataMapper*> Mappers;
  };

  void AddRenderers()
  {
    const int layout = this->Dice.Throw(5);
    this->Choice.Log << "layout " << layout << "\n";
    auto add = [this](double xmin, double xmax, int layer)
    {
      auto renderer = vtkSmartPointer<vtkRenderer>::New();
      vtkNew<vtkCamera> camera; // not from a reset of its own
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
      this->Window->AddRenderer(renderer);
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
      this->Window->SetNumberOfLayers(2);
      add(0.2, 0.9, 1);
    }
  }

  Mesh MakeMesh()
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
    this->HasOtherCells = this->HasOtherCells || mesh->GetNumberOfVerts() > 0;
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

  vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe()
  {
    vtkSmartPointer<vtkRefinementSurface> surface;
    if (this->Choice.Level > 0 && this->Dice.Throw(2))
    {
      surface = vtkSmartPointer<vtkPNTriangleSurface>::New();
      this->Choice.Log << "  PN triangles\n";
    }
    return RelevoMeshes::MakeRecipe(this->Choice.Level, surface);
  }

  void AddActor()
  {
    const bool isComposite = this->Dice.Once(4);
    const int numberOfBlocks = isComposite ? 2 : 1;
    this->Choice.Log << " actor of " << numberOfBlocks << "\n";
    vtkNew<vtkMultiBlockDataSet> blocks;
    std::vector<Mesh> meshes;
    for (int i = 0; i < numberOfBlocks; ++i)
    {
      meshes.push_back(this->MakeMesh());
      blocks->SetBlock(static_cast<unsigned int>(2 * i), meshes.back());
    }
    auto recipe = this->MakeRecipe();
    std::vector<RelevoRandomMapping::Setting> settings;
    RelevoRandomMapping::AddColorSettings(this->Choice, settings);
    const int method = this->Choice.Level == 0 ? this->Dice.Throw(6) : 0;
    const bool culls = this->Dice.Throw(2);

    Group group;
    vtkNew<vtkProperty> property;
    this->FillProperty(property);
    const auto add = [&](vtkPolyDataMapper* mapper)
    {
      auto actor = vtkSmartPointer<vtkActor>::New();
      actor->SetMapper(mapper);
      actor->SetProperty(property);
      group.Actors.push_back(actor);
      group.Mappers.push_back(mapper);
    };
    if (this->Kind == RelevoScene::Refining)
    {
      vtkNew<vtkAdaptiveRefinementMapper> mapper;
      mapper->SetRefinement(recipe);
      mapper->SetMethod(method);
      mapper->SetBackFaceCulling(culls);
      mapper->SetInputDataObject(
        isComposite ? blocks.Get() : static_cast<vtkDataObject*>(meshes.front()));
      add(mapper);
    }
    else
    {
      for (vtkPolyData* mesh : meshes)
      {
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
        add(mapper);
      }
    }
    this->Apply(group, settings);
    this->PlaceActors(group);
    this->AddTexture(group);
    vtkRenderer* renderer = this->Renderers[static_cast<size_t>(
      this->Dice.Throw(static_cast<int>(this->Renderers.size())))];
    for (vtkActor* actor : group.Actors)
    {
      renderer->AddActor(actor);
    }
    if (this->Dice.Once(4))
    {
      this->AddClippingPlane(group);
    }
    this->Groups.push_back(group);
  }

  void Apply(Group& group, const std::vector<RelevoRandomMapping::Setting>& settings)
  {
    for (vtkPolyDataMapper* mapper : group.Mappers)
    {
      for (const RelevoRandomMapping::Setting& set : settings)
      {
        set(mapper);
      }
    }
  }

  void AddTexture(Group& group)
  {
    if (this->Dice.Throw(6))
    {
      return;
    }
    this->Choice.Log << "  texture\n";
    vtkNew<vtkImageData> image;
    image->SetDimensions(8, 8, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, this->Dice.Throw(2) ? 3 : 4);
    auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < 64 * image->GetNumberOfScalarComponents(); ++i)
    {
      values[i] =
        static_cast<unsigned char>(i % 4 == 3 ? 255 * (i / 16 % 2) : this->Dice.Throw(256));
    }
    vtkNew<vtkTexture> texture;
    texture->SetInputData(image);
    texture->InterpolateOn();
    for (vtkActor* actor : group.Actors)
    {
      actor->SetTexture(texture);
    }
  }

  void FillProperty(vtkProperty* property)
  {
    RelevoDice& dice = this->Dice;
    property->SetColor(dice.Share(), dice.Share(), dice.Share());
    property->SetAmbient(0.3 * dice.Share());
    property->SetSpecular(dice.Throw(2) ? dice.Share() : 0.0);
    property->SetSpecularPower(1.0 + 20.0 * dice.Share());
    property->SetLighting(dice.Throw(5) != 0);
    property->SetInterpolation(dice.Throw(3));
    property->SetOpacity(dice.Throw(4) ? 1.0 : 0.2 + 0.7 * dice.Share());
    // OpenGL may draw a line there as other pixels than the line back, and refined edges need not
    // run as the filter's do; and the filter's triangles have diagonals that polygons have not.
    const bool hasLines = this->Choice.Level == 0;
    property->SetRepresentation(dice.Throw(4) ? VTK_SURFACE
        : hasLines && dice.Throw(2)           ? VTK_WIREFRAME
                                              : VTK_POINTS);
    // Where lines or points that overlap let through what is behind them, their order and number
    // show. VTK 9.1 draws other edges where a mesh has vertices or lines, too.
    const bool isOpaque = property->GetOpacity() == 1.0 && !this->IsTranslucent;
    property->SetRepresentation(isOpaque ? property->GetRepresentation() : VTK_SURFACE);
    property->SetEdgeVisibility(dice.Once(5) && !this->HasOtherCells && isOpaque && hasLines);
    property->SetEdgeColor(0.1, 0.1, dice.Share());
    property->SetVertexVisibility(
      this->Choice.Level == 0 && property->GetOpacity() == 1.0 && dice.Once(6));
    property->SetLineWidth(dice.Throw(2) && isOpaque ? 3.0f : 1.0f);
    property->SetPointSize(dice.Throw(2) ? 1.0f : 5.0f);
    property->SetRenderLinesAsTubes(dice.Once(8));
    property->SetRenderPointsAsSpheres(dice.Once(8));
    property->SetBackfaceCulling(dice.Once(5));
    property->SetFrontfaceCulling(!property->GetBackfaceCulling() && dice.Once(8));
    this->Choice.Log << "  property: representation " << property->GetRepresentation()
                     << " interpolation " << property->GetInterpolation() << " opacity "
                     << property->GetOpacity() << (property->GetLighting() ? "" : " unlit")
                     << (property->GetEdgeVisibility() ? " edges" : "")
                     << (property->GetVertexVisibility() ? " vertices" : "") << " line "
                     << property->GetLineWidth() << " point " << property->GetPointSize()
                     << (property->GetRenderLinesAsTubes() ? " tubes" : "")
                     << (property->GetRenderPointsAsSpheres() ? " spheres" : "")
                     << (property->GetBackfaceCulling() ? " no backs" : "")
                     << (property->GetFrontfaceCulling() ? " no fronts\n" : "\n");
  }

  void PlaceActors(Group& group)
  {
    RelevoDice& dice = this->Dice;
    const bool isMoved = dice.Throw(2);
    const double numbers[] = { dice.Signed(), dice.Signed(), dice.Signed(), 180.0 * dice.Signed(),
      dice.Once(4) ? -1.0 : 1.0, 0.5 + dice.Share() };
    for (vtkActor* actor : group.Actors)
    {
      actor->SetPosition(numbers[0], numbers[1], numbers[2]);
      actor->SetOrientation(0.0, numbers[3], 20.0);
      actor->SetScale(1.0, numbers[4], numbers[5]);
      if (!isMoved)
      {
        actor->SetPosition(0.0, 0.0, 0.0);
        actor->SetOrientation(0.0, 0.0, 0.0);
        actor->SetScale(1.0);
      }
    }
    this->Choice.Log << (isMoved ? "  moved\n" : "  not moved\n");
  }

  void AddClippingPlane(Group& group)
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

  // From outside, from near by, from inside, or cut by the near plane. The numbers do not depend on
  // bounds, which the two kinds of mapper need not agree on.
  void PlaceCamera(vtkRenderer* renderer)
  {
    RelevoDice& dice = this->Dice;
    const int way = dice.Throw(5);
    const double distances[] = { 3.0, 2.0, 1.4, 0.2, 1.5 };
    vtkCamera* camera = renderer->GetActiveCamera();
    const double direction[3] = { dice.Signed(), dice.Signed(), 0.3 + dice.Share() };
    const double length = distances[way] / vtkMath::Norm(direction);
    camera->SetFocalPoint(0.1 * dice.Signed(), 0.1, 0.0);
    camera->SetPosition(length * direction[0], length * direction[1], length * direction[2]);
    camera->SetViewUp(0.1, 1.0, 0.2);
    camera->SetParallelProjection(dice.Once(4));
    camera->SetParallelScale(0.3 + dice.Share());
    camera->SetViewAngle(20.0 + 60.0 * dice.Share());
    camera->SetWindowCenter(dice.Once(6) ? 0.4 : 0.0, 0.0);
    camera->SetClippingRange(way == 4 ? 1.0 + 0.6 * dice.Share() : 0.05, 10.0);
    camera->SetUserViewTransform(nullptr);
    if (dice.Once(10))
    {
      vtkNew<vtkTransform> sheared;
      sheared->Translate(0.2, -0.1, 0.3);
      sheared->RotateY(8.0);
      camera->SetUserViewTransform(sheared);
    }
    this->Choice.Log << " camera " << way << (camera->GetParallelProjection() ? " parallel" : "")
                     << (camera->GetUserViewTransform() ? " transformed\n" : "\n");
  }

  const RelevoScene::KindType Kind;
  vtkRenderWindow* Window;
  bool HasOtherCells = false; // than faces
  bool IsTranslucent = false; // by a table
  RelevoDice Dice;
  RelevoRandomMapping::Choice Choice;
  std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
  std::vector<Group> Groups;
  std::vector<vtkSmartPointer<vtkAdaptiveRefinementFilter>> Filters;
};

#endif
