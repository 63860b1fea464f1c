// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/OverlayCode.h"

#include "Code/ObjectCode.h"
#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <string>

namespace
{
const CodeFunction AddLineFunction = {
  R"(def add_line(renderer, x0, y0, x1, y1, width, red, green, blue):
    """Adds a line between points in pixels from the lower left corner."""
    points = vtkPoints()
    points.InsertNextPoint(x0, y0, 0.0)
    points.InsertNextPoint(x1, y1, 0.0)
    cells = vtkCellArray()
    cells.InsertNextCell(2)
    cells.InsertCellPoint(0)
    cells.InsertCellPoint(1)
    shape = vtkPolyData()
    shape.SetPoints(points)
    shape.SetLines(cells)
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(shape)
    actor = vtkActor2D()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(red, green, blue)
    actor.GetProperty().SetLineWidth(width)
    renderer.AddViewProp(actor)
)",
  R"(// Adds a line between points in pixels from the lower left corner.
static void AddLine(vtkRenderer* renderer, double x0, double y0, double x1, double y1, float width,
  double red, double green, double blue)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x0, y0, 0.0);
  points->InsertNextPoint(x1, y1, 0.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetLines(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->SetLineWidth(width);
  renderer->AddViewProp(actor);
}
)",
  { "vtkActor2D", "vtkCellArray", "vtkPoints", "vtkPolyData", "vtkPolyDataMapper2D",
    "vtkProperty2D", "vtkRenderer" }
};

// Points of VTK are float. This is the shortest number that is stored as the same one.
double Shorten(double number)
{
  std::array<char, 64> digits;
  const auto stored = static_cast<float>(number);
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), stored).ptr;
  double shortened = 0.0;
  std::from_chars(digits.data(), end, shortened);
  return shortened;
}

void AddColor(
  SceneCode& code, const std::string& variable, const std::string& method, const double* color)
{
  code.Call(variable, method, { color[0], color[1], color[2] });
}

void AddStyleCode(SceneCode& code, const std::string& style, vtkTextProperty* property)
{
  static const std::array<const char*, 3> sides = { { "Left", "Centered", "Right" } };
  static const std::array<const char*, 3> heights = { { "Bottom", "Centered", "Top" } };
  const vtkNew<vtkTextProperty> standard;
  AddColor(code, style, "SetColor", property->GetColor());
  code.Call(style, "SetFontSize", { property->GetFontSize() });
  AddFlag(code, style, property, "Bold", &vtkTextProperty::GetBold);
  if (property->GetBackgroundOpacity() > 0.0)
  {
    AddColor(code, style, "SetBackgroundColor", property->GetBackgroundColor());
    code.Call(style, "SetBackgroundOpacity", { property->GetBackgroundOpacity() });
  }
  if (property->GetJustification() != standard->GetJustification())
  {
    code.Call(style,
      std::string("SetJustificationTo") +
        sides[static_cast<std::size_t>(property->GetJustification())]);
  }
  if (property->GetVerticalJustification() != standard->GetVerticalJustification())
  {
    code.Call(style,
      std::string("SetVerticalJustificationTo") +
        heights[static_cast<std::size_t>(property->GetVerticalJustification())]);
  }
}
}

//------------------------------------------------------------------------------
void AddTextCode(SceneCode& code, vtkTextActor* text)
{
  code.Note("A text over the picture.");
  const std::string variable = code.New("vtkTextActor", "text");
  code.Call(variable, "SetInput", { text->GetInput() });
  const std::string style = code.Get("vtkTextProperty", "style", variable, "GetTextProperty");
  AddStyleCode(code, style, text->GetTextProperty());
  if (text->GetPositionCoordinate()->GetCoordinateSystem() == VTK_NORMALIZED_VIEWPORT)
  {
    const std::string place = code.Get("vtkCoordinate", "place", variable, "GetPositionCoordinate");
    code.Call(place, "SetCoordinateSystemToNormalizedViewport");
  }
  const double* position = text->GetPosition();
  code.Call(variable, "SetPosition", { position[0], position[1] });
  code.Call("renderer", "AddViewProp", { CodeValue::Object(variable) });
}

//------------------------------------------------------------------------------
void AddLineCode(SceneCode& code, vtkActor2D* actor)
{
  auto* mapper = vtkPolyDataMapper2D::SafeDownCast(actor->GetMapper());
  vtkPolyData* shape = mapper ? mapper->GetInput() : nullptr;
  if (!shape || shape->GetNumberOfLines() != shape->GetNumberOfCells() ||
    mapper->GetTransformCoordinate())
  {
    throw ViewerError("a program cannot have every 2D shape of this scene");
  }
  code.Note("Lines over the picture.");
  vtkProperty2D* property = actor->GetProperty();
  const double* color = property->GetColor();
  std::set<std::array<double, 4>> written; // both crosses of a point are equal
  vtkNew<vtkIdList> points;
  for (vtkIdType line = 0; line < shape->GetNumberOfCells(); ++line)
  {
    shape->GetCellPoints(line, points);
    for (vtkIdType i = 1; i < points->GetNumberOfIds(); ++i)
    {
      double ends[2][3];
      shape->GetPoint(points->GetId(i - 1), ends[0]);
      shape->GetPoint(points->GetId(i), ends[1]);
      const std::array<double, 4> numbers = { { Shorten(ends[0][0]), Shorten(ends[0][1]),
        Shorten(ends[1][0]), Shorten(ends[1][1]) } };
      if (written.insert(numbers).second)
      {
        code.CallFunction("AddLine", AddLineFunction,
          { CodeValue::Object("renderer"), numbers[0], numbers[1], numbers[2], numbers[3],
            static_cast<double>(property->GetLineWidth()), color[0], color[1], color[2] });
      }
    }
  }
}
