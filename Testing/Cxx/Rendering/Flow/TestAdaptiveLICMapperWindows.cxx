// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the LIC is the same in every viewport, window and pass of the same size, and that it
// survives changes of windows and mappers.
#include "RelevoLICView.h"
#include "RelevoPictures.h"
#include "RelevoShadows.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkLight.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace RelevoMeshes;
using RelevoPictures::Crop;

constexpr int Width = 160;
constexpr int Height = 120;

Mesh MakeMesh(const RelevoLICVectors::Field& field = RelevoLICVectors::Screw)
{
  Mesh mesh = Sphere(16, 12);
  RelevoLICVectors::AddVectors(mesh, field);
  return mesh;
}

std::array<double, 3> Other(const double* p)
{
  return { { p[2], 0.3 - p[0], p[1] } };
}

// Draws only the LIC, in a separate window.
struct View : public RelevoLICView
{
  explicit View(const RelevoLICVectors::Field& field = RelevoLICVectors::Screw)
  {
    this->Add(MakeMesh(field), MakeRecipe(1));
    this->Mapper->SetLICIntensity(1.0);
    this->Scene->Window->SetSize(Width, Height);
    this->Scene->ResetCameras();
  }
};

// Crops a larger window.
RelevoPicture Crop(const RelevoPicture& picture, int x, int y)
{
  return Crop(picture, x, y, Width, Height);
}

// Mean and standard deviation of the grey values without background.
std::array<double, 2> GetMoments(const RelevoPicture& picture)
{
  double sum = 0.0;
  double squares = 0.0;
  size_t count = 0;
  for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
  {
    const unsigned char* color = &picture.Colors[3 * i];
    if (color[0] == color[1] && color[1] == color[2])
    {
      sum += color[0];
      squares += color[0] * color[0];
      ++count;
    }
  }
  const double mean = sum / std::max<size_t>(count, 1);
  return { { mean, std::sqrt(std::max(0.0, squares / std::max<size_t>(count, 1) - mean * mean)) } };
}

int FindBrightest(const RelevoPicture& picture)
{
  return *std::max_element(picture.Colors.begin(), picture.Colors.end());
}

// Compares what windows show with a window that shows nothing else.
struct Windows
{
  explicit Windows(RelevoComparison& comparison)
    : Comparison(comparison)
  {
  }

  bool Compare(const std::string& name, const RelevoPicture& actual, const RelevoPicture& expected)
  {
    return this->Comparison.Compare("LICWindows." + name, { 0, 1e-5, 0 }, actual, expected);
  }
  bool Compare(const std::string& name, const RelevoPicture& actual)
  {
    return this->Compare(name, actual, this->Expected);
  }

  RelevoComparison& Comparison;
  View Alone;
  View AloneOther{ Other };
  const RelevoPicture Expected = this->Alone.Draw();
  const RelevoPicture ExpectedOther = this->AloneOther.Draw();
};

// The viewport has an offset from the origin.
void TestOffset(Windows& windows)
{
  View view;
  view.Scene->Window->SetSize(2 * Width, 2 * Height);
  view.Scene->Renderer->SetViewport(0.25, 0.25, 0.75, 0.75);
  windows.Compare("Offset", Crop(view.Draw(), Width / 2, Height / 2));
}

// Viewports side by side, whose actors may share a mapper.
void TestSideBySide(RelevoCheck& check, Windows& windows, bool shared)
{
  View view;
  view.Scene->Window->SetSize(2 * Width, Height);
  view.Scene->Renderer->SetViewport(0, 0, 0.5, 1);
  vtkRenderer* right = view.Scene->AddRenderer(0.5, 0, 1, 1);
  right->SetBackground(0.1, 0.2, 0.3);
  right->GetActiveCamera()->DeepCopy(view.Scene->Renderer->GetActiveCamera());
  vtkActor* actor = view.Scene->Add(right, MakeMesh(Other), MakeRecipe(1));
  RelevoLICVectors::GetMapper(actor)->SetLICIntensity(1.0);
  if (shared)
  {
    actor->SetMapper(view.Mapper);
  }
  for (int i = 0; i < 3; ++i)
  {
    const RelevoPicture picture = view.Draw();
    const std::string name = (shared ? "Shared" : "Beside") + std::to_string(i);
    windows.Compare(name + "Left", Crop(picture, 0, 0));
    windows.Compare(
      name + "Right", Crop(picture, Width, 0), shared ? windows.Expected : windows.ExpectedOther);
  }
  CHECK_EQUAL(view.Mapper->GetNumberOfConvolutions(), (shared ? 2 : 1));
}

// One mapper draws two actors in one renderer, each in half of the picture.
void TestSharedActors(Windows& windows)
{
  View separate;
  View shared;
  for (View* view : { &separate, &shared })
  {
    view->Actor->SetPosition(-0.6, 0, 0);
    vtkActor* second = view->Scene->Add(MakeMesh(), MakeRecipe(1));
    RelevoLICVectors::GetMapper(second)->SetLICIntensity(1.0);
    second->SetPosition(0.6, 0.1, 0);
    if (view == &shared)
    {
      second->SetMapper(view->Mapper);
    }
    view->Scene->ResetCameras();
  }
  windows.Compare("SharedActors", shared.Draw(), separate.Draw());
}

void MoveVectorsToCells(vtkPolyData* mesh)
{
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(mesh);
  toCells->Update();
  mesh->GetCellData()->AddArray(toCells->GetOutput()->GetCellData()->GetArray("Flow"));
  mesh->GetPointData()->RemoveArray("Flow");
}

// A surface with edges and a wireframe, next to one that shows only the LIC.
void AddLooks(View& view, vtkPolyData* mesh, bool isShared)
{
  for (int i = 0; i < 3; ++i)
  {
    vtkActor* actor = view.Scene->Add(mesh, MakeRecipe(1));
    RelevoLICVectors::GetMapper(actor)->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, "Flow");
    actor->SetPosition(0.7 * i - 0.7, 0.3 * i, 0);
    actor->GetProperty()->SetEdgeVisibility(i == 1);
    actor->GetProperty()->SetRepresentation(i == 2 ? VTK_WIREFRAME : VTK_SURFACE);
    actor->SetMapper(isShared ? view.Scene->GetActor(1)->GetMapper() : actor->GetMapper());
  }
  view.Scene->Renderer->RemoveActor(view.Actor);
  view.Scene->ResetCameras();
}

void TestSharedLooks(RelevoCheck& check, Windows& windows, bool ofCells)
{
  std::vector<RelevoPicture> pictures;
  for (const bool isShared : { false, true })
  {
    CHECK_CASE(isShared);
    View view;
    Mesh mesh = MakeMesh();
    if (ofCells)
    {
      MoveVectorsToCells(mesh);
    }
    AddLooks(view, mesh, isShared);
    pictures.push_back(view.Draw());
    vtkAdaptiveLICMapper* lic = RelevoLICVectors::GetMapper(view.Scene->GetActor(1));
    view.Draw();
    const vtkIdType buffers = lic->GetNumberOfBufferBuilds();
    const vtkIdType shaders = lic->GetNumberOfShaderBuilds();
    const auto convolutions = lic->GetNumberOfConvolutions();
    pictures.push_back(view.Draw());
    CHECK_EQUAL(lic->GetNumberOfBufferBuilds(), buffers);
    CHECK_EQUAL(lic->GetNumberOfShaderBuilds(), shaders);
    CHECK_EQUAL(lic->GetNumberOfConvolutions(), convolutions);
  }
  for (size_t i = 1; i < pictures.size(); ++i)
  {
    windows.Compare(std::string("SharedLooks") + (ofCells ? "OfCells" : "") + std::to_string(i),
      pictures[i], pictures[0]);
  }
}

// One mapper in two windows by turns.
void TestTwoWindows(Windows& windows)
{
  View first;
  RelevoScene second(RelevoScene::Refining);
  second.Window->SetSize(Width, Height);
  vtkNew<vtkActor> actor;
  actor->SetMapper(first.Mapper);
  second.Renderer->AddActor(actor);
  second.CopyCameras(*first.Scene);
  for (int i = 0; i < 2; ++i)
  {
    windows.Compare("FirstWindow" + std::to_string(i), first.Draw());
    second.Render();
    windows.Compare("SecondWindow" + std::to_string(i), RelevoPicture(second.Window));
  }
}

void TestOffScreen(Windows& windows)
{
  View view;
  view.Scene->Window->OffScreenRenderingOn();
  windows.Compare("OffScreen", view.Draw());
}

void TestSizes(RelevoCheck& check, Windows& windows)
{
  View view;
  view.Scene->Window->SetDPI(240);
  windows.Compare("DPI", view.Draw());
  view.Scene->Window->SetSize(2 * Width, 2 * Height);
  const RelevoPicture large = view.Draw();
  CHECK_NEAR(GetMoments(large)[0], GetMoments(windows.Expected)[0], 5.0);
  view.Scene->Window->SetSize(Width, Height);
  windows.Compare("SizedBack", view.Draw());
  view.Mapper->ReleaseGraphicsResources(view.Scene->Window);
  windows.Compare("Released", view.Draw());
  view.Scene->Window->Finalize();
  windows.Compare("Reopened", view.Draw());
}

// Windows may have one pixel or one row.
void TestFewPixels(RelevoCheck& check)
{
  View view;
  view.Scene->Window->OffScreenRenderingOn();
  RelevoErrors errors(view.Mapper);
  for (const std::array<int, 2>& size :
    { std::array<int, 2>{ { 1, 1 } }, { { 40, 1 } }, { { 1, 40 } } })
  {
    view.Scene->Window->SetSize(size[0], size[1]);
    view.Mapper->SetEnhanceContrastToBoth();
    view.Mapper->SetAntiAlias(2);
    view.Draw();
  }
  CHECK(errors.None());
  // A viewport without pixels is not an error.
  view.Scene->Renderer->SetViewport(0, 0, 0, 0);
  view.Scene->Window->SetSize(30, 30);
  view.Draw();
  CHECK(errors.None());
}

// Without the LIC a silhouette would be as white as the actor.
void TestMultiSamples(RelevoCheck& check, Windows& windows)
{
  View view;
  view.Scene->Window->SetMultiSamples(8);
  const RelevoPicture smooth = view.Draw();
  CHECK_LESS_EQUAL(FindBrightest(smooth), FindBrightest(windows.Expected) + 2);
  size_t different = 0;
  for (size_t i = 0; i < smooth.Colors.size(); ++i)
  {
    different += std::abs(smooth.Colors[i] - windows.Expected.Colors[i]) > 2 ? 1 : 0;
  }
  CHECK_LESS(different, smooth.Colors.size() / 20);
}

// In four tiles the picture equals that of one window, except for streamlines across the tiles'
// borders.
void TestTiles(RelevoCheck& check, Windows& windows)
{
  View view;
  view.Draw();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(view.Scene->Window);
  grab->SetScale(2);
  grab->ReadFrontBufferOff();
  grab->Update();
  RelevoPicture tiled(2 * Width, 2 * Height);
  const auto* colors = static_cast<unsigned char*>(grab->GetOutput()->GetScalarPointer());
  CHECK_EQUAL(
    grab->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(tiled.GetNumberOfPixels()));
  std::copy_n(colors, tiled.Colors.size(), tiled.Colors.begin());
  windows.Compare("AfterTiles", view.Draw());
  view.Scene->Window->SetSize(2 * Width, 2 * Height);
  const RelevoPicture whole = view.Draw();
  const int size = 60;
  const int corners[2][2] = { { Width - 20 - size, Width + 20 },
    { Height - 20 - size, Height + 20 } };
  for (int i = 0; i < 4; ++i)
  {
    const int x = corners[0][i % 2];
    const int y = corners[1][i / 2];
    RelevoPicture part = Crop(tiled, x, y, size, size);
    const RelevoPicture expectedPart = Crop(whole, x, y, size, size);
    part.Depths = expectedPart.Depths;
    CHECK(windows.Comparison.Compare(
      "LICWindows.Tile" + std::to_string(i), { 1, 0.0, 20 }, part, expectedPart));
  }
}

// In stereo, each eye shows what its camera sees.
void TestEyes(RelevoCheck& check, Windows& windows)
{
  View view;
  vtkRenderWindow* window = view.Scene->Window;
  view.Scene->Renderer->GetActiveCamera()->SetEyeAngle(10.0);
  window->StereoRenderOn();
  window->SetStereoTypeToLeft();
  const RelevoPicture left = view.Draw();
  window->SetStereoTypeToRight();
  const RelevoPicture right = view.Draw();
  window->SetStereoTypeToSplitViewportHorizontal();
  view.Draw();
  window->SetStereoTypeToRedBlue();
  const RelevoPicture both = view.Draw();
  size_t wrong = 0;
  for (size_t i = 0; i < both.GetNumberOfPixels(); ++i)
  {
    const bool isGrey = left.Depths[i] < 1.0f && right.Depths[i] < 1.0f;
    wrong += isGrey &&
        (std::abs(both.Colors[3 * i] - left.Colors[3 * i]) > 2 ||
          std::abs(both.Colors[3 * i + 2] - right.Colors[3 * i]) > 2)
      ? 1
      : 0;
  }
  CHECK_NOT_EQUAL(left.Colors, right.Colors);
  CHECK_EQUAL(wrong, 0);
  for (const RelevoPicture* picture : { &left, &right })
  {
    CHECK_NEAR(GetMoments(*picture)[0], GetMoments(windows.Expected)[0], 3.0);
    CHECK_NEAR(GetMoments(*picture)[1], GetMoments(windows.Expected)[1], 3.0);
  }
  window->StereoRenderOff();
  windows.Compare("OneEye", view.Draw());
}

void SetPass(View& view, vtkRenderPass* pass)
{
  vtkOpenGLRenderer::SafeDownCast(view.Scene->Renderer)->SetPass(pass);
}

void TestRenderPasses(RelevoCheck& check, Windows& windows)
{
  View view;
  vtkNew<vtkRenderStepsPass> steps;
  SetPass(view, steps);
  windows.Compare("StepsPass", view.Draw());
  SetPass(view, nullptr);
  windows.Compare("NoPass", view.Draw());
  vtkNew<vtkSSAAPass> smooth;
  smooth->SetDelegatePass(steps);
  SetPass(view, smooth);
  const RelevoPicture picture = view.Draw();
  CHECK_NEAR(GetMoments(picture)[0], GetMoments(windows.Expected)[0], 5.0);
  CHECK_LESS_EQUAL(FindBrightest(picture), FindBrightest(windows.Expected) + 2);
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetDelegatePass(steps);
  occlusion->SetRadius(1e-6); // nothing is occluded
  SetPass(view, occlusion);
  const RelevoPicture open = view.Draw();
  CHECK_NEAR(GetMoments(open)[1], GetMoments(windows.Expected)[1], 3.0);
}

// Nothing lies in shadow. The cameras of lights do not affect the picture.
void TestShadows(Windows& windows)
{
  View view;
  vtkNew<vtkLight> light;
  light->PositionalOn();
  light->SetPosition(4, 4, 4);
  light->SetFocalPoint(0, 0, 0);
  light->SetConeAngle(60);
  view.Scene->Renderer->AddLight(light);
  SetPass(view, RelevoMakeShadowPass());
  windows.Compare("Shadows", view.Draw());
  windows.Compare("ShadowsAgain", view.Draw());
}

// Deletes the mapper before the window, and the window before the mapper.
void TestLifetimes(RelevoCheck& check, Windows& windows)
{
  RelevoLICView view;
  {
    vtkNew<vtkAdaptiveLICMapper> mapper;
    mapper->SetInputData(MakeMesh());
    mapper->SetRefinement(MakeRecipe(1));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    view.Scene->Renderer->AddActor(actor);
    view.Scene->ResetCameras();
    view.Draw();
    CHECK_EQUAL(mapper->GetNumberOfConvolutions(), 1);
    view.Scene->Renderer->RemoveActor(actor);
  }
  view.Draw();
  vtkNew<vtkAdaptiveLICMapper> survivor;
  survivor->SetInputData(MakeMesh());
  survivor->SetRefinement(MakeRecipe(1));
  survivor->SetLICIntensity(1.0);
  survivor->BackFaceCullingOff();
  survivor->SetNumberOfSteps(8);
  vtkNew<vtkActor> actor;
  actor->SetMapper(survivor);
  view.Scene->Renderer->AddActor(actor);
  view.Scene->ResetCameras();
  view.Draw();
  view.Scene.reset();
  RelevoScene next(RelevoScene::Refining);
  next.Window->SetSize(Width, Height);
  next.Renderer->AddActor(actor);
  next.CopyCameras(*windows.Alone.Scene);
  next.Render();
  windows.Compare("Survivor", RelevoPicture(next.Window));
}
}

int TestAdaptiveLICMapperWindows(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  Windows windows(comparison);
  CHECK_GREATER(GetMoments(windows.Expected)[1], 15.0);
  TestOffset(windows);
  for (const bool shared : { false, true })
  {
    CHECK_CASE(shared);
    TestSideBySide(check, windows, shared);
  }
  TestSharedActors(windows);
  for (const bool ofCells : { false, true })
  {
    CHECK_CASE(ofCells);
    TestSharedLooks(check, windows, ofCells);
  }
  TestTwoWindows(windows);
  TestOffScreen(windows);
  TestSizes(check, windows);
  TestFewPixels(check);
  TestMultiSamples(check, windows);
  TestTiles(check, windows);
  TestEyes(check, windows);
  TestRenderPasses(check, windows);
  TestShadows(windows);
  TestLifetimes(check, windows);
  return check.GetResult();
}
