// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/ColourCode.h"

#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"

#include <algorithm>
#include <vector>

namespace
{
const CodeFunction FillLogTable = {
  R"(def fill_log_table(table, function):
    """Fills a table of logarithmic scale with the colours of a function."""
    low, high = [math.log(value) for value in function.GetRange()]
    number = table.GetNumberOfTableValues()
    colour = [0.0, 0.0, 0.0]
    for i in range(number):
        function.GetColor(math.exp(low + (i + 0.5) / number * (high - low)), colour)
        table.SetTableValue(i, *colour, 1.0)
)",
  R"(// Fills a table of logarithmic scale with the colours of a function.
static void FillLogTable(vtkLookupTable* table, vtkColorTransferFunction* function)
{
  const double low = std::log(function->GetRange()[0]);
  const double high = std::log(function->GetRange()[1]);
  const int number = static_cast<int>(table->GetNumberOfTableValues());
  for (int i = 0; i < number; ++i)
  {
    double colour[3];
    function->GetColor(std::exp(low + (i + 0.5) / number * (high - low)), colour);
    table->SetTableValue(i, colour[0], colour[1], colour[2], 1.0);
  }
}
)",
  { "vtkColorTransferFunction", "vtkLookupTable" }
};

CodeValue AddTableCode(SceneCode& code, vtkLookupTable* table, const std::string& name)
{
  const vtkIdType most = 16; // more colours are not readable
  if (table->GetScale() != VTK_SCALE_LINEAR || table->GetIndexedLookup() ||
    table->GetNumberOfTableValues() > most)
  {
    throw ViewerError("a program cannot have every colour table of this scene");
  }
  const std::string variable = code.New("vtkLookupTable", name);
  code.Call(variable, "SetNumberOfTableValues",
    { static_cast<long long>(table->GetNumberOfTableValues()) });
  code.Call(variable, "SetTableRange", { table->GetTableRange()[0], table->GetTableRange()[1] });
  for (vtkIdType i = 0; i < table->GetNumberOfTableValues(); ++i)
  {
    double color[4];
    table->GetTableValue(i, color);
    code.Call(variable, "SetTableValue",
      { static_cast<long long>(i), color[0], color[1], color[2], color[3] });
  }
  code.Remember(table, CodeValue::Object(variable));
  return CodeValue::Object(variable);
}

template <typename Table>
void AddColoursOutOfRange(SceneCode& code, Table* table, const std::string& variable, bool isRGBA)
{
  const auto add = [&](const std::string& side, const double* color)
  {
    SceneCode::Values numbers = { color[0], color[1], color[2] };
    if (isRGBA)
    {
      numbers.emplace_back(color[3]);
    }
    code.Call(variable, "Set" + side + "RangeColor", numbers);
    code.Call(variable, "Use" + side + "RangeColorOn");
  };
  if (table->GetUseBelowRangeColor())
  {
    add("Below", table->GetBelowRangeColor());
  }
  if (table->GetUseAboveRangeColor())
  {
    add("Above", table->GetAboveRangeColor());
  }
}
}

//------------------------------------------------------------------------------
void AddFunctionCode(
  SceneCode& code, vtkColorTransferFunction* function, const std::string& variable)
{
  const vtkNew<vtkColorTransferFunction> standard;
  if (function->GetScale() == VTK_CTF_LOG10)
  {
    code.Call(variable, "SetScaleToLog10");
  }
  if (function->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
  {
    code.Call(variable, "SetVectorModeToMagnitude");
  }
  std::vector<std::vector<double>> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6]; // value, red, green, blue, midpoint, sharpness
    function->GetNodeValue(i, node);
    nodes.push_back({ node[0], node[1], node[2], node[3] });
  }
  code.Rows(variable, "AddRGBPoint", nodes);
  AddColoursOutOfRange(code, function, variable, false);
  const double* nan = function->GetNanColor();
  if (!std::equal(nan, nan + 3, standard->GetNanColor()))
  {
    code.Call(variable, "SetNanColor", { nan[0], nan[1], nan[2] });
  }
}

//------------------------------------------------------------------------------
CodeValue AddColourCode(SceneCode& code, vtkScalarsToColors* colours, const std::string& name)
{
  if (const auto known = code.Find(colours))
  {
    return *known;
  }
  if (auto* table = vtkLookupTable::SafeDownCast(colours))
  {
    return AddTableCode(code, table, name);
  }
  auto* function = vtkColorTransferFunction::SafeDownCast(colours);
  if (!function)
  {
    throw ViewerError(
      "a program cannot have a colour table of the class " + std::string(colours->GetClassName()));
  }
  const std::string variable = code.New("vtkColorTransferFunction", name);
  AddFunctionCode(code, function, variable);
  code.Remember(colours, CodeValue::Object(variable));
  return CodeValue::Object(variable);
}

//------------------------------------------------------------------------------
void AddLogColourCode(SceneCode& code, vtkColorTransferFunction* function, vtkLookupTable* table)
{
  const std::string palette = code.New("vtkColorTransferFunction", "palette");
  AddFunctionCode(code, function, palette);
  const std::string variable = code.New("vtkLookupTable", "colours");
  code.Call(variable, "SetVectorModeToMagnitude");
  code.Call(variable, "SetNumberOfTableValues",
    { static_cast<long long>(table->GetNumberOfTableValues()) });
  code.Call(variable, "SetTableRange", { table->GetTableRange()[0], table->GetTableRange()[1] });
  code.Call(variable, "SetScaleToLog10");
  code.CallFunction(
    "FillLogTable", FillLogTable, { CodeValue::Object(variable), CodeValue::Object(palette) });
  AddColoursOutOfRange(code, table, variable, true);
  code.Remember(table, CodeValue::Object(variable));
}
