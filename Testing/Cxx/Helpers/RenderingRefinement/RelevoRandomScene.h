// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes made of random actors, mappers, properties, cameras, renderers and windows: the same for
// the same seed, once with refining mappers and once with vtkPolyDataMapper.
#ifndef RelevoRandomScene_h
#define RelevoRandomScene_h

#include "RelevoRandomLook.h"
#include "RelevoScene.h"

#include <ostream>
#include <vector>

class RelevoRandomScene
{
public:
  // Renderers are added to the first window, or to both, and leave them with the scene. What is
  // made is written down.
  RelevoRandomScene(unsigned int seed, RelevoScene::KindType kind,
    const std::vector<vtkRenderWindow*>& windows, std::ostream& log);
  ~RelevoRandomScene();
  RelevoRandomScene(const RelevoRandomScene&) = delete;
  void operator=(const RelevoRandomScene&) = delete;

  void Render();

  int GetLevel() const { return this->Choice.Level; }

  // In the order of the last frames.
  const std::vector<vtkRenderWindow*>& GetWindows() const { return this->Windows; }

  // Something else, before the next frame.
  void Change();

private:
  using Mesh = RelevoMeshes::Mesh;

  using Look = RelevoRandomLook::Look;

  // A mesh or blocks. One mapper for all looks; the twin has one for each actor.
  struct Group
  {
    std::vector<Look> Looks;
    std::vector<vtkSmartPointer<vtkPolyDataMapper>> Mappers;
    int Method = 0;
  };

  vtkRenderer* ChooseRenderer();

  static bool HasAnyOrder(const Group& group);

  void FillProperty(const Group& group, const Look& look);

  // Once and for all: VTK goes on drawing vertices that are no longer visible.
  void AddVertices(const Group& group, const Look& look);

  // Two looks of one mesh are never in one place.
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

  // The mappers go round: a refining one is shared by all looks.
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
