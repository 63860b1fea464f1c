// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeScene.h"

#include "Code/DataCode.h"
#include "Files/VolumeReader.h"
#include "Scene/ArrayExtremes.h"
#include "Scene/ArrayNames.h"
#include "Scene/CellNumbers.h"
#include "Scene/MeshColours.h"
#include "Scene/TimeSteps.h"
#include "Scene/ViewerStatistics.h"
#include "Scene/VolumeFunctions.h"
#include "Scene/VolumeThickness.h"
#include "Text/ViewerText.h"

#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataSet.h"
#include "vtkContourValues.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkPlane.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProbe.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{
const double Step = 0.02; // share of the range
const double OpacityStep = 1.25;
const double PeakOpacity = 0.6; // default for isosurfaces

void CheckCells(const std::string& fileName, vtkDataObject* data)
{
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
    {
      if (IsVolumeCell(block, cell))
      {
        return;
      }
    }
  }
  throw ViewerError(fileName + " has no 3D cells; omit --volume to draw its surface");
}
}

//------------------------------------------------------------------------------
VolumeScene::VolumeScene(const ViewerOptions& options, ViewerMessages& messages)
  : ViewerScene(options, messages)
  , GivenArray(options.VolumeArray)
  , Extremes(this->Renderer)
  , Cut(options.Clip)
{
  // A light background suits translucent volumes.
  this->Renderer->SetBackground(0.98, 0.98, 0.98);
  this->Renderer->SetBackground2(0.84, 0.87, 0.91);
  this->Steps = std::make_unique<TimeSteps>(options, this->Renderer, messages);
  const auto data = this->ReadStep();
  CheckCells(options.Input, data);
  this->Array = FindVolumeArray(this->Options, data);
  if (options.CoversAllSteps())
  {
    this->ExtendRangeByAllSteps();
  }
  std::copy_n(this->Array.Range, 2, this->WholeRange.begin());
  if (options.Range)
  {
    std::copy_n(options.Range->begin(), 2, this->Array.Range);
  }
  CheckRange(this->Options, this->Array.Name, this->Array.Range);
  messages.Observe(this->Mapper);
  this->Mapper->SetInputDataObject(data);
  this->Array.IsOfPoints ? this->Mapper->SetScalarModeToUsePointFieldData()
                         : this->Mapper->SetScalarModeToUseCellFieldData();
  this->Mapper->SelectScalarArray(this->Array.Name.c_str());
  this->Mapper->SetVectorMode(this->Array.IsVector ? vtkGPUUnstructuredGridVolumeMapper::MAGNITUDE
                                                   : vtkGPUUnstructuredGridVolumeMapper::DISABLED);
  this->ApplyMethod();
  this->Measure(data);
  this->ChooseFunctions(data);
  if (this->Cut.Get())
  {
    this->Cut.WarnIfEmpty(this->Bounds, this->Messages);
    this->Mapper->AddClippingPlane(this->Cut.Get());
  }
  this->Property->SetAmbient(0.3);
  this->Volume->SetMapper(this->Mapper);
  this->Volume->SetProperty(this->Property);
  this->Probe->SetRenderer(this->Renderer);
  this->Renderer->AddVolume(this->Volume);
  this->AddLegend(this->Property->GetRGBTransferFunction(),
    GetArrayTitle(this->Array.Name, this->Array.IsVector ? 3 : 1), this->Array.Unit, 5);
  this->ShowExtremes();
  this->SetView(this->Bounds);
}

//------------------------------------------------------------------------------
VolumeScene::~VolumeScene() = default;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> VolumeScene::ReadStep()
{
  auto data = ReadVolume(
    this->Steps->GetFile(), this->Steps->GetStep(), this->Steps->GetFilter(), this->Messages);
  this->Options.VolumeArray = this->Steps->GetFilter().GetArray();
  return data;
}

//------------------------------------------------------------------------------
int VolumeScene::GetNumberOfTimeSteps()
{
  return this->Steps->GetNumber();
}

//------------------------------------------------------------------------------
void VolumeScene::SetTimeStep(int step)
{
  this->Steps->SetStep(step);
  const auto data = this->ReadStep();
  if (!this->Options.Range && !this->Options.CoversAllSteps() && this->Options.Transfer.empty())
  {
    this->ExtendRange(FindVolumeArray(this->Options, data));
  }
  this->Mapper->SetInputDataObject(data);
  this->ShowExtremes();
}

//------------------------------------------------------------------------------
void VolumeScene::ShowExtremes()
{
  this->Extremes.Clear();
  if (!this->Options.HasExtremes)
  {
    return;
  }
  const auto extremes = FindExtremes(this->Mapper->GetInputDataObject(0, 0), this->Array.Name,
    this->Array.IsOfPoints, this->Cut.Get());
  if (extremes)
  {
    MarkExtremes(*extremes, this->Array.IsOfPoints, nullptr, this->Extremes);
  }
}

//------------------------------------------------------------------------------
void VolumeScene::ExtendRange(const VolumeArray& array)
{
  double* range = this->Array.Range;
  if (array.Range[0] >= range[0] && array.Range[1] <= range[1])
  {
    return;
  }
  CheckRange(this->Options, array.Name, array.Range);
  range[0] = std::min(range[0], array.Range[0]);
  range[1] = std::max(range[1], array.Range[1]);
  std::copy_n(range, 2, this->WholeRange.begin());
  this->Array.Quantiles = array.Quantiles;
  this->Nodes = MakeTransferNodes(this->Options, this->Array, this->CellsOfSide, this->Thickness);
  this->SetFunctions();
}

//------------------------------------------------------------------------------
void VolumeScene::ExtendRangeByAllSteps()
{
  const int shown = this->Steps->GetStep();
  double* range = this->Array.Range;
  for (int step = 0; step < this->GetNumberOfTimeSteps(); ++step)
  {
    this->Steps->SetStep(step);
    const VolumeArray array = FindVolumeArray(this->Options, this->ReadStep());
    range[0] = std::min(range[0], array.Range[0]);
    range[1] = std::max(range[1], array.Range[1]);
  }
  this->Steps->SetStep(shown);
}

//------------------------------------------------------------------------------
void VolumeScene::Measure(vtkDataObject*)
{
  this->Mapper->GetBounds(this->Bounds);
  this->Diagonal = std::hypot(this->Bounds[1] - this->Bounds[0], this->Bounds[3] - this->Bounds[2],
    this->Bounds[5] - this->Bounds[4]);
  if (!std::isfinite(this->Diagonal) || this->Diagonal <= 0.0)
  {
    throw ViewerError(
      this->Options.Input + " has no extent: its points are not finite, or coincide");
  }
}

//------------------------------------------------------------------------------
void VolumeScene::ChooseFunctions(vtkDataObject* data)
{
  this->CellsOfSide =
    std::cbrt(static_cast<double>(data->GetNumberOfElements(vtkDataObject::CELL)));
  if (this->Options.Transfer.empty())
  {
    this->Thickness = GetMeanChord(data) / this->Diagonal;
    this->Nodes = MakeTransferNodes(this->Options, this->Array, this->CellsOfSide, this->Thickness);
  }
  else
  {
    this->Nodes = ReadTransferFile(this->Options.Transfer);
  }
  this->Property->SetScalarOpacityUnitDistance(
    this->Options.UnitDistance.value_or(this->Diagonal / this->CellsOfSide));
  this->IsoSurfaces = this->Options.IsoSurfaces;
  if (this->Options.BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    this->MoveIsoSurfaces(0.0);
  }
  this->SetFunctions();
}

//------------------------------------------------------------------------------
void VolumeScene::ApplyMethod()
{
  const vtkNew<vtkGPUUnstructuredGridVolumeMapper> defaults;
  this->Mapper->SetMethod(this->Options.VolumeMethod);
  this->Mapper->SetBlendMode(this->Options.BlendMode);
  this->Mapper->SetIntegration(this->Options.Integration);
  this->Mapper->SetShapeTolerance(
    this->Options.ShapeTolerance.value_or(defaults->GetShapeTolerance()));
  this->Mapper->SetFieldTolerance(
    this->Options.FieldTolerance.value_or(defaults->GetFieldTolerance()));
}

//------------------------------------------------------------------------------
OptionNames VolumeScene::GetUpdatedOptions()
{
  OptionNames names = this->ViewerScene::GetUpdatedOptions();
  names.insert({ "--above", "--below", "--blend", "--clip", "--extremes", "--field-tolerance",
    "--integration", "--isosurfaces", "--palette", "--range", "--shape-tolerance", "--transfer",
    "--unit-distance", "--volume-method" });
  return names;
}

//------------------------------------------------------------------------------
bool VolumeScene::ApplyOptions(const OptionNames& changed)
{
  // The range of all time steps is found when a scene is built.
  if (this->Options.HasRangeOfAllSteps || (changed.count("--clip") && !this->ApplyCut()))
  {
    return false;
  }
  this->ApplyMethod();
  std::copy_n(this->Options.Range.value_or(this->WholeRange).begin(), 2, this->Array.Range);
  this->ChooseFunctions(this->Mapper->GetInputDataObject(0, 0));
  this->ShowExtremes();
  return this->ViewerScene::ApplyOptions(changed);
}

//------------------------------------------------------------------------------
bool VolumeScene::ApplyCut()
{
  if (!this->Options.Clip)
  {
    return !this->Cut.Get();
  }
  if (this->Cut.Get())
  {
    this->Cut.Set(*this->Options.Clip);
    return true;
  }
  this->Cut.Set(*this->Options.Clip);
  this->Mapper->AddClippingPlane(this->Cut.Get());
  return true;
}

//------------------------------------------------------------------------------
SceneContent VolumeScene::GetContent()
{
  SceneContent content;
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(this->Mapper->GetInputDataObject(0, 0)))
  {
    for (const SceneArray& array : FindArrays(block))
    {
      const auto isSame = [&](const SceneArray& other)
      { return other.Name == array.Name && other.IsOfPoints == array.IsOfPoints; };
      if (std::none_of(content.Arrays.begin(), content.Arrays.end(), isSame))
      {
        content.Arrays.push_back(array);
      }
    }
  }
  content.Array = this->Array.Name;
  content.Times = this->Steps->GetFile().GetTimes();
  content.Step = this->Steps->GetStep();
  content.Range = { { this->Array.Range[0], this->Array.Range[1] } };
  content.Bounds.emplace();
  std::copy_n(this->Bounds, 6, content.Bounds->begin());
  content.HasSolidCells = true;
  content.Transfer = this->Nodes;
  content.UnitDistance = this->Property->GetScalarOpacityUnitDistance();
  content.Counts = this->CountValues();
  return content;
}

//------------------------------------------------------------------------------
std::vector<double> VolumeScene::CountValues() const
{
  // Between quantiles, which are of equal shares, values are spread evenly.
  const std::vector<double>& quantiles = this->Array.Quantiles;
  const int bins = 64;
  std::vector<double> counts(bins, 0.0);
  const double size = this->Array.Range[1] - this->Array.Range[0];
  for (std::size_t i = 1; size > 0.0 && i < quantiles.size(); ++i)
  {
    const double first = (quantiles[i - 1] - this->Array.Range[0]) / size * bins;
    const double last = (quantiles[i] - this->Array.Range[0]) / size * bins;
    for (int bin = 0; bin < bins; ++bin)
    {
      const double overlap = std::min(last, bin + 1.0) - std::max(first, static_cast<double>(bin));
      const bool isAtOnce = last <= first && first >= bin && first <= bin + 1;
      counts[bin] += isAtOnce ? 1.0 : overlap > 0.0 ? overlap / (last - first) : 0.0;
    }
  }
  return counts;
}

//------------------------------------------------------------------------------
void VolumeScene::AddDataCode(SceneCode& code)
{
  DataPreparation preparation;
  preparation.Input = this->Options.Input;
  preparation.Quantity = this->GivenArray;
  ::AddDataCode(code, preparation, this->Mapper->GetInputDataObject(0, 0));
}

//------------------------------------------------------------------------------
SceneFigures VolumeScene::GetFigures()
{
  const auto number = [](vtkIdType value) { return static_cast<double>(value); };
  return { { "cells", number(this->Mapper->GetNumberOfDrawnCells()) },
    { "layers", number(this->Mapper->GetNumberOfLayers()) },
    { "memory", number(this->Mapper->GetGraphicsMemorySize()) },
    { "buffer-builds", number(this->Mapper->GetNumberOfBufferBuilds()) },
    { "shader-builds", number(this->Mapper->GetNumberOfShaderBuilds()) },
    { "table-builds", number(this->Mapper->GetNumberOfTableBuilds()) } };
}

//------------------------------------------------------------------------------
void VolumeScene::SetFunctions()
{
  const bool isDefault = this->Options.Transfer.empty();
  SetTransferNodes(this->Property,
    isDefault && this->IsByLength() ? AddPeaks(this->Nodes, this->IsoSurfaces, PeakOpacity)
                                    : this->Nodes,
    this->OpacityFactor,
    isDefault ? MakeColourFunction(this->Options, this->Array.Range).Get() : nullptr);
  this->Property->GetIsoSurfaceValues()->SetNumberOfContours(0);
  for (std::size_t i = 0; i < this->IsoSurfaces.size(); ++i)
  {
    this->Property->GetIsoSurfaceValues()->SetValue(static_cast<int>(i), this->IsoSurfaces[i]);
  }
  this->Mapper->SetIsoSurfaces(!this->IsoSurfaces.empty());
  this->Property->SetShade(!this->IsoSurfaces.empty());
}

//------------------------------------------------------------------------------
bool VolumeScene::IsByLength() const
{
  using Mapper = vtkVolumeMapper;
  const int mode = this->Options.BlendMode;
  return mode == Mapper::COMPOSITE_BLEND || mode == Mapper::ADDITIVE_BLEND;
}

//------------------------------------------------------------------------------
void VolumeScene::Draw(vtkRenderWindow* window)
{
  if (!this->Options.Statistics)
  {
    window->Render();
    this->Messages.Check();
    return;
  }
  const double milliseconds = MeasureFrame(this->Renderer, window, this->Messages);
  std::cout << std::fixed << std::setprecision(1)
            << "drawn cells: " << this->Mapper->GetNumberOfDrawnCells() << "\n"
            << "layers: " << this->Mapper->GetNumberOfLayers() << "\n"
            << "graphics memory: " << this->Mapper->GetGraphicsMemorySize() / 1048576.0 << " MiB\n"
            << "frame time: " << milliseconds << " ms" << std::endl;
}

//------------------------------------------------------------------------------
std::string VolumeScene::DescribePixel(const int pixel[2])
{
  if (!this->Probe->Probe(pixel[0], pixel[1]))
  {
    return "";
  }
  const double* place = this->Probe->GetPosition();
  const double digits = 1e-4 * this->Diagonal;
  std::ostringstream value;
  value << std::setprecision(4) << this->Probe->GetValue();
  return "x " + FormatNumber(place[0], digits) + "  y " + FormatNumber(place[1], digits) + "  z " +
    FormatNumber(place[2], digits) + "\n" +
    DescribeCell(this->Probe->GetDataSet(), this->Probe->GetCellId(), place) + "\n" +
    this->Array.Name + " " + value.str();
}

//------------------------------------------------------------------------------
bool VolumeScene::FindPoint(const int pixel[2], double point[3])
{
  const bool isHit = this->Probe->Probe(pixel[0], pixel[1]);
  if (isHit)
  {
    std::copy_n(this->Probe->GetPosition(), 3, point);
  }
  return isHit;
}

//------------------------------------------------------------------------------
std::string VolumeScene::Change(char key)
{
  const std::string shown = this->Steps->Change(key, [this](int step) { this->SetTimeStep(step); });
  if (!shown.empty())
  {
    return shown;
  }
  switch (key)
  {
    case '+':
    case '-':
      this->ChangeOpacity(key == '+' ? OpacityStep : 1.0 / OpacityStep);
      return this->IsByLength()
        ? "--unit-distance " + JoinNumbers({ this->Property->GetScalarOpacityUnitDistance() })
        : "opacity times " + JoinNumbers({ this->OpacityFactor });
    case '.':
    case ',':
      this->MoveIsoSurfaces(key == '.' ? Step : -Step);
      this->SetFunctions();
      return "--isosurfaces " + JoinNumbers(this->IsoSurfaces);
    default:
      return this->MoveCut(key);
  }
}

//------------------------------------------------------------------------------
void VolumeScene::ChangeOpacity(double factor)
{
  if (this->IsByLength())
  {
    this->Property->SetScalarOpacityUnitDistance(
      this->Property->GetScalarOpacityUnitDistance() / factor);
    return;
  }
  this->OpacityFactor *= factor;
  this->SetFunctions();
}

//------------------------------------------------------------------------------
void VolumeScene::MoveIsoSurfaces(double share)
{
  const double size = this->Array.Range[1] - this->Array.Range[0];
  if (this->IsoSurfaces.empty())
  {
    this->IsoSurfaces = { this->Array.Range[0] + 0.5 * size };
    return;
  }
  for (double& value : this->IsoSurfaces)
  {
    value += share * size;
  }
}

//------------------------------------------------------------------------------
std::string VolumeScene::MoveCut(char key)
{
  const bool isNew = !this->Cut.Get();
  if (!this->Cut.Move(key, this->Bounds, this->Renderer))
  {
    return "";
  }
  if (isNew)
  {
    this->Mapper->AddClippingPlane(this->Cut.Get());
  }
  this->ShowExtremes();
  return this->Cut.GetOption();
}
