// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The painter of terrains draws the same picture as vtkPolyDataMapper draws of the same triangles.
#include "RelevoPictures.h"
#include "RelevoTerrainScene.h"

#include "vtkEDLShading.h"
#include "vtkPlane.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
// Allowed are rounding errors of colours and depths, and pixels at edges of triangles.
const RelevoTolerance Close{ 2, 2e-6, 12 };

bool IsSame(const RelevoPicture& a, const RelevoPicture& b)
{
  return a.Colors == b.Colors && a.Depths == b.Depths;
}

void LookAtHills(RelevoTerrainScene& scene)
{
  scene.Look({ { -80.0, 600.0, 120.0 } }, { { 250.0, 250.0, 0.0 } });
  scene.GetProperty()->SetInterpolationToFlat();
}

// Compares a picture with the twin's.
void Compare(RelevoCheck& check, RelevoComparison& comparison, const std::string& name,
  RelevoTerrainScene& scene, const RelevoTolerance& tolerance = Close)
{
  CHECK_CASE(name);
  const RelevoPicture picture = scene.Draw();
  CHECK_EQUAL(scene.Mapper->Error, "");
  CHECK_EQUAL(scene.Mapper->Painter->GetShaderError(), "");
  CHECK_GREATER(picture.CountForeground(), picture.GetNumberOfPixels() / 40);
  picture.Save(comparison.GetFolder() + "/TerrainPainter." + name + ".png");
  comparison.Compare("TerrainPainter." + name, tolerance, picture, scene.DrawTwin());
}

void TestRepresentations(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  Compare(check, comparison, "Surface", scene);
  scene.GetProperty()->EdgeVisibilityOn();
  scene.GetProperty()->SetEdgeColor(1.0, 0.0, 0.0);
  Compare(check, comparison, "Edges", scene, { 2, 2e-6, 60 });
  scene.GetProperty()->EdgeVisibilityOff();
  scene.GetProperty()->LightingOff();
  scene.Mapper->Tolerance = 8.0;
  const RelevoTolerance lines{ 2, 2e-6, 100 }; // edges are drawn in other directions
  scene.GetProperty()->SetRepresentationToWireframe();
  Compare(check, comparison, "Wireframe", scene, lines);
  scene.GetProperty()->SetLineWidth(3.0f);
  Compare(check, comparison, "WideLines", scene, lines);
  scene.GetProperty()->SetRepresentationToPoints();
  scene.GetProperty()->SetPointSize(3.0f);
  Compare(check, comparison, "Points", scene);
}

void TestTranslucency(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  scene.GetProperty()->SetOpacity(0.4);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->SetMaximumNumberOfPeels(20);
  scene.Window->SetAlphaBitPlanes(1);
  Compare(check, comparison, "Translucent", scene, { 2, 2e-6, 40 });
}

void TestPasses(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkEDLShading> edges;
  edges->SetDelegatePass(steps);
  scene.Renderer->SetPass(edges);
  Compare(check, comparison, "EDL", scene, { 2, 2e-6, 40 });
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetRadius(10.0);
  occlusion->SetDelegatePass(steps);
  scene.Renderer->SetPass(occlusion);
  Compare(check, comparison, "SSAO", scene, { 2, 2e-6, 120 }); // is noisy
  scene.Renderer->SetPass(nullptr);
  edges->ReleaseGraphicsResources(scene.Window);
  occlusion->ReleaseGraphicsResources(scene.Window);
}

// The code of a user replaces parts of the shaders.
void TestShaderReplacements(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  scene.GetProperty()->LightingOff();
  vtkShaderProperty* shaders = scene.Actor->GetShaderProperty();
  shaders->AddVertexShaderReplacement("//VTK::CustomUniforms::Dec", true,
    "//VTK::CustomUniforms::Dec\n"
    "out vec3 placeVSOutput;\n",
    false);
  shaders->AddVertexShaderReplacement(
    "//VTK::CustomEnd::Impl", true, "placeVSOutput = fract(0.01 * vertexMC.xyz);\n", false);
  shaders->AddFragmentShaderReplacement("//VTK::CustomUniforms::Dec", true,
    "//VTK::CustomUniforms::Dec\n"
    "in vec3 placeVSOutput;\n",
    false);
  shaders->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
    "//VTK::Light::Impl\n  gl_FragData[0] = vec4(placeVSOutput.zzz, 1.0);\n", false);
  const RelevoPicture picture = scene.Draw();
  CHECK_EQUAL(scene.Mapper->Painter->GetShaderError(), "");
  picture.Save(comparison.GetFolder() + "/TerrainPainter.Replaced.png");
  // Heights relative to the painter's origin give other greys.
  std::set<unsigned char> greys;
  size_t colored = 0;
  for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
  {
    const unsigned char* color = &picture.Colors[3 * i];
    greys.insert(color[0]);
    colored += color[0] == color[1] && color[1] == color[2] ? 0 : 1;
  }
  CHECK_EQUAL(colored, 0);
  CHECK_GREATER(greys.size(), 50);
  shaders->ClearAllShaderReplacements();
  Compare(check, comparison, "Restored", scene);
}

void TestMatrices(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  scene.Actor->SetPosition(30.0, -20.0, 10.0);
  scene.Actor->RotateZ(20.0);
  scene.Actor->RotateX(-8.0);
  scene.Actor->SetScale(1.3);
  Compare(check, comparison, "Matrix", scene);
  RelevoTerrainScene turned;
  turned.Mapper->Settings.Placement.Column = { { 0.8, 0.7 } };
  turned.Mapper->Settings.Placement.Row = { { 0.5, -0.9 } };
  turned.Mapper->Settings.Placement.HeightScale = 2.0;
  turned.Mapper->Settings.Exaggeration = 2.0;
  LookAtHills(turned);
  Compare(check, comparison, "Sheared", turned);
}

void TestHoles(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene(513, 513,
    [](int column, int row)
    {
      const bool isHole =
        column * row % 1009 == 5 || std::hypot(column - 130.0, row - 380.0) < 40.0;
      return isHole ? std::nanf("") : RelevoHills(column, row);
    });
  LookAtHills(scene);
  Compare(check, comparison, "Holes", scene);
}

void TestClipping(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(200.0, -250.0, 0.0);
  plane->SetNormal(0.5, 1.0, 0.2);
  scene.Mapper->AddClippingPlane(plane);
  Compare(check, comparison, "Clipped", scene);
}

// Columns and rows beyond the last sample are not drawn.
void TestBorders(RelevoCheck& check)
{
  RelevoTerrainScene scene(451, 389);
  scene.Look({ { 250.0, 220.0, 900.0 } }, { { 250.0, 219.0, 0.0 } });
  const RelevoPicture whole = scene.Draw();
  vtkNew<vtkPlane> columns;
  columns->SetOrigin(450.001, 0.0, 0.0);
  columns->SetNormal(-1.0, 0.0, 0.0);
  vtkNew<vtkPlane> rows;
  rows->SetOrigin(0.0, -388.001, 0.0);
  rows->SetNormal(0.0, 1.0, 0.0);
  scene.Mapper->AddClippingPlane(columns);
  scene.Mapper->AddClippingPlane(rows);
  CHECK(IsSame(scene.Draw(), whole));
  columns->SetOrigin(448.0, 0.0, 0.0);
  CHECK(!IsSame(scene.Draw(), whole));
}

// Triangles face up in all placements.
void TestOrientation(RelevoCheck& check)
{
  for (double row : { -1.0, 1.0 })
  {
    CHECK_CASE(row);
    RelevoTerrainScene scene;
    scene.Mapper->Settings.Placement.Row = { { 0.0, row } };
    scene.Look({ { 250.0, 250.0, 500.0 } }, { { 250.0, 249.0, 0.0 } });
    const RelevoPicture whole = scene.Draw();
    CHECK_GREATER(whole.CountForeground(), 0);
    scene.GetProperty()->BackfaceCullingOn();
    CHECK(IsSame(scene.Draw(), whole));
    scene.GetProperty()->BackfaceCullingOff();
    scene.GetProperty()->FrontfaceCullingOn();
    CHECK_EQUAL(scene.Draw().CountForeground(), 0);
  }
}

// Normals point to the viewer below the terrain, too, and the property of back faces is used there.
void TestUndersides(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  scene.Look({ { -80.0, 600.0, -120.0 } }, { { 250.0, 250.0, 0.0 } });
  Compare(check, comparison, "Underside", scene);
  scene.GetProperty()->SetInterpolationToGouraud();
  const RelevoPicture smooth = scene.Draw();
  smooth.Save(comparison.GetFolder() + "/TerrainPainter.SmoothUnderside.png");
  std::size_t lit = 0;
  for (std::size_t i = 0; i < smooth.GetNumberOfPixels(); ++i)
  {
    lit += smooth.Depths[i] < 1.0f && smooth.Colors[3 * i] > 40 ? 1 : 0;
  }
  CHECK_GREATER(lit, 0.8 * static_cast<double>(smooth.CountForeground()));
  scene.GetProperty()->SetInterpolationToFlat();
  vtkNew<vtkProperty> back;
  back->SetColor(0.2, 0.9, 0.1);
  back->SetInterpolationToFlat();
  scene.Actor->SetBackfaceProperty(back);
  Compare(check, comparison, "BackfaceProperty", scene);
}

// Large coordinates keep their accuracy.
void TestFarAway(RelevoComparison& comparison)
{
  const auto draw = [](double x, double y)
  {
    RelevoTerrainScene scene;
    scene.Mapper->Settings.Placement.Origin = { { x, y } };
    scene.Mapper->Settings.Placement.Column = { { 0.3, 0.0 } };
    scene.Mapper->Settings.Placement.Row = { { 0.0, -0.3 } };
    scene.Mapper->Tolerance = 5.0;
    const double ground = static_cast<double>(RelevoHills(310, 222));
    scene.Look({ { 310.0, 222.0, ground + 3.0 } }, { { 330.0, 200.0, ground } });
    return scene.Draw();
  };
  comparison.Compare(
    "TerrainPainter.Far", { 2, 1e-6, 20 }, draw(4194304.0, -8388608.0), draw(0.0, 0.0));
}

// Several renderers show an actor at the same time.
void TestRenderers(RelevoComparison& comparison)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  scene.Window->SetSize(200, 150);
  const RelevoPicture first = scene.Draw();
  scene.Look({ { 300.0, 100.0, 60.0 } }, { { 200.0, 200.0, 0.0 } });
  const RelevoPicture second = scene.Draw();
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(scene.GetCamera());
  LookAtHills(scene);
  vtkNew<vtkRenderer> other;
  other->SetActiveCamera(camera);
  other->AddActor(scene.Actor);
  scene.Window->AddRenderer(other);
  scene.Window->SetSize(400, 150);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  for (int frame = 0; frame < 2; ++frame)
  {
    const RelevoPicture both = scene.Draw();
    comparison.Compare(
      "TerrainPainter.Left", { 0, 0.0, 0 }, RelevoPictures::Crop(both, 0, 0, 200, 150), first);
    // Pixels at other window coordinates have other rounding errors.
    comparison.Compare(
      "TerrainPainter.Right", Close, RelevoPictures::Crop(both, 200, 0, 200, 150), second);
  }
}

// A selection of cells gives the indices of faces.
void TestSelection(RelevoCheck& check)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  scene.Draw();
  const std::vector<vtkIdType> selected = scene.SelectFaces();
  const std::vector<vtkIdType> expected = scene.SelectFacesOfTwin();
  size_t differences = 0;
  size_t hits = 0;
  for (size_t i = 0; i < selected.size(); ++i)
  {
    hits += expected[i] >= 0 ? 1 : 0;
    differences += selected[i] == expected[i] ? 0 : 1;
  }
  CHECK_GREATER(hits, selected.size() / 3);
  CHECK_LESS(differences, 10);
}

// The painter draws the same picture after a release, and uploads tiles once.
void TestRelease(RelevoCheck& check)
{
  RelevoTerrainScene scene;
  LookAtHills(scene);
  const RelevoPicture picture = scene.Draw();
  const vtkIdType uploads = scene.Mapper->Painter->GetNumberOfTileUploads();
  const vtkIdType builds = scene.Mapper->Painter->GetNumberOfShaderBuilds();
  CHECK(IsSame(scene.Draw(), picture));
  CHECK_EQUAL(scene.Mapper->Painter->GetNumberOfTileUploads(), uploads);
  CHECK_EQUAL(scene.Mapper->Painter->GetNumberOfShaderBuilds(), builds);
  CHECK_EQUAL(scene.Mapper->Painter->GetNumberOfDrawCalls(), 2);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  CHECK(IsSame(scene.Draw(), picture));
  CHECK_EQUAL(scene.Mapper->Painter->GetNumberOfTileUploads(), 2 * uploads);
  // One byte less than the tiles of the view need.
  scene.Mapper->Settings.MemoryLimit = uploads * relevo::TerrainTileTextures::LayerSize - 1;
  scene.Draw();
  CHECK(scene.Mapper->Error.find("do not fit") != std::string::npos);
  scene.Mapper->Settings.MemoryLimit += 1;
  CHECK(IsSame(scene.Draw(), picture));
  CHECK_EQUAL(scene.Mapper->Error, "");
}

// A flight with few textures draws the same as one with many, because tiles are uploaded again.
void TestReplacedTiles(RelevoCheck& check)
{
  RelevoTerrainScene many(2049, 2049);
  RelevoTerrainScene few(2049, 2049);
  constexpr vtkTypeInt64 layers = 13;
  few.Mapper->Settings.MemoryLimit = 2 * layers * relevo::TerrainTileTextures::LayerSize;
  size_t largest = 0;
  for (int i = 0; i < 16; ++i)
  {
    CHECK_CASE(i);
    const double x = 1024.0 + 800.0 * std::cos(0.8 * i);
    const double y = 1024.0 + 800.0 * std::sin(0.8 * i);
    for (RelevoTerrainScene* scene : { &many, &few })
    {
      scene->Window->SetSize(160, 120);
      scene->Mapper->Tolerance = 0.3;
      scene->Look({ { x, y, 50.0 } }, { { x + 10.0, y, 46.0 } });
    }
    CHECK(IsSame(few.Draw(), many.Draw()));
    CHECK_EQUAL(few.Mapper->Error, "");
    std::set<const relevo::HeightTile*> tiles;
    for (const relevo::TerrainFace& face : few.Mapper->GetFaces())
    {
      tiles.insert({ face.Tile, face.CoarseTile });
    }
    largest = std::max(largest, tiles.size());
  }
  CHECK_LESS_EQUAL(largest, layers);
  CHECK_GREATER(
    few.Mapper->Painter->GetNumberOfTileUploads(), many.Mapper->Painter->GetNumberOfTileUploads());
  CHECK_LESS(few.Mapper->Painter->GetMemorySize(), many.Mapper->Painter->GetMemorySize());
}
}

int TestTerrainPainter(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestRepresentations(check, comparison);
  TestTranslucency(check, comparison);
  TestPasses(check, comparison);
  TestShaderReplacements(check, comparison);
  TestMatrices(check, comparison);
  TestHoles(check, comparison);
  TestClipping(check, comparison);
  TestBorders(check);
  TestOrientation(check);
  TestUndersides(check, comparison);
  TestFarAway(comparison);
  TestRenderers(comparison);
  TestSelection(check);
  TestRelease(check);
  TestReplacedTiles(check);
  return check.GetResult();
}
