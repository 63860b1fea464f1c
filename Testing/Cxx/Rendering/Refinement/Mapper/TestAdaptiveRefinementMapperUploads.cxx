// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves architecture.md: every change raises the mapper's modification time, and each kind of
// change uploads only the buffers and builds only the shaders that it requires. Other ranges and
// colours of a lookup table require none, and pictures do not depend on earlier ranges.
#include "RelevoPictures.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPhongSurface.h"
#include "vtkPointData.h"
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

// Values from 1000 to 1010 on a plane, with three components if the length is coloured.
RelevoMeshes::Mesh MakeValues(bool isVector)
{
  RelevoMeshes::Mesh mesh = Plane(5, 4);
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfComponents(isVector ? 3 : 1);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double value = 1000.0 + i % 11;
    isVector ? values->InsertNextTuple3(value, 1.0, 2.0) : values->InsertNextTuple1(value);
  }
  mesh->GetPointData()->SetScalars(values);
  return mesh;
}

struct Table
{
  double Range[2];
  double Hue; // of the last colour
  bool IsNarrow;
};

void TestTables(RelevoCheck& check, bool isVector, bool isTexture, bool hasBlocks)
{
  CHECK_CASE(isVector);
  CHECK_CASE(isTexture);
  CHECK_CASE(hasBlocks);
  const RelevoMeshes::Mesh mesh = MakeValues(isVector);
  const bool isNumber = !isVector || !isTexture; // without a texture, VTK colours by a component
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, mesh);
  const auto show = [&](RelevoScene& scene, const Table& table)
  {
    vtkNew<vtkLookupTable> colors;
    colors->SetVectorModeToMagnitude();
    if (scene.GetNumberOfActors() == 0)
    {
      scene.Add(hasBlocks ? static_cast<vtkDataObject*>(blocks) : mesh.Get(), MakeRecipe(2));
      scene.GetMapper(0)->SetLookupTable(colors);
      scene.GetMapper(0)->UseLookupTableScalarRangeOn();
      scene.GetMapper(0)->SetInterpolateScalarsBeforeMapping(isTexture);
      scene.ResetCameras();
    }
    auto* lookup = vtkLookupTable::SafeDownCast(scene.GetMapper(0)->GetLookupTable());
    lookup->SetTableRange(table.Range[0], table.Range[1]);
    lookup->SetHueRange(0.0, table.Hue);
    lookup->Build();
    scene.Render();
    return RelevoPicture(scene.Window);
  };
  RelevoScene dragged(RelevoScene::Refining);
  const RelevoPicture first = show(dragged, { { 1000.0, 1010.0 }, 0.6, false });
  vtkAdaptiveRefinementMapper* mapper = dragged.GetMapper(0);
  vtkIdType buffers = mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  CHECK_EQUAL(buffers, 1);
  for (const Table& table :
    { Table{ { 1002.0, 1007.0 }, 0.6, false }, Table{ { 1004.9, 1005.1 }, 0.6, false },
      Table{ { 0.0, 5000.0 }, 0.6, false }, Table{ { 0.0, 5000.0 }, 0.9, false },
      Table{ { 1005.0, 1005.001 }, 0.6, isNumber }, Table{ { 1000.0, 1010.0 }, 0.6, isNumber } })
  {
    CHECK_CASE(table.Range[1]);
    const RelevoPicture picture = show(dragged, table);
    buffers += table.IsNarrow ? 1 : 0; // otherwise, floats are not precise enough
    CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), buffers);
    CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
    RelevoScene fresh(RelevoScene::Refining);
    CHECK(RelevoPictures::Equal(picture, show(fresh, table)));
    CHECK(table.Range[1] == 1010.0 || !RelevoPictures::Equal(picture, first));
  }
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
  TestTables(check, false, false, false);
  TestTables(check, true, true, false);
  TestTables(check, false, true, true);
  TestTables(check, true, false, true);
  return check.GetResult();
}
