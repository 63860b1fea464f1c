// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that ordinary scenes give no errors, warnings or other output.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <iostream>
#include <sstream>

namespace
{
using namespace RelevoMeshes;

// Captures VTK's messages and standard error.
class Listener : public vtkOutputWindow
{
public:
  static Listener* New();
  vtkTypeMacro(Listener, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Text << text << "\n"; }
  std::ostringstream Text;

protected:
  Listener()
    : Last(std::cerr.rdbuf(this->Text.rdbuf()))
  {
  }
  ~Listener() override { std::cerr.rdbuf(this->Last); }
  std::streambuf* Last;
};
vtkStandardNewMacro(Listener);

// The messages while a scene is drawn three times in several ways.
std::string Listen(const RelevoComparison::Builder& build)
{
  vtkNew<Listener> listener;
  vtkOutputWindow::SetInstance(listener);
  {
    RelevoScene scene(RelevoScene::Refining);
    build(scene);
    scene.ResetCameras();
    scene.Render();
    scene.GetActor(0)->GetMapper()->SetScalarVisibility(false); // blocks inherit it
    scene.GetActor(0)->GetProperty()->SetRepresentationToWireframe();
    scene.Render();
    auto copy = vtk::TakeSmartPointer(scene.GetMapper(0)->NewInstance());
    copy->ShallowCopy(scene.GetMapper(0));
    scene.GetActor(0)->SetMapper(copy);
    scene.Render();
    std::ostringstream printed;
    copy->Print(printed);
  }
  vtkOutputWindow::SetInstance(nullptr);
  return listener->Text.str();
}

Mesh Vectors(Mesh mesh)
{
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Flow");
  FillVectors(
    mesh,
    [](const std::array<double, 3>& x) {
      return std::array<double, 3>{ { -x[1], x[0], 0.1 } };
    },
    vectors);
  mesh->GetPointData()->SetVectors(vectors);
  return mesh;
}
}

int TestAdaptiveRefinementMapperMessages(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<RelevoHeights> heights;
  heights->FillWaves();
  auto displacement = MakeDisplacementAlong(0, 0, 1, heights, 0.1);

  const double aside[3] = { 1.5, 0.0, 0.0 };
  Mesh other = Vectors(Moved(Sphere(7, 6), 1.0, aside, VTK_FLOAT));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Vectors(Sphere(8, 7)));
  blocks->SetBlock(2, other);
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, Vectors(Sphere(8, 7)));
  parts->SetPartition(1, other);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, parts);

  const struct
  {
    const char* Name;
    RelevoComparison::Builder Build;
  } scenes[] = {
    { "single", [&](RelevoScene& s) { s.Add(Vectors(Sphere(9, 7)), MakeRecipe(2, surface)); } },
    { "blocks", [&](RelevoScene& s) { s.Add(blocks, MakeRecipe(2, surface)); } },
    { "partitions", [&](RelevoScene& s) { s.Add(parts, MakeRecipe(2, surface)); } },
    { "collection", [&](RelevoScene& s) { s.Add(collection, MakeRecipe(1)); } },
    { "terrain",
      [&](RelevoScene& s) { s.Add(Vectors(Plane(4, 4)), MakeRecipe(4, nullptr, displacement)); } },
  };
  for (const auto& scene : scenes)
  {
    const std::string said = Listen(scene.Build);
    if (!said.empty())
    {
      check.Fail(__FILE__, __LINE__, std::string(scene.Name) + " says: " + said);
    }
  }

  // The actor's shader replacements apply to all its blocks.
  RelevoScene scene(RelevoScene::Refining);
  vtkActor* actor = scene.Add(blocks, MakeRecipe(0));
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  scene.ResetCameras();
  scene.Render();
  CHECK_EQUAL(actor->GetShaderProperty(), shaders);
  return check.GetResult();
}
