// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/StudioScene.h"

#include "Scene/SceneFactory.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
const int SmallestWidth = 100; // pixels of the scene beside the panel

const char* const Builds[2] = { "buffer-builds", "shader-builds" };

double FindFigure(const SceneFigures& figures, const std::string& name)
{
  const auto figure = std::find_if(
    figures.begin(), figures.end(), [&](const auto& candidate) { return candidate.first == name; });
  return figure == figures.end() ? 0.0 : figure->second;
}

bool HasAny(const OptionNames& names, const OptionNames& others)
{
  return std::any_of(
    names.begin(), names.end(), [&](const std::string& name) { return others.count(name) > 0; });
}
}

//------------------------------------------------------------------------------
StudioScene::StudioScene(vtkRenderWindow* window, const OptionValues& values, bool isComplete)
  : Window(window)
  , Values(values)
  , IsComplete(isComplete)
  , OwnView(vtkSmartPointer<vtkCamera>::New())
{
  this->Build(values);
}

//------------------------------------------------------------------------------
StudioScene::~StudioScene()
{
  this->Window->RemoveRenderer(this->Scene->GetRenderer());
}

//------------------------------------------------------------------------------
ViewerOptions StudioScene::Parse(const OptionValues& values) const
{
  ViewerOptions options = values.Parse();
  if (this->IsComplete)
  {
    options.Output = "studio.png"; // scenes for pictures are complete
  }
  return options;
}

//------------------------------------------------------------------------------
void StudioScene::Build(const OptionValues& values)
{
  auto messages = std::make_unique<ViewerMessages>();
  std::unique_ptr<ViewerScene> scene = MakeScene(this->Parse(values), *messages);
  messages->ShowWarnings();
  if (this->Scene)
  {
    const SceneFigures figures = this->Scene->GetFigures();
    for (int i = 0; i < 2; ++i)
    {
      this->EarlierBuilds[i] += FindFigure(figures, Builds[i]);
    }
    this->Window->RemoveRenderer(this->Scene->GetRenderer());
  }
  this->Window->AddRenderer(scene->GetRenderer());
  this->Additions.reset();
  this->Scene = std::move(scene); // before the messages that it uses
  this->Messages = std::move(messages);
  this->Values = values;
  this->Additions = std::make_unique<SceneAdditions>();
  this->Additions->Show(*this->Scene, this->Parse(values));
  this->UpdateContent();
  this->StoreView();
  if (this->Size[0] > 0)
  {
    this->ApplySize();
  }
}

//------------------------------------------------------------------------------
void StudioScene::Apply(const OptionValues& values)
{
  if (values.GetInput() != this->Values.GetInput())
  {
    this->Build(values);
    return;
  }
  OptionNames changed = values.Compare(this->Values);
  for (const char* name : { "--center", "--view", "--zoom" })
  {
    if (this->SharedCamera)
    {
      changed.erase(name); // the other scene moves the camera
    }
  }
  if (changed.empty())
  {
    this->Values = values;
    return;
  }
  bool hasOtherAdditions = false;
  for (const std::string& name : SceneAdditions::GetOptions())
  {
    hasOtherAdditions = changed.erase(name) > 0 || hasOtherAdditions;
  }
  if (hasOtherAdditions && changed.empty())
  {
    this->Additions->Show(*this->Scene, this->Parse(values));
    this->Values = values;
    this->UpdateContent();
    return;
  }
  const bool changesView = HasAny(changed, { "--center", "--view", "--zoom" });
  const bool isMoved = this->IsViewMoved() && !changesView;
  vtkCamera* camera = this->Scene->GetRenderer()->GetActiveCamera();
  // The range of all time steps is found when a scene is built.
  const bool isOfAllSteps = changed.count("--range") > 0 &&
    (values.Get("range") == "all" || this->Values.Get("range") == "all");
  if (!isOfAllSteps && this->Scene->Update(this->Parse(values), changed))
  {
    if (hasOtherAdditions)
    {
      this->Additions->Show(*this->Scene, this->Parse(values));
    }
    this->Values = values;
    this->UpdateContent();
    // Until the user moves the camera, the view shows the whole changed surface.
    if (!isMoved &&
      HasAny(changed, { "--amplitude", "--alpha", "--frequency", "--offset", "--scale", "--time" }))
    {
      this->ResetView();
    }
    if (!isMoved)
    {
      this->StoreView();
    }
    return;
  }
  vtkNew<vtkCamera> old;
  old->DeepCopy(camera);
  this->Build(values);
  if (this->SharedCamera)
  {
    this->ShareCamera(this->SharedCamera);
  }
  else if (isMoved)
  {
    this->Scene->GetRenderer()->GetActiveCamera()->DeepCopy(old);
    this->Scene->GetRenderer()->ResetCameraClippingRange();
  }
}

//------------------------------------------------------------------------------
void StudioScene::UpdateContent()
{
  this->Content = this->Scene->GetContent();
  this->Content.Version = ++this->ContentVersion;
}

//------------------------------------------------------------------------------
const SceneContent& StudioScene::GetContent()
{
  this->Content.Light = this->Scene->GetLight();
  this->Content.View = this->Scene->GetView();
  this->Content.IsViewMoved = this->IsViewMoved();
  return this->Content;
}

//------------------------------------------------------------------------------
void StudioScene::SetPanelWidth(int width)
{
  this->PanelWidth = width;
  this->UpdateSize();
}

//------------------------------------------------------------------------------
void StudioScene::SetColumn(int column, int number)
{
  const bool isMoved = column != this->Column;
  this->Column = column;
  this->NumberOfColumns = number;
  this->UpdateSize();
  if (isMoved && this->Size[0] > 0)
  {
    this->ApplySize();
  }
}

//------------------------------------------------------------------------------
void StudioScene::ShareCamera(vtkCamera* camera)
{
  this->SharedCamera = camera;
  this->Scene->GetRenderer()->SetActiveCamera(camera);
}

//------------------------------------------------------------------------------
void StudioScene::UpdateSize()
{
  const int* window = this->Window->GetActualSize();
  const bool hasRoom = window[0] - this->PanelWidth >= SmallestWidth;
  const int width = hasRoom ? window[0] - this->PanelWidth : window[0];
  const std::array<int, 2> size = { { width / this->NumberOfColumns, window[1] } };
  if (size[0] > 0 && size[1] > 0 && size != this->Size)
  {
    this->Size = size;
    this->ApplySize();
  }
}

//------------------------------------------------------------------------------
std::array<double, 4> StudioScene::GetColumnViewport(int column) const
{
  const double width = this->Window->GetActualSize()[0];
  return { { column * this->Size[0] / width, 0.0, (column + 1) * this->Size[0] / width, 1.0 } };
}

//------------------------------------------------------------------------------
void StudioScene::ApplySize()
{
  const bool isMoved = this->IsViewMoved();
  const std::array<double, 4> viewport = this->GetColumnViewport(this->Column);
  this->Scene->GetRenderer()->SetViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  this->Scene->SetViewSize(this->Size);
  if (!isMoved)
  {
    this->ResetView();
  }
}

//------------------------------------------------------------------------------
void StudioScene::CheckFrame()
{
  this->Messages->Check();
}

//------------------------------------------------------------------------------
SceneFigures StudioScene::GetFigures()
{
  SceneFigures figures = this->Scene->GetFigures();
  for (auto& figure : figures)
  {
    for (int i = 0; i < 2; ++i)
    {
      figure.second += figure.first == Builds[i] ? this->EarlierBuilds[i] : 0.0;
    }
  }
  return figures;
}

//------------------------------------------------------------------------------
void StudioScene::ResetView()
{
  if (this->SharedCamera)
  {
    return;
  }
  this->Scene->ResetView();
  this->StoreView();
}

//------------------------------------------------------------------------------
void StudioScene::StoreView()
{
  this->OwnView->DeepCopy(this->Scene->GetRenderer()->GetActiveCamera());
}

//------------------------------------------------------------------------------
bool StudioScene::IsViewMoved() const
{
  // A click turns the camera by rounding errors, and makes its upward direction orthogonal.
  const double tolerance = 1e-9;
  const double* view =
    this->Scene->GetRenderer()->GetActiveCamera()->GetViewTransformMatrix()->GetData();
  const double* own = this->OwnView->GetViewTransformMatrix()->GetData();
  return !std::equal(view, view + 16, own,
    [&](double a, double b) {
      return std::abs(a - b) <= tolerance * std::max({ 1.0, std::abs(a), std::abs(b) });
    });
}
