// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MeshColours.h"

#include "Files/ViewerFile.h"
#include "Options/Palettes.h"
#include "Options/ViewerOptions.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkLookupTable.h"

#include <cmath>

namespace
{
const int LogColors = 1024;

// VTK 9.1 does not copy the colours out of range.
template <class Colours>
void CopyOutOfRange(vtkScalarsToColors* from, vtkScalarsToColors* to)
{
  auto* source = Colours::SafeDownCast(from);
  auto* target = Colours::SafeDownCast(to);
  if (source && target)
  {
    target->SetUseBelowRangeColor(source->GetUseBelowRangeColor());
    target->SetBelowRangeColor(source->GetBelowRangeColor());
    target->SetUseAboveRangeColor(source->GetUseAboveRangeColor());
    target->SetAboveRangeColor(source->GetAboveRangeColor());
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName, ViewerMessages& messages)
{
  CheckFile(fileName);
  const ReadingGuard guard({ fileName });
  messages.StartReading();
  auto reader = vtkSmartPointer<vtkImageReader2>::Take(
    vtkImageReader2Factory::CreateImageReader2(fileName.c_str()));
  if (!reader)
  {
    throw ViewerError("cannot read " + fileName + ": it is not a PNG, JPEG, TIFF or BMP file");
  }
  messages.Observe(reader, "reading");
  reader->SetFileName(fileName.c_str());
  reader->Update();
  messages.CheckReading();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> MakeColourFunction(
  const ViewerOptions& options, const double range[2])
{
  const auto table = MakePalette(options.Palette.empty() ? "viridis" : options.Palette,
    { { range[0], range[1] } }, options.HasLogColors);
  if (options.BelowColor)
  {
    table->SetBelowRangeColor(options.BelowColor->data());
    table->UseBelowRangeColorOn();
  }
  if (options.AboveColor)
  {
    table->SetAboveRangeColor(options.AboveColor->data());
    table->UseAboveRangeColorOn();
  }
  return table;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkScalarsToColors> MakeColours(const ViewerOptions& options, const double range[2])
{
  const auto function = MakeColourFunction(options, range);
  function->SetVectorModeToMagnitude();
  if (!options.HasLogColors)
  {
    return function;
  }
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetVectorModeToMagnitude();
  table->SetNumberOfTableValues(LogColors);
  table->SetTableRange(function->GetRange());
  table->SetScaleToLog10();
  const double low = std::log(function->GetRange()[0]);
  const double high = std::log(function->GetRange()[1]);
  for (int i = 0; i < LogColors; ++i)
  {
    const double* color = function->GetColor(std::exp(low + (i + 0.5) / LogColors * (high - low)));
    table->SetTableValue(i, color[0], color[1], color[2], 1.0);
  }
  const double* below = function->GetBelowRangeColor();
  table->SetBelowRangeColor(below[0], below[1], below[2], 1.0);
  table->SetUseBelowRangeColor(function->GetUseBelowRangeColor());
  const double* above = function->GetAboveRangeColor();
  table->SetAboveRangeColor(above[0], above[1], above[2], 1.0);
  table->SetUseAboveRangeColor(function->GetUseAboveRangeColor());
  return table;
}

//------------------------------------------------------------------------------
void CopyColours(vtkScalarsToColors* from, vtkScalarsToColors* to)
{
  to->DeepCopy(from);
  CopyOutOfRange<vtkColorTransferFunction>(from, to);
  CopyOutOfRange<vtkLookupTable>(from, to);
}

//------------------------------------------------------------------------------
void CheckRange(const ViewerOptions& options, const std::string& array, const double range[2])
{
  if (!options.HasLogColors || range[0] > 0.0)
  {
    return;
  }
  const std::string values = "--log needs values above 0, and '" + array + "' is from " +
    JoinNumbers({ range[0] }) + " to " + JoinNumbers({ range[1] });
  throw ViewerError(options.Input + ": " + values +
    (range[1] > 0.0 ? "; set the lowest coloured value, for example --range " +
          JoinNumbers({ 1e-3 * range[1], range[1] })
                    : "; omit --log"));
}
