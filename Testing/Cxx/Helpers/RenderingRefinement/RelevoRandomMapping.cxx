// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoRandomMapping.h"

#include "vtkCellData.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <limits>
#include <string>

namespace RelevoRandomMapping
{
vtkSmartPointer<vtkDataArray> MakeNumbers(RelevoDice& dice)
{
  switch (dice.Throw(6))
  {
    case 0:
      return vtkSmartPointer<vtkDoubleArray>::New();
    case 1:
      return vtkSmartPointer<vtkIntArray>::New();
    case 2:
      return vtkSmartPointer<vtkShortArray>::New();
    case 3:
      return vtkSmartPointer<vtkUnsignedCharArray>::New();
    default:
      return vtkSmartPointer<vtkFloatArray>::New();
  }
}

vtkSmartPointer<vtkDataArray> MakeScalars(
  const Choice& choice, vtkPolyData* mesh, vtkIdType count, bool ofPoints)
{
  RelevoDice& dice = choice.Dice;
  auto values = MakeNumbers(dice);
  const int components[] = { 1, 1, 1, 2, 3, 3, 4, 4 };
  values->SetNumberOfComponents(components[dice.Throw(8)]);
  values->SetNumberOfTuples(count);
  const bool isSmooth = ofPoints && dice.Throw(2);
  const bool hasNaN = values->GetDataType() != VTK_INT && dice.Once(8);
  const double low = values->GetDataType() == VTK_UNSIGNED_CHAR ? 0.0 : -2.0;
  const double factor = values->GetDataType() == VTK_UNSIGNED_CHAR && dice.Throw(2) ? 20.0 : 1.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
    {
      double value = factor * (low + (12.0 - low) * dice.Share());
      if (isSmooth)
      {
        double x[3];
        mesh->GetPoint(i, x);
        value = factor * (5.0 + 3.0 * x[0] - 2.0 * x[1] + c * x[2]);
        value = std::min(std::max(value, factor * low), factor * 12.0);
      }
      values->SetComponent(i, c, value);
    }
    if (hasNaN && values->GetDataType() >= VTK_FLOAT && dice.Once(9))
    {
      values->SetComponent(i, 0, std::numeric_limits<double>::quiet_NaN());
    }
  }
  choice.Log << " " << values->GetClassName() << "[" << values->GetNumberOfComponents() << "]"
             << (isSmooth ? " smooth" : "") << (hasNaN ? " NaN" : "");
  return values;
}

vtkSmartPointer<vtkScalarsToColors> MakeLookupTable(const Choice& choice)
{
  RelevoDice& dice = choice.Dice;
  const int sizes[] = { 3, 8, 256, 256, 1000 };
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(sizes[dice.Throw(5)]);
  if (dice.Throw(2))
  {
    table->SetHueRange(dice.Share(), dice.Share());
    table->SetSaturationRange(dice.Share(), 1.0);
  }
  if (dice.Once(4))
  {
    table->SetAlphaRange(dice.Share(), 1.0);
  }
  if (dice.Once(6))
  {
    table->SetScaleToLog10();
  }
  table->SetTableRange(dice.Throw(2) ? 0.5 : 1.0, 8.0 + dice.Throw(4));
  table->SetUseBelowRangeColor(dice.Once(3));
  table->SetUseAboveRangeColor(dice.Once(3));
  table->SetBelowRangeColor(1.0, 0.0, 1.0, 1.0);
  table->SetAboveRangeColor(0.0, 1.0, 1.0, 1.0);
  table->SetNanColor(0.9, 0.9, 0.2, 1.0);
  table->Build();
  choice.Limits.IsTranslucent = choice.Limits.IsTranslucent || !table->IsOpaque();
  choice.Log << " table of " << table->GetNumberOfTableValues() << (table->GetScale() ? " log" : "")
             << (table->IsOpaque() ? "" : " translucent");
  return table;
}

vtkSmartPointer<vtkScalarsToColors> MakeFunction(const Choice& choice)
{
  RelevoDice& dice = choice.Dice;
  vtkNew<vtkDiscretizableColorTransferFunction> function;
  const bool isDiscretizable = dice.Throw(2);
  vtkSmartPointer<vtkColorTransferFunction> result = function;
  if (!isDiscretizable)
  {
    result = vtkSmartPointer<vtkColorTransferFunction>::New();
  }
  const int nodes = 2 + dice.Throw(4);
  for (int i = 0; i < nodes; ++i)
  {
    result->AddRGBPoint(0.5 + 9.0 * i / (nodes - 1), dice.Share(), dice.Share(), dice.Share(), 0.5,
      dice.Once(4) ? 1.0 : 0.0);
  }
  result->SetNanColor(0.9, 0.2, 0.9);
  if (dice.Throw(2))
  {
    result->SetColorSpaceToDiverging();
  }
  choice.Log << (isDiscretizable ? " discretizable" : "") << " function of " << nodes;
  if (isDiscretizable)
  {
    function->SetDiscretize(dice.Throw(2));
    function->SetNumberOfValues(4 + 12 * dice.Throw(3));
    if (dice.Throw(2))
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 0.1 + 0.5 * dice.Share());
      opacity->AddPoint(6.0 * dice.Share(), 1.0);
      opacity->AddPoint(10.0, 0.5);
      function->SetScalarOpacityFunction(opacity);
      function->EnableOpacityMappingOn();
      choice.Limits.IsTranslucent = true;
      choice.Log << " with opacity";
    }
    function->Build();
    choice.Log << (function->GetDiscretize() ? " discretized" : "");
  }
  return result;
}

vtkSmartPointer<vtkScalarsToColors> MakeCategories(const Choice& choice)
{
  RelevoDice& dice = choice.Dice;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2 + dice.Throw(5));
  table->SetHueRange(dice.Share(), dice.Share());
  table->Build();
  table->IndexedLookupOn();
  const int count = 3 + dice.Throw(9);
  for (int i = 0; i < count; ++i)
  {
    table->SetAnnotation(vtkVariant(i - 1), "Name " + std::to_string(i));
  }
  table->SetNanColor(0.9, 0.9, 0.2, 1.0);
  choice.Log << " table of " << count << " categories";
  return table;
}

vtkSmartPointer<vtkScalarsToColors> MakeTable(const Choice& choice)
{
  RelevoDice& dice = choice.Dice;
  // Categories cannot be interpolated: the mapper blends colours, the filter numbers.
  const int kind = dice.Throw(choice.Level > 0 ? 6 : 7);
  auto table = kind < 4 ? MakeLookupTable(choice)
    : kind < 6          ? MakeFunction(choice)
                        : MakeCategories(choice);
  // Colours of vectors are not linear between points whose vectors are out of range.
  const int mode = dice.Throw(choice.Level > 0 ? 2 : 3);
  table->SetVectorMode(mode == 0 ? vtkScalarsToColors::MAGNITUDE
      : mode == 1                ? vtkScalarsToColors::COMPONENT
                                 : vtkScalarsToColors::RGBCOLORS);
  table->SetVectorComponent(dice.Throw(3));
  choice.Log << " vectors " << mode << ":" << table->GetVectorComponent();
  return table;
}

void AddScalars(const Choice& choice, vtkPolyData* mesh)
{
  RelevoDice& dice = choice.Dice;
  if (dice.Throw(3) == 0)
  {
    return;
  }
  choice.Log << "  point scalars";
  auto points = MakeScalars(choice, mesh, mesh->GetNumberOfPoints(), true);
  points->SetName("Points");
  choice.Log << ", cell scalars";
  auto cells = MakeScalars(choice, mesh, mesh->GetNumberOfCells(), false);
  cells->SetName("Cells");
  choice.Log << "\n";
  dice.Throw(3) ? mesh->GetPointData()->SetScalars(points) : mesh->GetPointData()->AddArray(points);
  dice.Throw(2) ? mesh->GetCellData()->SetScalars(cells) : mesh->GetCellData()->AddArray(cells);
  vtkNew<vtkDoubleArray> field;
  field->SetName("Field");
  field->SetNumberOfTuples(mesh->GetNumberOfCells());
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    field->SetValue(i, static_cast<double>(i % 10));
  }
  mesh->GetFieldData()->AddArray(field);
}

void AddColorSettings(const Choice& choice, std::vector<Setting>& settings)
{
  RelevoDice& dice = choice.Dice;
  choice.Log << "  mapper:";
  const bool isVisible = dice.Throw(6) != 0;
  settings.push_back([=](vtkPolyDataMapper* m) { m->SetScalarVisibility(isVisible); });
  auto table = MakeTable(choice);
  const bool hasTable = dice.Throw(5) != 0;
  const bool tableRange = dice.Throw(2);
  const double low = 3.0 * dice.Share();
  const bool interpolates = dice.Once(3);
  // For values that are not colours, VTK takes the remainder, which cannot be interpolated.
  const bool direct = dice.Once(6) && choice.Level == 0;
  settings.push_back(
    [=](vtkPolyDataMapper* m)
    {
      m->SetLookupTable(hasTable ? table.Get() : nullptr);
      m->SetUseLookupTableScalarRange(tableRange);
      m->SetScalarRange(low, 9.0);
      m->SetInterpolateScalarsBeforeMapping(interpolates);
      m->SetColorMode(direct ? VTK_COLOR_MODE_DIRECT_SCALARS : VTK_COLOR_MODE_DEFAULT);
    });
  // Field data belong to cells of the coarse mesh, and the filter has other cells.
  const int mode = dice.Throw(choice.Level > 0 ? 5 : 6);
  choice.Limits.HasTies = choice.Limits.HasTies ||
    (isVisible && mode != VTK_SCALAR_MODE_USE_POINT_DATA &&
      mode != VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  const int component = dice.Throw(4) - 1;
  const bool byName = dice.Throw(2) || choice.Level > 0; // the filter changes the order of arrays
  settings.push_back(
    [=](vtkPolyDataMapper* m)
    {
      m->SetScalarMode(mode);
      const char* name = mode == VTK_SCALAR_MODE_USE_FIELD_DATA ? "Field"
        : mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA           ? "Cells"
                                                                : "Points";
      byName ? m->ColorByArrayComponent(name, component) : m->ColorByArrayComponent(0, component);
    });
  choice.Log << (isVisible ? "" : " invisible") << (hasTable ? "" : " default table")
             << (tableRange ? " its range" : "") << (interpolates ? " before mapping" : "")
             << (direct ? " direct" : "") << " mode " << mode << " component " << component
             << (byName ? " by name\n" : " by id\n");
}
}
