// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkBlockAttributesPolyDataMapper promises visibility, colour, opacity and pickability of blocks.
// Pictures, bounds and selections equal VTK's composite mapper at level 0, and separate actors at
// level 2. Pickers, counters and errors are tested too.
#include "RelevoCompositeMapper.h"
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkCellPicker.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkElevationFilter.h"
#include "vtkHardwareSelector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointPicker.h"
#include "vtkProperty.h"
#include "vtkVersionMacros.h"

#include <map>
#include <set>

namespace
{
// Whether colours of blocks override scalars in VTK's mapper: up to 9.3 they do, in 9.6 they do
// not.
constexpr bool ColorsWin = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0);

using namespace RelevoMeshes;

Mesh Place(Mesh mesh, double x, double y)
{
  const double offset[3] = { x, y, 0.0 };
  vtkNew<vtkElevationFilter> heights;
  heights->SetInputData(Moved(mesh, 1.0, offset, VTK_FLOAT));
  heights->SetLowPoint(0.0, 0.0, -0.5);
  heights->SetHighPoint(0.0, 0.0, 0.5);
  heights->Update();
  return vtkPolyData::SafeDownCast(heights->GetOutput());
}

// Flat indices: 0 all, 1 two spheres (2, 3), 4 an empty block, 5 a cube behind the first.
constexpr unsigned int All = 0;
constexpr unsigned int Spheres = 1;
constexpr unsigned int Left = 2;
constexpr unsigned int Right = 3;
constexpr unsigned int Nothing = 4;
constexpr unsigned int Box = 5;

struct Blocks
{
  Blocks()
  {
    this->Leaves[Left] = Place(Sphere(12, 9), 0.0, 0.0);
    this->Leaves[Right] = Place(Sphere(12, 9), 1.1, 0.0);
    this->Leaves[Box] = Place(Cube(), 0.5, 1.2);
    vtkNew<vtkMultiBlockDataSet> spheres;
    spheres->SetBlock(0, this->Leaves[Left]);
    spheres->SetBlock(1, this->Leaves[Right]);
    this->Data->SetNumberOfBlocks(3);
    this->Data->SetBlock(0, spheres);
    this->Data->SetBlock(2, this->Leaves[Box]);
  }
  vtkNew<vtkMultiBlockDataSet> Data;
  std::map<unsigned int, Mesh> Leaves;
};

void UsePeeling(RelevoScene& scene)
{
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->SetMaximumNumberOfPeels(20);
  scene.Renderer->SetOcclusionRatio(0.0);
  scene.Window->SetAlphaBitPlanes(1);
}

// The same blocks in a refining mapper at level 0 and in VTK's mapper.
struct Twins
{
  explicit Twins(Blocks& blocks)
  {
    this->Refining.Add(blocks.Data);
    this->Mapper = this->Refining.GetMapper(0);
    vtkActor* actor = this->Expected.Add(blocks.Data);
    this->Composite->SetInputDataObject(blocks.Data);
    this->Composite->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
    actor->SetMapper(this->Composite);
    for (RelevoScene* scene : { &this->Refining, &this->Expected })
    {
      UsePeeling(*scene);
      scene->ResetCameras();
      scene->GetActor(0)->GetProperty()->SetColor(0.9, 0.8, 0.7);
    }
    this->Refining.CopyCameras(this->Expected);
  }

  template <typename Change>
  void Do(const Change& change)
  {
    change(this->Mapper);
    change(this->Composite.Get());
  }

  void Compare(RelevoComparison& comparison, const std::string& name)
  {
    this->Refining.Render();
    this->Expected.Render();
    comparison.Compare("blocks." + name, { 1, 1e-6, 3 }, RelevoPicture(this->Refining.Window),
      RelevoPicture(this->Expected.Window));
  }

  RelevoScene Refining{ RelevoScene::Refining };
  RelevoScene Expected{ RelevoScene::Twin };
  vtkAdaptiveRefinementMapper* Mapper;
  vtkNew<RelevoCompositeMapper> Composite;
};

std::set<int> FindBlocks(const std::vector<RelevoPicks::Hit>& hits)
{
  std::set<int> blocks;
  for (const RelevoPicks::Hit& hit : hits)
  {
    blocks.insert(hit.Block);
  }
  blocks.erase(-1);
  return blocks;
}

void ComparePictures(RelevoCheck& check, RelevoComparison& comparison)
{
  Blocks blocks;
  Twins twins(blocks);
  twins.Compare(comparison, "plain");
  const vtkIdType uploads = twins.Mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = twins.Mapper->GetNumberOfShaderBuilds();
  const vtkIdType triangles = twins.Mapper->GetNumberOfDrawnTriangles();

  twins.Do([](auto* mapper) { mapper->SetBlockVisibility(Right, false); });
  twins.Compare(comparison, "hidden");
  CHECK_EQUAL(twins.Mapper->GetNumberOfDrawnTriangles(),
    triangles - blocks.Leaves[Right]->GetNumberOfPolys());
  twins.Do([](auto* mapper) { mapper->SetBlockVisibility(Spheres, false); });
  twins.Do([](auto* mapper) { mapper->SetBlockVisibility(Right, true); });
  twins.Compare(comparison, "shownInHidden");
  double expected[6];
  double bounds[6];
  twins.Composite->GetBounds(expected);
  twins.Mapper->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    CHECK_NEAR(bounds[i], expected[i], 1e-5);
  }
  CHECK_GREATER(bounds[0], -0.1); // where the left sphere is
  twins.Do([](auto* mapper) { mapper->RemoveBlockVisibility(Spheres); });
  twins.Compare(comparison, "shownAgain");

  twins.Do([](auto* mapper) { mapper->SetBlockColor(Spheres, 0.1, 0.9, 0.2); });
  twins.Do([](auto* mapper) { mapper->SetBlockColor(Right, 0.2, 0.3, 1.0); });
  if (ColorsWin)
  {
    twins.Compare(comparison, "coloured");
  }
  CHECK_EQUAL(twins.Mapper->GetBlockColor(Right)[2], 1.0);
  twins.Do([](auto* mapper) { mapper->RemoveBlockColor(Right); });
  twins.Do([](auto* mapper) { mapper->SetBlockColor(Box, 1.0, 0.0, 0.0); });
  if (ColorsWin)
  {
    twins.Compare(comparison, "colouredOtherwise");
  }
  twins.Do([](auto* mapper) { mapper->RemoveBlockColors(); });
  CHECK_EQUAL(twins.Mapper->GetNumberOfShaderBuilds(), shaders);

  twins.Do([](auto* mapper) { mapper->SetBlockOpacity(Spheres, 0.4); });
  twins.Compare(comparison, "translucent");
  CHECK(twins.Refining.GetActor(0)->HasTranslucentPolygonalGeometry());
  CHECK(twins.Refining.GetActor(0)->HasOpaqueGeometry());
  twins.Do([](auto* mapper) { mapper->SetBlockOpacity(Right, 1.0); });
  twins.Do([](auto* mapper) { mapper->SetBlockColor(Left, 1.0, 1.0, 0.0); });
  if (ColorsWin)
  {
    twins.Compare(comparison, "opaqueInTranslucent");
  }
  CHECK_EQUAL(twins.Mapper->GetBlockOpacity(Spheres), 0.4);
  twins.Do([](auto* mapper) { mapper->SetBlockVisibility(Left, false); });
  twins.Compare(comparison, "onlyOpaque");
  CHECK(!twins.Refining.GetActor(0)->HasTranslucentPolygonalGeometry());
  twins.Do(
    [](auto* mapper)
    {
      mapper->RemoveBlockOpacities();
      mapper->RemoveBlockColors();
      mapper->RemoveBlockVisibilities();
    });
  twins.Compare(comparison, "plainAgain");
  CHECK_EQUAL(twins.Mapper->GetNumberOfBufferBuilds(), uploads);
}

// Hardware selection, and VTK's other pickers.
void ComparePicks(RelevoCheck& check)
{
  Blocks blocks;
  Twins twins(blocks);
  twins.Mapper->SetCompositeDataDisplayAttributes(
    twins.Composite->GetCompositeDataDisplayAttributes());
  vtkCompositeDataDisplayAttributes* attributes = twins.Mapper->GetCompositeDataDisplayAttributes();
  const auto select = [&](RelevoScene& scene)
  { return RelevoPicks::SelectPixels(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS); };
  const auto compare = [&](const std::set<int>& expected)
  {
    twins.Refining.Render();
    twins.Expected.Render();
    const auto hits = select(twins.Refining);
    const auto expectedHits = select(twins.Expected);
    int differing = 0; // on silhouettes, within rounding
    for (size_t i = 0; i < hits.size(); ++i)
    {
      differing += hits[i] == expectedHits[i] ? 0 : 1;
    }
    CHECK_LESS_EQUAL(differing, 3);
    CHECK_EQUAL(FindBlocks(hits), expected);
    // A ray passes through the centre of each block.
    vtkRenderer* renderer = twins.Refining.Renderer;
    for (const auto& leaf : blocks.Leaves)
    {
      double center[3];
      leaf.second->GetCenter(center);
      renderer->SetWorldPoint(center[0], center[1], center[2], 1.0);
      renderer->WorldToDisplay();
      double display[3];
      renderer->GetDisplayPoint(display);
      const bool isHit = expected.count(static_cast<int>(leaf.first)) > 0;
      vtkNew<vtkCellPicker> cells;
      cells->Pick(display[0], display[1], 0.0, renderer);
      CHECK_EQUAL((cells->GetFlatBlockIndex() == static_cast<vtkIdType>(leaf.first)), isHit);
      vtkNew<vtkPointPicker> points;
      points->SetTolerance(0.1);
      points->Pick(display[0], display[1], 0.0, renderer);
      const int block = static_cast<int>(points->GetFlatBlockIndex());
      CHECK(expected.count(block) || (block < 0 && !isHit)); // one of those in front
    }
  };
  compare({ Left, Right, Box });
  attributes->SetBlockPickability(blocks.Leaves[Right], false);
  compare({ Left, Box });
  const vtkIdType triangles = twins.Mapper->GetNumberOfDrawnTriangles();
  attributes->SetBlockPickability(blocks.Data->GetBlock(0), false);
  attributes->SetBlockPickability(blocks.Leaves[Right], true);
  compare({ Right, Box });
  // They are drawn although they cannot be picked.
  CHECK_EQUAL(twins.Mapper->GetNumberOfDrawnTriangles(), triangles);
  twins.Do([](auto* mapper) { mapper->SetBlockVisibility(Right, false); });
  compare({ Box });
}

// At level 2, each block looks like a separate actor, also if the actor is translucent.
void CompareActors(RelevoComparison& comparison, double opacity, const std::string& name)
{
  struct Look
  {
    double Color[3];
    double Opacity;
  };
  const std::map<unsigned int, Look> looks = {
    { Left, { { 1.0, 0.3, 0.2 }, 0.5 } }, { Right, { { 0.2, 0.8, 0.3 }, 1.0 } },
    { Box, { { 0.9, 0.8, 0.7 }, opacity } }, // without attributes of the block
  };
  Blocks blocks;
  vtkNew<vtkPNTriangleSurface> surface;
  const auto recipe = MakeRecipe(2, surface);
  RelevoScene together(RelevoScene::Refining);
  RelevoScene apart(RelevoScene::Refining);
  vtkActor* actor = together.Add(blocks.Data, recipe);
  actor->GetProperty()->SetColor(0.9, 0.8, 0.7);
  actor->GetProperty()->SetOpacity(opacity);
  vtkAdaptiveRefinementMapper* mapper = together.GetMapper(0);
  mapper->ScalarVisibilityOff();
  for (const auto& look : looks)
  {
    if (look.first != Box)
    {
      mapper->SetBlockColor(look.first, look.second.Color);
      mapper->SetBlockOpacity(look.first, look.second.Opacity);
    }
    vtkActor* part = apart.Add(blocks.Leaves[look.first], recipe);
    part->GetMapper()->ScalarVisibilityOff();
    part->GetProperty()->SetColor(look.second.Color[0], look.second.Color[1], look.second.Color[2]);
    part->GetProperty()->SetOpacity(look.second.Opacity);
  }
  for (RelevoScene* scene : { &together, &apart })
  {
    UsePeeling(*scene);
    scene->ResetCameras();
  }
  apart.CopyCameras(together);
  together.Render();
  apart.Render();
  // Translucent actors write no depths.
  comparison.Compare("blocks." + name, { 2, opacity < 1.0 ? 1.0 : 1e-6, 5 },
    RelevoPicture(together.Window), RelevoPicture(apart.Window));
}

void CheckSettings(RelevoCheck& check)
{
  Blocks blocks;
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(blocks.Data);
  vtkAdaptiveRefinementMapper* mapper = scene.GetMapper(0);
  RelevoErrors errors(mapper);
  CHECK(!mapper->GetCompositeDataDisplayAttributes());
  CHECK(mapper->GetBlockVisibility(Left) && mapper->GetBlockOpacity(Left) == 1.0);
  CHECK_EQUAL(mapper->GetBlockColor(Left)[0], 1.0);
  mapper->SetBlockColor(6, 1.0, 0.0, 0.0);
  CHECK(errors.Said("There is no block with flat index 6: the input has fewer"));
  CHECK(!mapper->GetCompositeDataDisplayAttributes());
  mapper->SetBlockOpacity(Nothing, 0.5);
  mapper->SetBlockVisibility(All, false);
  CHECK(errors.None() && mapper->GetCompositeDataDisplayAttributes());
  CHECK(!mapper->GetBlockVisibility(All) && mapper->GetBlockOpacity(Left) == 1.0);
  scene.ResetCameras();
  scene.Render();
  CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), 0);
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), 0);
  CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), 0);
  const vtkMTimeType time = mapper->GetMTime();
  mapper->RemoveBlockVisibility(All);
  CHECK_GREATER(mapper->GetMTime(), time);
  scene.ResetCameras();
  scene.Render();
  CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 1000);

  // A copy looks the same.
  vtkNew<vtkAdaptiveRefinementMapper> copy;
  copy->ShallowCopy(mapper);
  CHECK_EQUAL(
    copy->GetCompositeDataDisplayAttributes(), mapper->GetCompositeDataDisplayAttributes());

  // Index 0 of an input without blocks, and of an input that was removed.
  mapper->SetInputDataObject(blocks.Leaves[Left]);
  mapper->SetBlockVisibility(All, false);
  scene.Render();
  CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), 0);
  vtkNew<vtkCellPicker> picker;
  CHECK(!picker->Pick(150, 150, 0.0, scene.Renderer));
  mapper->SetBlockVisibility(All, true);
  scene.ResetCameras();
  scene.Render();
  CHECK(picker->Pick(150, 150, 0.0, scene.Renderer));
  mapper->SetInputConnection(nullptr);
  mapper->SetBlockVisibility(All, false);
  CHECK(errors.Said("there is no input"));
}
}

int TestAdaptiveRefinementMapperBlockAttributes(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  ComparePictures(check, comparison);
  ComparePicks(check);
  CompareActors(comparison, 1.0, "actors");
  CompareActors(comparison, 0.5, "translucentActors");
  CheckSettings(check);
  return check.GetResult();
}
