// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of random actors, mappers, properties, cameras, renderers and windows. The same seed gives
// the same scene with refining mappers and with vtkPolyDataMapper.
#ifndef RelevoRandomScene_h
#define RelevoRandomScene_h

#include "RelevoRandomLook.h"
#include "RelevoScene.h"

#include <ostream>
#include <vector>

class RelevoRandomScene
{
public:
  // Adds renderers to the first window or to both. They are removed with the scene. The contents
  // are logged.
  RelevoRandomScene(unsigned int seed, RelevoScene::KindType kind,
    const std::vector<vtkRenderWindow*>& windows, std::ostream& log);
  ~RelevoRandomScene();
  RelevoRandomScene(const RelevoRandomScene&) = delete;
  void operator=(const RelevoRandomScene&) = delete;

  void Render();

  int GetLevel() const { return this->Choice.Level; }

  // In the order of the last frames.
  const std::vector<vtkRenderWindow*>& GetWindows() const { return this->Windows; }

  // Changes something before the next frame.
  void Change();

private:
  using Mesh = RelevoMeshes::Mesh;

  using Look = RelevoRandomLook::Look;

  // A mesh or blocks. All looks share one mapper; the twin has a mapper per actor.
  struct Group
  {
    std::vector<Look> Looks;
    std::vector<vtkSmartPointer<vtkPolyDataMapper>> Mappers;
    int Method = 0;
  };

  vtkRenderer* ChooseRenderer();

  static bool HasAnyOrder(const Group& group);

  void FillProperty(const Group& group, const Look& look);

  // Turns vertices on for good: VTK continues to draw vertices that are turned off.
  void AddVertices(const Group& group, const Look& look);

  // Two looks of one mesh never have the same position.
  void PlaceActors(const Group& group, const Look& look);

  void AddRenderers(vtkRenderWindow* window);

  Mesh MakeMesh();

  vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(const std::vector<Mesh>& meshes);

  void AddDisplacement(vtkAdaptiveRefinement* recipe, const std::vector<Mesh>& meshes);

  void AddActor();

  static void AddRefiningMapper(
    Group& group, const std::vector<Mesh>& meshes, vtkAdaptiveRefinement* recipe);

  void AddTwins(Group& group, const std::vector<Mesh>& meshes, vtkAdaptiveRefinement* recipe,
    int numberOfLooks);

  // Distributes the mappers. All looks share a refining mapper.
  void AddLooks(Group& group, int count);

  void Apply(Group& group, const std::vector<RelevoRandomMapping::Setting>& settings);

  void AddClippingPlane(Group& group);

  const RelevoScene::KindType Kind;
  std::vector<vtkRenderWindow*> Windows;
  RelevoRandomMapping::Limits Limits;
  RelevoDice Dice;
  RelevoRandomMapping::Choice Choice;
  std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
  std::vector<Group> Groups;
  std::vector<vtkSmartPointer<vtkAdaptiveRefinementFilter>> Filters;
};

#endif
