// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Legend/ViewerLegend.h"

#include "Code/SceneCode.h"
#include "Legend/LegendCode.h"
#include "Legend/LegendText.h"
#include "Text/PrintableText.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkLookupTable.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// In pixels.
const int SmallestSize[2] = { 240, 180 };
const int BarWidth = 20;
const int HighestBar = 200;
const int LowestBar = 60;
const int RowHeight = 20;   // pixels, in an indexed table
const int LowestRow = 12;   // pixels, in an indexed table
const int LabelPitch = 18;  // smallest distance of labels
const int SwatchHeight = 8; // of colours below and above the range
const int SwatchGap = 2;
const int Gap = 6;
const int FontSize = 14;
const int NarrowestTitle = 110;
const double TitleShare = 0.14; // relative to the picture's width
const int FewLines = 4;
const int MaximumLines = 6;
const double GroundOpacity = 0.4;
const int Dots = 72; // per inch, VTK's default

void SetLook(vtkTextProperty* text)
{
  text->SetColor(0.1, 0.1, 0.1);
  text->SetFontSize(FontSize);
  text->ShadowOff();
}
}

//------------------------------------------------------------------------------
ViewerLegend::ViewerLegend(vtkRenderer* renderer, vtkScalarsToColors* table,
  const std::string& title, int numberOfLabels, const std::optional<double>& mark)
  : Renderer(renderer)
  , Table(table)
  , Name(ToPrintable(title))
  , NumberOfLabels(numberOfLabels)
  , Mark(mark)
{
  const auto add = [&](vtkActor2D* actor, vtkPolyData* shape)
  {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    actor->SetMapper(mapper);
    renderer->AddViewProp(actor);
  };
  add(this->Ground, this->GroundShape);
  add(this->Bar, this->BarShape);
  this->Ground->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->Ground->GetProperty()->SetOpacity(GroundOpacity);
  this->Title = this->AddText();
  this->Title->GetTextProperty()->SetVerticalJustificationToTop();
  this->Tag = renderer->AddObserver(vtkCommand::StartEvent, this, &ViewerLegend::OnStart);
}

//------------------------------------------------------------------------------
ViewerLegend::~ViewerLegend()
{
  this->Renderer->RemoveObserver(this->Tag);
}

//------------------------------------------------------------------------------
std::array<int, 2> ViewerLegend::GetCorner(const int size[2])
{
  this->LayOut(size);
  return this->Corner;
}

//------------------------------------------------------------------------------
bool ViewerLegend::AddCode(SceneCode& code, vtkProp* prop) const
{
  const auto label = std::find_if(
    this->Labels.begin(), this->Labels.end(), [=](const auto& text) { return text == prop; });
  LegendCode legend(code, this->Table);
  const int left = this->Place[0];
  const int bottom = this->Place[1];
  const int height = this->Place[2];
  if (!this->Bar->GetVisibility())
  {
    return prop == this->Ground || prop == this->Bar || prop == this->Title ||
      label != this->Labels.end();
  }
  if (prop == this->Ground)
  {
    code.Note("The legend.");
    legend.AddRectangle({ { 0, this->Size[1] - this->Corner[1], this->Corner[0], this->Size[1] } },
      { { 1.0, 1.0, 1.0 } }, GroundOpacity);
    return true;
  }
  if (prop == this->Bar)
  {
    legend.AddBar({ { left, bottom, BarWidth, height } },
      this->Table->GetIndexedLookup() ? LegendScale::Indexed
        : this->IsLogarithmic()       ? LegendScale::Logarithmic
                                      : LegendScale::Linear);
    const auto addSwatch = [&](const double* color, int lower)
    {
      if (color)
      {
        legend.AddRectangle({ { left, lower, left + BarWidth, lower + SwatchHeight } },
          { { color[0], color[1], color[2] } }, 1.0);
      }
    };
    addSwatch(this->GetBelowColor(), bottom - SwatchGap - SwatchHeight);
    addSwatch(this->GetAboveColor(), bottom + height + SwatchGap);
    return true;
  }
  if (prop == this->Title)
  {
    legend.AddText(this->Title, true);
    return true;
  }
  if (label != this->Labels.end() && prop->GetVisibility())
  {
    legend.AddText(*label, false);
  }
  return label != this->Labels.end();
}

//------------------------------------------------------------------------------
void ViewerLegend::OnStart(vtkObject*, unsigned long, void*)
{
  this->LayOut(this->Renderer->GetSize());
}

//------------------------------------------------------------------------------
void ViewerLegend::LayOut(const int size[2])
{
  const vtkMTimeType time = this->Table->GetMTime();
  if (std::equal(size, size + 2, this->Size) && time == this->TableTime)
  {
    return;
  }
  this->TableTime = time;
  std::copy_n(size, 2, this->Size);
  const int margin = std::min(std::max(3 * std::min(size[0], size[1]) / 200, 4), 16);
  this->SetTitle(size, margin);
  int box[4];
  vtkTextRenderer::GetInstance()->GetBoundingBox(
    this->Title->GetTextProperty(), this->Title->GetInput(), box, Dots);
  const int titleHeight = box[3] - box[2] + 1;
  // The labels at the ends extend beyond the bar by half their height.
  const int overhang = this->Table->GetIndexedLookup() ? 0 : FontSize / 2;
  const int swatch = SwatchGap + SwatchHeight;
  const int overhangs[2] = { this->GetBelowColor() ? std::max(overhang, swatch) : overhang,
    this->GetAboveColor() ? std::max(overhang, swatch) : overhang };
  const int top = size[1] - margin - titleHeight - Gap - overhangs[1];
  const int height = this->GetBarHeight(top - margin - overhangs[0]);
  const bool isShown = height > 0 && size[0] >= SmallestSize[0] && size[1] >= SmallestSize[1];
  const std::vector<Row> rows = isShown ? this->GetRows(height) : std::vector<Row>();
  int labelWidth = 0;
  while (this->Labels.size() < rows.size())
  {
    this->Labels.push_back(this->AddText());
    this->Labels.back()->GetTextProperty()->SetVerticalJustificationToCentered();
  }
  for (std::size_t i = 0; i < this->Labels.size(); ++i)
  {
    vtkTextActor* label = this->Labels[i];
    label->SetVisibility(i < rows.size());
    if (i < rows.size())
    {
      label->SetInput(rows[i].Text.c_str());
      label->SetPosition(
        margin + BarWidth + Gap, top - height + std::lround(rows[i].Position * height));
      labelWidth = std::max(labelWidth, this->GetWidth(label->GetTextProperty(), rows[i].Text));
    }
  }
  this->Title->SetVisibility(isShown);
  this->Bar->SetVisibility(isShown);
  this->Ground->SetVisibility(isShown);
  this->Corner = { { 0, 0 } };
  if (isShown)
  {
    this->Place = { { margin, top - height, height } };
    this->DrawBar(margin, top - height, height);
    this->Corner = { { margin + std::max(box[1] - box[0] + 1, BarWidth + Gap + labelWidth) + Gap,
      size[1] - top + height + overhangs[0] + Gap } };
    this->DrawGround(size);
  }
}

//------------------------------------------------------------------------------
void ViewerLegend::SetTitle(const int size[2], int margin)
{
  const int limit = std::max(NarrowestTitle, static_cast<int>(TitleShare * size[0]));
  vtkTextProperty* property = this->Title->GetTextProperty();
  const auto getWidth = [&](const std::string& text) { return this->GetWidth(property, text); };
  WrappedText title;
  for (int fontSize : { FontSize, FontSize - 2, FontSize - 4 })
  {
    property->SetFontSize(fontSize);
    title = WrapText(this->Name, limit, FewLines, getWidth);
    if (title.IsAtWords)
    {
      break;
    }
  }
  if (!title.IsAtWords)
  {
    title = WrapText(this->Name, limit, MaximumLines, getWidth);
  }
  if (!this->Table->GetIndexedLookup() && !this->IsLogarithmic())
  {
    const std::string factor = MakeLegendLabels(this->Table->GetRange(), 2).Factor;
    title.Text += factor.empty() ? "" : "\n" + factor;
  }
  this->Title->SetInput(title.Text.c_str());
  this->Title->SetPosition(margin, size[1] - margin);
}

//------------------------------------------------------------------------------
int ViewerLegend::GetBarHeight(int available) const
{
  if (!this->Table->GetIndexedLookup())
  {
    return available < LowestBar ? 0 : std::min(available, HighestBar);
  }
  const int rows = static_cast<int>(this->Table->GetNumberOfAnnotatedValues());
  const int rowHeight = rows > 0 ? std::min(available / rows, RowHeight) : 0;
  return rowHeight < LowestRow ? 0 : rows * rowHeight;
}

//------------------------------------------------------------------------------
std::vector<ViewerLegend::Row> ViewerLegend::GetRows(int barHeight)
{
  std::vector<Row> rows;
  if (this->Table->GetIndexedLookup())
  {
    const int number = static_cast<int>(this->Table->GetNumberOfAnnotatedValues());
    for (int i = 0; i < number; ++i)
    {
      rows.push_back({ (i + 0.5) / number, ToPrintable(this->Table->GetAnnotation(i)) });
    }
    return rows;
  }
  const double* range = this->Table->GetRange();
  const int most = barHeight / LabelPitch + 1;
  if (this->IsLogarithmic())
  {
    for (const LegendLabel& label : MakeLogLegendLabels(range, most).Labels)
    {
      const double position = range[1] > range[0]
        ? std::log(label.Value / range[0]) / std::log(range[1] / range[0])
        : 0.5;
      rows.push_back({ position, label.Text });
    }
    return rows;
  }
  // A short bar has fewer labels, still evenly spaced.
  int number = std::min(this->NumberOfLabels, most);
  while (number > 2 && (this->NumberOfLabels - 1) % (number - 1) != 0)
  {
    --number;
  }
  for (const LegendLabel& label : MakeLegendLabels(range, std::max(number, 2)).Labels)
  {
    const double position =
      range[1] > range[0] ? (label.Value - range[0]) / (range[1] - range[0]) : 0.5;
    rows.push_back({ position, label.Text });
  }
  this->AddMark(rows, barHeight);
  return rows;
}

//------------------------------------------------------------------------------
void ViewerLegend::AddMark(std::vector<Row>& rows, int barHeight)
{
  const double* range = this->Table->GetRange();
  if (!this->Mark || rows.size() < 2 || !MakeLegendLabels(range, 2).Factor.empty())
  {
    return;
  }
  const double position = (*this->Mark - range[0]) / (range[1] - range[0]);
  const double pitch = static_cast<double>(LabelPitch) / barHeight;
  if (!(position >= pitch && position <= 1.0 - pitch))
  {
    return; // the ends are labelled
  }
  const auto isNear = [&](const Row& row) { return std::abs(row.Position - position) < pitch; };
  rows.erase(std::remove_if(rows.begin(), rows.end(), isNear), rows.end());
  std::ostringstream text;
  text << *this->Mark;
  rows.push_back({ position, text.str() });
}

//------------------------------------------------------------------------------
int ViewerLegend::GetWidth(vtkTextProperty* property, const std::string& text)
{
  int box[4];
  return vtkTextRenderer::GetInstance()->GetBoundingBox(property, text, box, Dots)
    ? box[1] - box[0] + 1
    : 0;
}

//------------------------------------------------------------------------------
void ViewerLegend::DrawGround(const int size[2])
{
  const double right = this->Corner[0];
  const double bottom = size[1] - this->Corner[1];
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, bottom, 0.0);
  points->InsertNextPoint(right, bottom, 0.0);
  points->InsertNextPoint(right, size[1], 0.0);
  points->InsertNextPoint(0.0, size[1], 0.0);
  vtkNew<vtkCellArray> quad;
  quad->InsertNextCell({ 0, 1, 2, 3 });
  this->GroundShape->SetPoints(points);
  this->GroundShape->SetPolys(quad);
}

//------------------------------------------------------------------------------
void ViewerLegend::DrawBar(int left, int bottom, int height)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const auto add = [&](int lower, int upper, const double color[3])
  {
    const vtkIdType first = points->GetNumberOfPoints();
    points->InsertNextPoint(left, lower, 0.0);
    points->InsertNextPoint(left + BarWidth, lower, 0.0);
    points->InsertNextPoint(left + BarWidth, upper, 0.0);
    points->InsertNextPoint(left, upper, 0.0);
    quads->InsertNextCell({ first, first + 1, first + 2, first + 3 });
    colors->InsertNextTuple3(
      std::round(255.0 * color[0]), std::round(255.0 * color[1]), std::round(255.0 * color[2]));
  };
  // One rectangle per row of pixels.
  for (int i = 0; i < height; ++i)
  {
    double color[3];
    this->GetColor((i + 0.5) / height, color);
    add(bottom + i, bottom + i + 1, color);
  }
  if (const double* below = this->GetBelowColor())
  {
    add(bottom - SwatchGap - SwatchHeight, bottom - SwatchGap, below);
  }
  if (const double* above = this->GetAboveColor())
  {
    const int top = bottom + height;
    add(top + SwatchGap, top + SwatchGap + SwatchHeight, above);
  }
  this->BarShape->SetPoints(points);
  this->BarShape->SetPolys(quads);
  this->BarShape->GetCellData()->SetScalars(colors);
}

//------------------------------------------------------------------------------
void ViewerLegend::GetColor(double position, double color[3])
{
  if (this->Table->GetIndexedLookup())
  {
    const auto row = static_cast<vtkIdType>(position * this->Table->GetNumberOfAnnotatedValues());
    double rgba[4];
    this->Table->GetAnnotationColor(this->Table->GetAnnotatedValue(row), rgba);
    std::copy_n(rgba, 3, color);
    return;
  }
  const double* range = this->Table->GetRange();
  this->Table->GetColor(this->IsLogarithmic() ? range[0] * std::pow(range[1] / range[0], position)
                                              : range[0] + position * (range[1] - range[0]),
    color);
}

//------------------------------------------------------------------------------
bool ViewerLegend::IsLogarithmic() const
{
  auto* function = vtkColorTransferFunction::SafeDownCast(this->Table);
  return this->Table->UsingLogScale() || (function && function->GetScale() == VTK_CTF_LOG10);
}

//------------------------------------------------------------------------------
const double* ViewerLegend::GetBelowColor() const
{
  auto* function = vtkColorTransferFunction::SafeDownCast(this->Table);
  auto* table = vtkLookupTable::SafeDownCast(this->Table);
  const bool isUsed = function ? function->GetUseBelowRangeColor() != 0
                               : table && table->GetUseBelowRangeColor() != 0;
  return !isUsed ? nullptr
    : function   ? function->GetBelowRangeColor()
                 : table->GetBelowRangeColor();
}

//------------------------------------------------------------------------------
const double* ViewerLegend::GetAboveColor() const
{
  auto* function = vtkColorTransferFunction::SafeDownCast(this->Table);
  auto* table = vtkLookupTable::SafeDownCast(this->Table);
  const bool isUsed = function ? function->GetUseAboveRangeColor() != 0
                               : table && table->GetUseAboveRangeColor() != 0;
  return !isUsed ? nullptr
    : function   ? function->GetAboveRangeColor()
                 : table->GetAboveRangeColor();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextActor> ViewerLegend::AddText()
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  SetLook(text->GetTextProperty());
  this->Renderer->AddViewProp(text);
  return text;
}
