// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SurfaceScene.h"

#include "Files/ViewerExport.h"
#include "Scene/ViewerFlow.h"
#include "Scene/ViewerStatistics.h"
#include "Scene/ViewerSurface.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkDepthTagMetric.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementSurface.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

#include <algorithm>
#include <iostream>

//------------------------------------------------------------------------------
SurfaceScene::SurfaceScene(const ViewerOptions& options, ViewerMessages& messages)
  : ViewerScene(options, messages)
  , Mapper(MakeMapper(options))
{
  this->Messages.Observe(this->Recipe);
  this->Messages.Observe(this->Mapper);
}

//------------------------------------------------------------------------------
SurfaceScene::~SurfaceScene() = default;

//------------------------------------------------------------------------------
void SurfaceScene::SetRecipe(int maximumLevel, vtkDepthTagMetric* metric)
{
  const auto surface = MakeSurface(this->Options, this->Mesh->GetLength());
  this->Messages.Observe(surface);
  this->Recipe->SetSurface(surface);
  this->SetLevels(maximumLevel, metric);
}

//------------------------------------------------------------------------------
void SurfaceScene::SetLevels(int maximumLevel, vtkDepthTagMetric* metric)
{
  this->Recipe->SetMaximumLevel(this->Options.UniformLevel.value_or(maximumLevel));
  this->Recipe->SetMetric(this->Options.UniformLevel ? nullptr : metric);
  this->Options.PerEdge ? this->Recipe->SetLevelRuleToPerEdge()
                        : this->Recipe->SetLevelRuleToPerVertex();
  this->Options.WholeSegments.value_or(this->Options.IsPatch())
    ? this->Recipe->SetSegmentPolicyToWholeNumbers()
    : this->Recipe->SetSegmentPolicyToPowersOfTwo();
  this->Recipe->SetGeomorphing(this->Options.Geomorphing
      ? vtkAdaptiveRefinement::GEOMORPHING_AUTOMATIC
      : vtkAdaptiveRefinement::GEOMORPHING_OFF);
}

//------------------------------------------------------------------------------
void SurfaceScene::Show(int maximumLevel, vtkDepthTagMetric* metric)
{
  this->SetRecipe(maximumLevel, metric);
  this->Mapper->SetInputData(this->Mesh);
  this->Mapper->SetRefinement(this->Recipe);
  this->Mapper->SetMethod(this->Options.Method);
  this->Mapper->SetTargetNumberOfTriangles(this->Options.Budget);
  this->Actor->SetMapper(this->Mapper);
  if (this->Options.Wireframe)
  {
    this->Actor->GetProperty()->SetRepresentationToWireframe();
  }
  this->Renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
void SurfaceScene::SetTexture(vtkImageData* image)
{
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOff();
  texture->EdgeClampOn();
  this->Actor->SetTexture(texture);
}

//------------------------------------------------------------------------------
void SurfaceScene::SetLevelColours()
{
  std::string title = "Level";
  switch (this->Options.Color)
  {
    case ViewerOptions::ColorType::Own:
    case ViewerOptions::ColorType::Height:
    case ViewerOptions::ColorType::Slope:
    case ViewerOptions::ColorType::Aspect:
    case ViewerOptions::ColorType::Hillshade:
      return;
    case ViewerOptions::ColorType::Level:
      this->Mapper->SetColorModeToLevel();
      break;
    case ViewerOptions::ColorType::Pattern:
      this->Mapper->SetColorModeToPattern();
      title = "Pattern";
      break;
    case ViewerOptions::ColorType::Metric:
      this->Mapper->SetColorModeToMetric();
      title = "Metric";
      break;
  }
  this->Actor->SetTexture(nullptr);
  this->AddLegend(
    this->Mapper->GetLevelLookupTable(), title, "", this->Recipe->GetMaximumLevel() + 1);
}

//------------------------------------------------------------------------------
void SurfaceScene::SetCamera(vtkPolyData* surface, const ViewerDirection& defaultDirection,
  const std::optional<std::array<double, 3>>& centre)
{
  this->FitView(surface->GetPoints(), defaultDirection);
  if (centre)
  {
    MoveFocus(this->Renderer, *centre);
  }
  else if (this->Options.Zoom != 1.0)
  {
    // Moves closer to the surface, but not into it.
    FocusOnSurface(this->Renderer, surface);
  }
  this->Zoom();
}

//------------------------------------------------------------------------------
void SurfaceScene::Export(const std::string& fileName)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  this->Messages.Observe(filter, "refining");
  filter->SetInputData(this->Mesh);
  filter->SetRefinement(this->Recipe);
  filter->SetCamera(this->Renderer->GetActiveCamera());
  filter->SetViewportSize(this->Options.Size[0], this->Options.Size[1]);
  // A file has no animation, so vertices get their final positions.
  const int geomorphing = this->Recipe->GetGeomorphing();
  this->Recipe->GeomorphingOff();
  filter->Update();
  this->Recipe->SetGeomorphing(geomorphing);
  this->Messages.Check();
  if (filter->GetOutput()->GetNumberOfCells() == 0)
  {
    throw ViewerError(this->Options.Input + " has no cells to draw");
  }
  this->AddExportedData(filter->GetOutput());
  ExportedMesh mesh;
  mesh.Mesh = filter->GetOutput();
  mesh.UpAxis = this->IsTerrain() ? 2 : this->Options.UpAxis;
  WriteMesh(mesh, fileName, this->Messages);
}

//------------------------------------------------------------------------------
void SurfaceScene::Draw(vtkRenderWindow* window)
{
  if (this->Options.Statistics)
  {
    DrawWithStatistics(this->Mapper, this->Renderer, window, this->Messages, std::cout);
  }
  else
  {
    window->Render();
    this->Messages.Check();
  }
  if (this->Mapper->GetNumberOfCoarseFaces() == 0)
  {
    throw ViewerError(this->Options.Input + " has no cells to draw");
  }
}

//------------------------------------------------------------------------------
OptionNames SurfaceScene::GetUpdatedOptions()
{
  OptionNames names = this->ViewerScene::GetUpdatedOptions();
  names.insert({ "--alpha", "--amplitude", "--budget", "--error", "--frequency", "--level",
    "--max-level", "--method", "--metric", "--no-geomorphing", "--per-edge", "--pixels", "--reach",
    "--region", "--segments", "--wireframe" });
  return names;
}

//------------------------------------------------------------------------------
bool SurfaceScene::ApplyOptions(const OptionNames& changed)
{
  const auto has = [&](const OptionNames& names)
  {
    return std::any_of(
      names.begin(), names.end(), [&](const std::string& name) { return changed.count(name) > 0; });
  };
  if (has({ "--error", "--level", "--max-level", "--metric", "--no-geomorphing", "--per-edge",
        "--pixels", "--reach", "--region", "--segments" }))
  {
    const auto metric = this->MakeSceneMetric();
    this->SetLevels(this->Options.MaximumLevel.value_or(this->GetDefaultLevel()), metric);
  }
  if (has({ "--alpha", "--amplitude", "--frequency" }))
  {
    UpdateSurface(this->Options, this->Mesh->GetLength(), this->Recipe->GetSurface());
  }
  if (changed.count("--method"))
  {
    this->Mapper->SetMethod(this->Options.Method);
  }
  if (changed.count("--budget"))
  {
    this->Mapper->SetTargetNumberOfTriangles(this->Options.Budget);
  }
  if (changed.count("--wireframe"))
  {
    this->Options.Wireframe ? this->Actor->GetProperty()->SetRepresentationToWireframe()
                            : this->Actor->GetProperty()->SetRepresentationToSurface();
  }
  return this->ViewerScene::ApplyOptions(changed);
}

//------------------------------------------------------------------------------
SceneFigures SurfaceScene::GetFigures()
{
  const auto number = [](vtkIdType value) { return static_cast<double>(value); };
  return { { "triangles", number(this->Mapper->GetNumberOfDrawnTriangles()) },
    { "culled-triangles", number(this->Mapper->GetNumberOfCulledTriangles()) },
    { "coarse-faces", number(this->Mapper->GetNumberOfCoarseFaces()) },
    { "culled-faces", number(this->Mapper->GetNumberOfCulledFaces()) },
    { "patterns", number(this->Mapper->GetNumberOfUsedPatterns()) },
    { "draw-calls", number(this->Mapper->GetNumberOfDrawCalls()) },
    { "memory", number(this->Mapper->GetGraphicsMemorySize()) },
    { "selection-ms", 1000.0 * this->Mapper->GetSelectionTime() },
    { "buffer-builds", number(this->Mapper->GetNumberOfBufferBuilds()) },
    { "shader-builds", number(this->Mapper->GetNumberOfShaderBuilds()) } };
}

//------------------------------------------------------------------------------
std::vector<PatternCount> SurfaceScene::GetPatternCounts()
{
  vtkNew<vtkIdTypeArray> counts;
  this->Mapper->GetPatternCounts(counts);
  std::vector<PatternCount> patterns;
  for (vtkIdType i = 0; i < counts->GetNumberOfTuples(); ++i)
  {
    const vtkIdType* numbers = counts->GetPointer(5 * i);
    patterns.push_back({ { { static_cast<int>(numbers[0]), static_cast<int>(numbers[1]),
                           static_cast<int>(numbers[2]) } },
      numbers[3], numbers[4] });
  }
  return patterns;
}
