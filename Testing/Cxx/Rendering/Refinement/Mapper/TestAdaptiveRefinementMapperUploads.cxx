// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves architecture.md: every change raises the mapper's modification time, and each kind of
// change uploads only the buffers and builds only the shaders that it requires.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPhongSurface.h"
#include "vtkPoints.h"
#include "vtkRefinementPatternTable.h"

namespace
{
using namespace RelevoMeshes;

// Detects when VTK last built its buffers.
class Mapper : public vtkAdaptiveRefinementMapper
{
public:
  static Mapper* New();
  vtkTypeMacro(Mapper, vtkAdaptiveRefinementMapper);
  vtkMTimeType GetVTKBuildTime()
  {
    vtkMTimeType time = this->VBOBuildTime;
    this->ForEachBlock([&time](vtkAdaptiveRefinementMapper* block)
      { time = std::max(time, static_cast<Mapper*>(block)->GetVTKBuildTime()); });
    return time;
  }
};
vtkStandardNewMacro(Mapper);

enum Work
{
  NOTHING,
  SHADERS,
  MESH // and shaders if necessary
};

// A scene with all parts that a recipe can have.
struct Scene
{
  explicit Scene(bool blocks)
    : Mesh(Plane(5, 4))
  {
    this->Heights->FillWaves();
    this->Displacement->SetHeightMap(this->Heights);
    this->Displacement->SetScale(0.1);
    this->Displacement->SetDirection(0, 0, 1);
    this->Metric->AddMetric(this->Distance);
    this->Recipe = MakeRecipe(2, this->Surface, this->Displacement);
    this->Recipe->SetMetric(this->Metric);
    vtkNew<vtkMultiBlockDataSet> both;
    both->SetBlock(0, this->Mesh);
    const double aside[3] = { 1.5, 0.0, 0.0 };
    both->SetBlock(1, Moved(this->Mesh, 1.0, aside, VTK_FLOAT));
    this->View.Add(blocks ? static_cast<vtkDataObject*>(both) : this->Mesh.Get(), this->Recipe);
    this->View.GetMapper(0)->SetLevelLookupTable(this->Table);
    this->View.ResetCameras();
    this->View.Render();
  }

  Mapper* GetMapper() { return static_cast<Mapper*>(this->View.GetMapper(0)); }

  RelevoMeshes::Mesh Mesh;
  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkPhongSurface> Surface;
  vtkNew<vtkCompositeDepthTagMetric> Metric;
  vtkNew<vtkDistanceDepthTagMetric> Distance;
  vtkNew<vtkLookupTable> Table;
  vtkSmartPointer<vtkAdaptiveRefinement> Recipe;
  RelevoScene View{ RelevoScene::Refining };
};

struct Change
{
  const char* Name;
  Work Expected;
  std::function<void(Scene&)> Make;
};

void Test(RelevoCheck& check, const Change& change, bool blocks)
{
  Scene scene(blocks);
  Mapper* mapper = scene.GetMapper();
  const auto fail = [&](const std::string& what)
  {
    check.Fail(
      __FILE__, __LINE__, std::string(change.Name) + (blocks ? ", blocks: " : ": ") + what);
  };
  const vtkIdType meshes = mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  const vtkMTimeType built = mapper->GetVTKBuildTime();
  const vtkMTimeType time = mapper->GetMTime();
  change.Make(scene);
  if (mapper->GetMTime() <= time)
  {
    fail("the modification time stays");
  }
  const vtkMTimeType changed = mapper->GetMTime();
  change.Make(scene);
  if (change.Expected != MESH && mapper->GetMTime() != changed)
  {
    fail("the same value raises the modification time");
  }
  scene.View.Render();
  scene.View.Render();
  const bool mesh =
    mapper->GetNumberOfBufferBuilds() != meshes || mapper->GetVTKBuildTime() != built;
  if (mesh != (change.Expected == MESH))
  {
    fail(mesh ? "the mesh is sent again" : "the mesh is not sent");
  }
  if (change.Expected == MESH && mapper->GetNumberOfBufferBuilds() != meshes + (blocks ? 2 : 1))
  {
    fail("the mesh is sent more than once");
  }
  const bool written = mapper->GetNumberOfShaderBuilds() != shaders;
  if (change.Expected != MESH && written != (change.Expected == SHADERS))
  {
    fail(written ? "shaders are written again" : "shaders are not written");
  }
}

const std::vector<Change>& GetChanges()
{
  static const std::vector<Change> changes = {
    // These are settings of the mapper.
    { "FrustumCulling", NOTHING, [](Scene& s) { s.GetMapper()->FrustumCullingOff(); } },
    { "BackFaceCulling", NOTHING, [](Scene& s) { s.GetMapper()->BackFaceCullingOn(); } },
    { "UseAllocatedRenderTime", NOTHING,
      [](Scene& s) { s.GetMapper()->UseAllocatedRenderTimeOff(); } },
    { "TargetNumberOfTriangles", NOTHING,
      [](Scene& s) { s.GetMapper()->SetTargetNumberOfTriangles(3000); } },
    { "SelectionDevice", NOTHING, [](Scene& s) { s.GetMapper()->SetSelectionDeviceToCPU(); } },
    { "LevelLookupTable", NOTHING, [](Scene& s) { s.GetMapper()->SetLevelLookupTable(nullptr); } },
    { "a colour of the table", NOTHING, [](Scene& s) { s.Table->SetHueRange(0.1, 0.2); } },
    { "Method", SHADERS, [](Scene& s) { s.GetMapper()->SetMethodToSUAPT(); } },
    { "ColorMode", SHADERS, [](Scene& s) { s.GetMapper()->SetColorModeToLevel(); } },
    { "a colour", NOTHING, [](Scene& s) { s.GetMapper()->SetBlockColor(0, 1.0, 0.0, 0.0); } },
    { "ScalarVisibility", MESH, [](Scene& s) { s.GetMapper()->ScalarVisibilityOff(); } },
    { "Modified", MESH, [](Scene& s) { s.GetMapper()->Modified(); } },
    // These belong to the recipe and its parts.
    { "LevelOffset", NOTHING, [](Scene& s) { s.Recipe->SetLevelOffset(0.5); } },
    { "MaximumLevel", NOTHING, [](Scene& s) { s.Recipe->SetMaximumLevel(3); } },
    { "pattern table", NOTHING, [](Scene& s) { s.Recipe->GetPatternTable()->SetMaximumLevel(1); } },
    { "Geomorphing", SHADERS,
      [](Scene& s) { s.Recipe->SetGeomorphing(vtkAdaptiveRefinement::GEOMORPHING_OFF); } },
    { "metric", NOTHING, [](Scene& s) { s.Distance->SetMaximumDistance(3.0); } },
    { "no metric, nothing to morph", SHADERS, [](Scene& s) { s.Recipe->SetMetric(nullptr); } },
    { "Alpha", NOTHING, [](Scene& s) { s.Surface->SetAlpha(0.3); } },
    { "Scale", NOTHING, [](Scene& s) { s.Displacement->SetScale(0.2); } },
    { "Offset", NOTHING, [](Scene& s) { s.Displacement->SetOffset(0.2); } },
    { "Direction", NOTHING, [](Scene& s) { s.Displacement->SetDirection(0, 1, 1); } },
    { "heights", MESH, [](Scene& s) { s.Heights->FillRandom(20, 30, 2); } },
    { "no surface", MESH, [](Scene& s) { s.Recipe->SetSurface(nullptr); } },
    { "no displacement", MESH, [](Scene& s) { s.Recipe->SetDisplacement(nullptr); } },
  };
  return changes;
}
}

int TestAdaptiveRefinementMapperUploads(int, char*[])
{
  RelevoCheck check;
  RelevoScene::NewMapper = [](vtkDataObject*) -> vtkAdaptiveRefinementMapper*
  { return Mapper::New(); };
  for (const Change& change : GetChanges())
  {
    for (const bool blocks : { false, true })
    {
      CHECK_CASE(blocks);
      Test(check, change, blocks);
    }
  }
  return check.GetResult();
}
