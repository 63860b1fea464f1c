// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Legend/LegendCode.h"

#include "Code/ColourCode.h"
#include "Code/SceneCode.h"

#include "vtkScalarsToColors.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cmath>
#include <string>

namespace
{
const CodeFunction AddRectangleFunction = {
  R"(def add_rectangle(renderer, left, bottom, right, top, red, green, blue, opacity):
    """Adds a rectangle in pixels from the lower left corner."""
    points = vtkPoints()
    for x, y in ((left, bottom), (right, bottom), (right, top), (left, top)):
        points.InsertNextPoint(x, y, 0.0)
    cells = vtkCellArray()
    cells.InsertNextCell(4)
    for i in range(4):
        cells.InsertCellPoint(i)
    shape = vtkPolyData()
    shape.SetPoints(points)
    shape.SetPolys(cells)
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(shape)
    actor = vtkActor2D()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(red, green, blue)
    actor.GetProperty().SetOpacity(opacity)
    renderer.AddViewProp(actor)
)",
  R"(// Adds a rectangle in pixels from the lower left corner.
static void AddRectangle(vtkRenderer* renderer, double left, double bottom, double right,
  double top, double red, double green, double blue, double opacity)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(left, bottom, 0.0);
  points->InsertNextPoint(right, bottom, 0.0);
  points->InsertNextPoint(right, top, 0.0);
  points->InsertNextPoint(left, top, 0.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4);
  for (int i = 0; i < 4; ++i)
  {
    cells->InsertCellPoint(i);
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddViewProp(actor);
}
)",
  { "vtkActor2D", "vtkCellArray", "vtkPoints", "vtkPolyData", "vtkPolyDataMapper2D",
    "vtkProperty2D", "vtkRenderer" }
};

const CodeFunction AddTextFunction = {
  R"(def add_text(renderer, text, x, y, size, is_title):
    """Adds dark text beside or below a point in pixels from the lower left corner."""
    actor = vtkTextActor()
    style = actor.GetTextProperty()
    style.SetColor(0.1, 0.1, 0.1)
    style.SetFontSize(size)
    style.ShadowOff()
    if is_title:
        style.SetVerticalJustificationToTop()
    else:
        style.SetVerticalJustificationToCentered()
    actor.SetInput(text)
    actor.SetPosition(x, y)
    renderer.AddViewProp(actor)
)",
  R"(// Adds dark text beside or below a point in pixels from the lower left corner.
static void AddText(
  vtkRenderer* renderer, const char* text, int x, int y, int size, bool isTitle)
{
  vtkNew<vtkTextActor> actor;
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetColor(0.1, 0.1, 0.1);
  style->SetFontSize(size);
  style->ShadowOff();
  if (isTitle)
  {
    style->SetVerticalJustificationToTop();
  }
  else
  {
    style->SetVerticalJustificationToCentered();
  }
  actor->SetInput(text);
  actor->SetPosition(x, y);
  renderer->AddViewProp(actor);
}
)",
  { "vtkRenderer", "vtkTextActor", "vtkTextProperty" }
};

// The colour at a position from 0 to 1, in Python and in C++.
std::array<std::string, 2> GetColourLines(LegendScale scale)
{
  switch (scale)
  {
    case LegendScale::Linear:
      return { { "        colours.GetColor(low + position * (high - low), colour)\n",
        "    colours->GetColor(low + position * (high - low), colour);\n" } };
    case LegendScale::Logarithmic:
      return { { "        colours.GetColor(low * math.pow(high / low, position), colour)\n",
        "    colours->GetColor(low * std::pow(high / low, position), colour);\n" } };
    case LegendScale::Indexed:
      break;
  }
  return { { "        colour = [0.0, 0.0, 0.0, 0.0]\n"
             "        row = int(position * colours.GetNumberOfAnnotatedValues())\n"
             "        colours.GetAnnotationColor(colours.GetAnnotatedValue(row), colour)\n",
    "    const auto row =\n"
    "      static_cast<vtkIdType>(position * colours->GetNumberOfAnnotatedValues());\n"
    "    colours->GetAnnotationColor(colours->GetAnnotatedValue(row), colour);\n" } };
}

CodeFunction MakeBarFunction(LegendScale scale)
{
  const auto [python, cxx] = GetColourLines(scale);
  const bool hasRange = scale != LegendScale::Indexed;
  return { R"(def add_bar(renderer, colours, left, bottom, width, height):
    """Adds a bar of colours: one rectangle for each row of pixels."""
)" + std::string(hasRange ? "    low, high = colours.GetRange()\n" : "") +
      R"(    points = vtkPoints()
    cells = vtkCellArray()
    shades = vtkUnsignedCharArray()
    shades.SetNumberOfComponents(3)
    for i in range(height):
        position = (i + 0.5) / height
        colour = [0.0, 0.0, 0.0]
)" + python +
      R"(        cells.InsertNextCell(4)
        for x, y in ((0, 0), (width, 0), (width, 1), (0, 1)):
            point = points.InsertNextPoint(left + x, bottom + i + y, 0.0)
            cells.InsertCellPoint(point)
        shades.InsertNextTuple([math.floor(255.0 * c + 0.5) for c in colour[:3]])
    shape = vtkPolyData()
    shape.SetPoints(points)
    shape.SetPolys(cells)
    shape.GetCellData().SetScalars(shades)
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(shape)
    actor = vtkActor2D()
    actor.SetMapper(mapper)
    renderer.AddViewProp(actor)
)",
    R"(// Adds a bar of colours: one rectangle for each row of pixels.
static void AddBar(
  vtkRenderer* renderer, vtkScalarsToColors* colours, int left, int bottom, int width, int height)
{
)" +
      std::string(hasRange ? "  const double low = colours->GetRange()[0];\n"
                             "  const double high = colours->GetRange()[1];\n"
                           : "") +
      R"(  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> shades;
  shades->SetNumberOfComponents(3);
  for (int i = 0; i < height; ++i)
  {
    const double position = (i + 0.5) / height;
    double colour[4];
)" + cxx +
      R"(    cells->InsertNextCell(4);
    cells->InsertCellPoint(points->InsertNextPoint(left, bottom + i, 0.0));
    cells->InsertCellPoint(points->InsertNextPoint(left + width, bottom + i, 0.0));
    cells->InsertCellPoint(points->InsertNextPoint(left + width, bottom + i + 1, 0.0));
    cells->InsertCellPoint(points->InsertNextPoint(left, bottom + i + 1, 0.0));
    shades->InsertNextTuple3(std::floor(255.0 * colour[0] + 0.5),
      std::floor(255.0 * colour[1] + 0.5), std::floor(255.0 * colour[2] + 0.5));
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(cells);
  shape->GetCellData()->SetScalars(shades);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  renderer->AddViewProp(actor);
}
)",
    { "vtkActor2D", "vtkCellArray", "vtkCellData", "vtkPoints", "vtkPolyData",
      "vtkPolyDataMapper2D", "vtkRenderer", "vtkScalarsToColors", "vtkUnsignedCharArray" } };
}
}

//------------------------------------------------------------------------------
LegendCode::LegendCode(SceneCode& code, vtkScalarsToColors* table)
  : Code(code)
  , Table(table)
{
}

//------------------------------------------------------------------------------
void LegendCode::AddRectangle(
  const std::array<int, 4>& sides, const std::array<double, 3>& color, double opacity)
{
  // The bar has colours of 8 bits.
  const auto round = [](double share) { return std::round(255.0 * share) / 255.0; };
  this->Code.CallFunction("AddRectangle", AddRectangleFunction,
    { CodeValue::Object("renderer"), sides[0], sides[1], sides[2], sides[3], round(color[0]),
      round(color[1]), round(color[2]), opacity });
}

//------------------------------------------------------------------------------
void LegendCode::AddBar(const std::array<int, 4>& place, LegendScale scale)
{
  this->Code.CallFunction("AddBar", MakeBarFunction(scale),
    { CodeValue::Object("renderer"), AddColourCode(this->Code, this->Table), place[0], place[1],
      place[2], place[3] });
}

//------------------------------------------------------------------------------
void LegendCode::AddText(vtkTextActor* text, bool isTitle)
{
  const double* position = text->GetPosition();
  this->Code.CallFunction("AddText", AddTextFunction,
    { CodeValue::Object("renderer"), text->GetInput(), static_cast<int>(position[0]),
      static_cast<int>(position[1]), text->GetTextProperty()->GetFontSize(),
      CodeValue::Flag(isTitle) });
}
