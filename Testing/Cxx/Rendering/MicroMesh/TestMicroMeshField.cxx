// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshSurface promises arrays of points and cells from the grids at every pixel, for each
// method and each kind of colours, also where coarse faces are drawn. The reference is the picture
// of VTK's mapper of small triangles on the same faces, with the values of
// vtkAdaptiveRefinementFilter.
#include "RelevoCheck.h"
#include "RelevoMethods.h"
#include "RelevoMicroMeshes.h"
#include "RelevoScene.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMicroMeshSurface.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdlib>
#include <string>

using namespace RelevoMicroMeshes;

namespace
{
constexpr int FineLevel = 5;

// A sphere with arrays that have detail between the coarse points.
Mesh MakeScan()
{
  const Mesh mesh = ReliefSphere(64, 40);
  vtkNew<vtkFloatArray> wave;
  wave->SetName("Wave");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> color;
  color->SetName("Color");
  color->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    const double value = std::sin(9.0 * x[0]) * std::cos(7.0 * x[1]) + 0.3 * x[2];
    wave->InsertNextValue(static_cast<float>(value));
    vectors->InsertNextTuple3(value, x[1], 0.5 * std::sin(8.0 * x[2]));
    color->InsertNextTuple3(127.0 + 90.0 * value, 127.0 - 90.0 * value, 127.0 + 100.0 * x[1]);
  }
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(wave),
         static_cast<vtkDataArray*>(vectors), static_cast<vtkDataArray*>(color) })
  {
    mesh->GetPointData()->AddArray(array);
  }
  // Bands that are narrower than coarse faces.
  vtkNew<vtkFloatArray> bands;
  bands->SetName("Bands");
  vtkNew<vtkUnsignedCharArray> cellColor;
  cellColor->SetName("CellColor");
  cellColor->SetNumberOfComponents(3);
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    double bounds[6];
    mesh->GetCellBounds(t, bounds);
    const bool isOdd = std::lround(4.0 * (bounds[2] + bounds[3])) % 2 != 0;
    bands->InsertNextValue(isOdd ? -1.0f : 1.0f);
    cellColor->InsertNextTuple3(isOdd ? 250.0 : 20.0, 128.0, isOdd ? 20.0 : 250.0);
  }
  mesh->GetCellData()->AddArray(bands);
  mesh->GetCellData()->AddArray(cellColor);
  return mesh;
}

// The coarse faces in small triangles, with the values of the grids.
Mesh MakeReference(vtkPolyData* micro)
{
  const Mesh flat = RelevoMeshes::Refine(micro, RelevoMeshes::MakeRecipe(FineLevel, nullptr));
  const Mesh fine = Decode(micro, FineLevel);
  for (const char* name : { "Wave", "Vectors", "Color" })
  {
    flat->GetPointData()->AddArray(fine->GetPointData()->GetArray(name));
  }
  for (const char* name : { "Bands", "CellColor" })
  {
    flat->GetCellData()->AddArray(fine->GetCellData()->GetArray(name));
  }
  return flat;
}

struct Coloring
{
  std::string Name;
  std::string Array;
  bool IsDirect;
  bool BeforeMapping;
  int Component; // -1 for the length
  bool IsOfCells = false;
};

void SetColors(vtkPolyDataMapper* mapper, vtkActor* actor, const Coloring& coloring)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  table->SetHueRange(0.7, 0.0);
  if (coloring.Component < 0)
  {
    table->SetVectorModeToMagnitude();
  }
  table->Build();
  mapper->SetLookupTable(table);
  mapper->SetScalarRange(-1.3, 1.3);
  coloring.IsOfCells ? mapper->SetScalarModeToUseCellFieldData()
                     : mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(coloring.Array.c_str());
  mapper->SetInterpolateScalarsBeforeMapping(coloring.BeforeMapping);
  if (coloring.IsDirect)
  {
    mapper->SetColorModeToDirectScalars();
  }
  actor->GetProperty()->LightingOff();
}

// The pixels whose colours differ by more than 12 of 255.
std::size_t CountDifferences(const RelevoPicture& a, const RelevoPicture& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.GetNumberOfPixels(); ++i)
  {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::abs(a.Colors[3 * i + c] - b.Colors[3 * i + c]));
    }
    count += largest > 12 ? 1 : 0;
  }
  return count;
}

RelevoPicture Draw(vtkPolyData* mesh, const Coloring& coloring, const RelevoScene& refined)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  RelevoScene scene(RelevoScene::Twin);
  scene.Renderer->AddActor(actor);
  SetColors(mapper, actor, coloring);
  scene.CopyCameras(refined);
  scene.Render();
  return RelevoPicture(scene.Window);
}

void CheckColors(RelevoCheck& check, vtkPolyData* micro, vtkPolyData* reference,
  const Coloring& coloring, int method)
{
  CHECK_CASE(coloring.Name);
  CHECK_CASE(RelevoMethods::GetName(method));
  vtkNew<vtkMicroMeshSurface> surface;
  RelevoScene scene(RelevoScene::Refining);
  // The uniform method has its lowest level, too, where the surface is not flat.
  vtkActor* actor = scene.Add(micro, RelevoMeshes::MakeRecipe(0, surface));
  scene.GetMapper(0)->SetMethod(method);
  SetColors(scene.GetMapper(0), actor, coloring);
  scene.ResetCameras();
  scene.Render();
  const RelevoPicture drawn(scene.Window);
  const RelevoPicture expected = Draw(reference, coloring, scene);
  const RelevoPicture interpolated = Draw(micro, coloring, scene);
  const std::size_t covered = drawn.CountForeground();
  CHECK_GREATER(covered, 10000);
  CHECK_LESS(CountDifferences(drawn, expected), covered / 50);
  CHECK_GREATER(CountDifferences(interpolated, expected), covered / 5); // without the grids
}
}

int TestMicroMeshField(int, char*[])
{
  RelevoCheck check;
  const Mesh micro = Encode(MakeScan(), 0.004, 4, 0.98);
  CHECK_LESS(micro->GetNumberOfPolys(), 500);
  const Mesh reference = MakeReference(micro);
  const Coloring table{ "table", "Wave", false, false, 0 };
  const Coloring texture{ "texture", "Wave", false, true, 0 };
  const Coloring length{ "length", "Vectors", false, true, -1 };
  const Coloring direct{ "colours", "Color", true, false, 0 };
  const Coloring cells{ "cells", "Bands", false, false, 0, true };
  const Coloring cellColors{ "colours of cells", "CellColor", true, false, 0, true };
  for (int method : RelevoMethods::GetMethods())
  {
    CheckColors(check, micro, reference, texture, method);
  }
  if (RelevoMethods::HasTessellation())
  {
    for (const Coloring& coloring : { direct, cells })
    {
      CheckColors(check, micro, reference, coloring,
        vtkAdaptiveRefinementMapper::METHOD_HARDWARE_TESSELLATION);
    }
  }
  for (const Coloring& coloring : { table, length, direct, cells, cellColors })
  {
    CheckColors(check, micro, reference, coloring, vtkAdaptiveRefinementMapper::METHOD_ARKFPI);
  }
  return check.GetResult();
}
