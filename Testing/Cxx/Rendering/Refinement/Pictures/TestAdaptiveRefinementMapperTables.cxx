// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that point scalars get the colours of vtkPolyDataMapper with every kind of lookup table:
// for the input at level 0, and for the filter's output at level 2.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkBitArray.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkStringArray.h"

#include <limits>

namespace
{
using namespace RelevoMeshes;
using Table = vtkSmartPointer<vtkScalarsToColors>;

// A plane whose vectors cover the ranges of the tables below, and more.
Mesh WithValues(vtkDataArray* values, int components)
{
  Mesh mesh = Plane(6, 5);
  values->SetName("Values");
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values->SetComponent(i, c, 12.3 * ((i * (7 + 4 * c) + 3 * c) % 29) / 29.0 - 1.1 * c);
    }
  }
  mesh->GetPointData()->SetScalars(values);
  return mesh;
}

Table MakeLookupTable(bool log, bool ends)
{
  vtkNew<vtkLookupTable> table;
  table->SetTableRange(0.5, 10.0);
  table->SetAlphaRange(0.3, 1.0);
  table->SetScale(log ? VTK_SCALE_LOG10 : VTK_SCALE_LINEAR);
  table->SetUseBelowRangeColor(ends);
  table->SetUseAboveRangeColor(ends);
  table->SetBelowRangeColor(1.0, 0.0, 1.0, 0.8);
  table->SetAboveRangeColor(1.0, 1.0, 1.0, 0.6);
  table->SetAlpha(0.5); // vtkMapper ignores it
  table->Build();
  return table;
}

template <typename Function>
void AddColors(Function* function)
{
  function->AddRGBPoint(1.0, 0.1, 0.2, 0.9);
  function->AddRGBPoint(4.0, 0.9, 0.9, 0.2, 0.5, 1.0); // a step
  function->AddRGBPoint(9.0, 0.8, 0.1, 0.1);
}

Table MakeFunction(bool log)
{
  vtkNew<vtkColorTransferFunction> function;
  AddColors(function.Get());
  if (log)
  {
    function->SetScaleToLog10();
  }
  return function;
}

// The opacity function extends beyond the colour function.
Table MakeDiscretizable(bool discretized, bool withOpacity)
{
  vtkNew<vtkDiscretizableColorTransferFunction> function;
  AddColors(function.Get());
  function->SetDiscretize(discretized);
  function->SetNumberOfValues(7);
  if (withOpacity)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(-1.0, 0.9);
    opacity->AddPoint(5.0, 0.2);
    opacity->AddPoint(12.0, 1.0);
    function->SetScalarOpacityFunction(opacity);
    function->EnableOpacityMappingOn();
  }
  function->Build();
  return function;
}

struct Tester
{
  RelevoComparison& Comparison;

  // Compares level 0 and level 2. If a table has steps, a point on a step may get either colour,
  // which affects a triangle of a few pixels.
  void Compare(const std::string& name, size_t pixels, const std::function<Mesh()>& makeMesh,
    vtkScalarsToColors* table, const std::function<void(vtkMapper*)>& set) const
  {
    for (int level : { 0, 2 })
    {
      RelevoTolerance tolerance;
      tolerance.Color = level > 0 ? 3 : 0;
      tolerance.Depth = level > 0 ? 2e-6 : 0.0;
      tolerance.Pixels = level > 0 ? pixels : 0;
      this->Comparison.Compare("Tables." + name + "." + std::to_string(level), tolerance,
        [&](RelevoScene& scene)
        {
          scene.Window->SetSize(200, 200);
          vtkActor* actor = scene.Add(makeMesh(), level > 0 ? MakeRecipe(level).Get() : nullptr);
          actor->GetProperty()->LightingOff();
          actor->GetMapper()->SetLookupTable(table);
          actor->GetMapper()->UseLookupTableScalarRangeOn();
          set(actor->GetMapper());
        });
    }
  }
};

void TestNumbers(const Tester& tester)
{
  const struct
  {
    const char* Name;
    Table Colors;
  } tables[] = { { "Lookup", MakeLookupTable(false, false) },
    { "LookupEnds", MakeLookupTable(false, true) }, { "LookupLog", MakeLookupTable(true, true) },
    { "Function", MakeFunction(false) }, { "FunctionLog", MakeFunction(true) },
    { "Discretizable", MakeDiscretizable(false, false) },
    { "Discretized", MakeDiscretizable(true, false) },
    { "Opacity", MakeDiscretizable(false, true) },
    { "OpacityDiscretized", MakeDiscretizable(true, true) } };
  for (const auto& table : tables)
  {
    const bool isPlain =
      std::string(table.Name) == "Lookup" || std::string(table.Name) == "Opacity";
    for (int components : { 1, 3, 9 })
    {
      for (bool byTexture : { false, true })
      {
        for (int mode : { vtkScalarsToColors::MAGNITUDE, vtkScalarsToColors::COMPONENT })
        {
          // Vectors of 9 components are mapped by magnitude or by one component.
          const bool isLength = mode == vtkScalarsToColors::MAGNITUDE;
          if (components == 9 ? !isPlain : !isLength)
          {
            continue;
          }
          std::string name = table.Name + std::to_string(components) +
            (byTexture ? ".Texture" : "") +
            (mode == vtkScalarsToColors::COMPONENT ? ".Component" : "");
          tester.Compare(
            name, byTexture ? 300 : 60,
            [&]
            {
              vtkNew<vtkDoubleArray> values;
              return WithValues(values, components);
            },
            table.Colors,
            [&](vtkMapper* mapper)
            {
              mapper->GetLookupTable()->SetVectorMode(mode);
              mapper->GetLookupTable()->SetVectorComponent(components > 1 ? 1 : 0);
              mapper->SelectColorArray("Values");
              mapper->SetInterpolateScalarsBeforeMapping(byTexture);
            });
        }
      }
    }
  }
}

// Whole numbers lie exactly on the steps of a table and must not get the neighbour's colour.
void TestSteps(const Tester& tester)
{
  vtkNew<vtkColorTransferFunction> function;
  for (int i = 0; i < 6; ++i)
  {
    function->AddRGBPoint(2 * i - 1, i % 2, 0.2 * i, i == 2 ? 1.0 : 0.0, 0.5, 1.0);
  }
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(9);
  table->SetTableRange(1.0, 10.0);
  table->Build();
  vtkNew<vtkLookupTable> logarithms;
  logarithms->DeepCopy(table);
  logarithms->SetNumberOfTableValues(12);
  logarithms->SetTableRange(1.0, 8.0);
  logarithms->SetScaleToLog10();
  logarithms->Build();
  const std::pair<std::string, Table> tables[] = { { "Function", function.Get() },
    { "Lookup", table.Get() }, { "LookupLog", logarithms.Get() } };
  for (const auto& each : tables)
  {
    tester.Compare(
      "Steps" + each.first, 0,
      []
      {
        vtkNew<vtkIntArray> values;
        return WithValues(values, 1);
      },
      each.second, [](vtkMapper*) {});
  }
}

void TestOtherValues(const Tester& tester)
{
  const Table table = MakeLookupTable(false, true);
  const auto nothing = [](vtkMapper*) {};
  for (bool byTexture : { false, true })
  {
    const auto set = [&](vtkMapper* mapper)
    { mapper->SetInterpolateScalarsBeforeMapping(byTexture); };
    const std::string suffix = byTexture ? ".Texture" : "";
    tester.Compare(
      "Whole" + suffix, byTexture ? 300 : 60,
      []
      {
        vtkNew<vtkIntArray> values; // halves of these values are rounded away from zero
        return WithValues(values, 1);
      },
      table, set);
    tester.Compare(
      "NaN" + suffix, byTexture ? 300 : 60,
      []
      {
        vtkNew<vtkFloatArray> values;
        Mesh mesh = WithValues(values, 1);
        values->SetValue(17, std::numeric_limits<float>::quiet_NaN());
        return mesh;
      },
      table, set);
  }
  tester.Compare(
    "FarNarrow", 60,
    []
    {
      vtkNew<vtkDoubleArray> values;
      Mesh mesh = WithValues(values, 1);
      for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
      {
        values->SetValue(i, 1e6 + 1e-3 * values->GetValue(i));
      }
      return mesh;
    },
    nullptr,
    [](vtkMapper* mapper)
    {
      mapper->UseLookupTableScalarRangeOff();
      mapper->SetScalarRange(1e6, 1e6 + 0.01);
    });
  // The function's range applies, not that of the missing values.
  tester.Compare(
    "Outlier", 60,
    []
    {
      vtkNew<vtkDoubleArray> values;
      Mesh mesh = WithValues(values, 1);
      values->SetValue(3, -1e9);
      return mesh;
    },
    MakeFunction(false), nothing);
}

// Values that cannot be interpolated are taken from the nearest point.
void TestNames(const Tester& tester)
{
  vtkNew<vtkLookupTable> table;
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(3);
  const char* names[] = { "clay", "sand", "silt" };
  for (int i = 0; i < 3; ++i)
  {
    table->SetTableValue(i, i == 0, i == 1, i == 2);
    table->SetAnnotation(vtkVariant(names[i]), names[i]);
  }
  tester.Compare(
    "Names", 60,
    [&]
    {
      Mesh mesh = Plane(6, 5);
      vtkNew<vtkStringArray> values;
      values->SetName("Soil");
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        values->InsertNextValue(names[i * 7 % 3]);
      }
      mesh->GetPointData()->AddArray(values);
      return mesh;
    },
    table,
    [](vtkMapper* mapper)
    {
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectColorArray("Soil");
    });
  tester.Compare(
    "Bits", 60,
    []
    {
      Mesh mesh = Plane(6, 5);
      vtkNew<vtkBitArray> values;
      values->SetName("Wet");
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        values->InsertNextValue(static_cast<int>(i * 7 % 3 == 0));
      }
      mesh->GetPointData()->SetScalars(values);
      return mesh;
    },
    nullptr, [](vtkMapper* mapper) { mapper->UseLookupTableScalarRangeOff(); });
}
}

int TestAdaptiveRefinementMapperTables(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  const Tester tester{ comparison };
  TestNumbers(tester);
  TestSteps(tester);
  TestOtherValues(tester);
  TestNames(tester);
  return check.GetResult();
}
