// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinementFilter promises how it interpolates or copies point data, and that cell and
// field data are kept.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

using namespace RelevoMeshes;

namespace
{
// Component c of a field that is linear in space.
double field(const double* p, int c)
{
  return 20.0 + 2.0 * p[0] - 3.0 * p[1] + (c + 1) * 5.0 * p[2];
}

template <typename ArrayT>
void addField(vtkPolyData* mesh, const char* name, int components)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, field(mesh->GetPoint(i), c));
    }
  }
  mesh->GetPointData()->AddArray(array);
}

// Arrays whose components are fields linear in space.
const std::vector<const char*> LinearFields = { "double", "float", "int", "long", "colours",
  "vectors", "five", "apart", "apart integers" };

void addLinearFields(vtkPolyData* mesh)
{
  addField<vtkDoubleArray>(mesh, "double", 1);
  addField<vtkFloatArray>(mesh, "float", 1);
  addField<vtkIntArray>(mesh, "int", 1);
  addField<vtkTypeInt64Array>(mesh, "long", 1);
  addField<vtkUnsignedCharArray>(mesh, "colours", 3);
  addField<vtkDoubleArray>(mesh, "vectors", 3);
  addField<vtkFloatArray>(mesh, "five", 5);
  addField<vtkSOADataArrayTemplate<double>>(mesh, "apart", 2);
  addField<vtkSOADataArrayTemplate<int>>(mesh, "apart integers", 2);
}

// Arrays that are not interpolated: strings, bits, ids, ghosts and large integers, one without a
// name, and one that is too short.
void addOtherPointArrays(vtkPolyData* mesh)
{
  vtkNew<vtkStringArray> strings;
  strings->SetName("strings");
  vtkNew<vtkBitArray> bits;
  bits->SetName("bits");
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("global");
  vtkNew<vtkIdTypeArray> pedigreeIds;
  pedigreeIds->SetName("pedigree");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  vtkNew<vtkTypeInt64Array> large;
  large->SetName("large");
  vtkNew<vtkFloatArray> unnamed;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    strings->InsertNextValue("point " + std::to_string(i));
    bits->InsertNextValue(i % 2);
    globalIds->InsertNextValue(1000 + i);
    pedigreeIds->InsertNextValue(2000 + i);
    ghosts->InsertNextValue(static_cast<unsigned char>(4 * (i % 2)));
    large->InsertNextValue(std::numeric_limits<std::int64_t>::max() - (i % 2));
    unnamed->InsertNextValue(7.0f);
  }
  vtkNew<vtkDoubleArray> tooShort;
  tooShort->SetName("short");
  tooShort->InsertNextValue(1.0);
  vtkPointData* data = mesh->GetPointData();
  for (vtkAbstractArray* array :
    std::initializer_list<vtkAbstractArray*>{ strings, bits, ghosts, large, unnamed })
  {
    data->AddArray(array);
  }
  data->SetGlobalIds(globalIds);
  data->SetPedigreeIds(pedigreeIds);
  data->AddArray(tooShort);
}

// The filter's output, after its warning about the array that is too short.
Mesh refineWithShortArray(RelevoCheck& check, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(mesh);
  filter->SetRefinement(recipe);
  filter->Update();
  CHECK(errors.Warned("short"));
  return filter->GetOutput();
}

// Linear fields stay linear, up to the rounding of integers.
void checkLinearFields(RelevoCheck& check, vtkPolyData* mesh, vtkPolyData* refined)
{
  const vtkIdType n = refined->GetNumberOfPoints();
  CHECK_GREATER(n, 200);
  for (const char* name : LinearFields)
  {
    vtkDataArray* from = mesh->GetPointData()->GetArray(name);
    vtkDataArray* to = refined->GetPointData()->GetArray(name);
    if (!CHECK(to && to->GetNumberOfTuples() == n))
    {
      continue;
    }
    CHECK_EQUAL(to->GetDataType(), from->GetDataType());
    CHECK_EQUAL(to->GetNumberOfComponents(), from->GetNumberOfComponents());
    const bool isInteger = from->GetDataType() != VTK_FLOAT && from->GetDataType() != VTK_DOUBLE;
    for (vtkIdType i = 0; i < n; ++i)
    {
      for (int c = 0; c < to->GetNumberOfComponents(); ++c)
      {
        const double expected = field(refined->GetPoint(i), c);
        CHECK_NEAR(to->GetComponent(i, c), expected, isInteger ? 0.50001 : 1e-5);
      }
    }
  }
}

std::string getWords(vtkPolyData* mesh, vtkIdType point)
{
  auto* strings = static_cast<vtkStringArray*>(mesh->GetPointData()->GetAbstractArray("strings"));
  return strings->GetValue(point);
}

vtkTypeInt64 getLarge(vtkPolyData* mesh, vtkIdType point)
{
  return static_cast<vtkTypeInt64Array*>(mesh->GetPointData()->GetArray("large"))->GetValue(point);
}

// The input's points come first with unchanged values. Other points take the value of one of them.
void checkOtherPointArrays(RelevoCheck& check, vtkPolyData* mesh, vtkPolyData* refined)
{
  vtkPointData* result = refined->GetPointData();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    CHECK_EQUAL(vtkMath::Distance2BetweenPoints(refined->GetPoint(i), mesh->GetPoint(i)), 0.0);
    CHECK_EQUAL(getWords(refined, i), "point " + std::to_string(i));
    CHECK_EQUAL(getLarge(refined, i), getLarge(mesh, i));
    CHECK_EQUAL(result->GetArray("bits")->GetTuple1(i), i % 2);
  }
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    CHECK_EQUAL(getWords(refined, i).find("point "), 0);
    const double ghost = result->GetArray("vtkGhostType")->GetTuple1(i);
    CHECK(ghost == 0.0 || ghost == 4.0);
    CHECK_GREATER(getLarge(refined, i), 0);
  }
}

// Attributes, names and lookup tables are kept. Ids and arrays that are too short are removed.
void checkPointAttributes(RelevoCheck& check, vtkPolyData* refined, vtkLookupTable* lut)
{
  vtkPointData* result = refined->GetPointData();
  CHECK(result->GetScalars() && result->GetScalars()->GetName() == std::string("colours"));
  CHECK(result->GetVectors() && result->GetVectors()->GetName() == std::string("vectors"));
  CHECK(result->GetTCoords() && result->GetTCoords()->GetName() == std::string("TCoords"));
  CHECK_EQUAL(result->GetArray("double")->GetLookupTable(), lut);
  CHECK_EQUAL(result->GetArray("vectors")->GetComponentName(1), std::string("second"));
  CHECK_EQUAL(result->GetNormals(), result->GetArray("Normals"));
  CHECK(!result->GetArray("given normals"));
  CHECK(!result->GetGlobalIds() && !result->GetArray("global"));
  CHECK(!result->GetPedigreeIds() && !result->GetArray("pedigree"));
  CHECK(!result->GetArray("short"));
  CHECK_EQUAL(result->GetArray("DepthTag")->GetNumberOfTuples(), refined->GetNumberOfPoints());
}

void testPointData(RelevoCheck& check)
{
  // On a cube from 0 to 4, the field has whole values at the corners.
  const double middle[3] = { 2, 2, 2 };
  Mesh mesh = Moved(Cube(), 4.0, middle, VTK_DOUBLE);
  AddTags(mesh, 3, 5);
  addLinearFields(mesh);
  vtkPointData* data = mesh->GetPointData();
  data->SetActiveScalars("colours");
  data->SetActiveVectors("vectors");
  vtkNew<vtkLookupTable> lut;
  data->GetArray("double")->SetLookupTable(lut);
  data->GetArray("vectors")->SetComponentName(1, "second");
  data->GetNormals()->SetName("given normals");
  addOtherPointArrays(mesh);

  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(4);
  Mesh refined = refineWithShortArray(check, mesh, recipe);
  checkLinearFields(check, mesh, refined);
  checkOtherPointArrays(check, mesh, refined);
  checkPointAttributes(check, refined, lut);
}

// Normals are unit vectors, even if the input's have other lengths or are unusable.
void testNormals(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> pn;
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(0.01);
  for (int given = 0; given < 3; ++given)
  {
    Mesh sphere = Sphere(12, 9);
    vtkDataArray* normals = sphere->GetPointData()->GetNormals();
    if (given == 0)
    {
      sphere->GetPointData()->SetNormals(nullptr);
    }
    for (vtkIdType i = 0; given > 0 && i < sphere->GetNumberOfPoints(); ++i)
    {
      double* n = normals->GetTuple(i);
      vtkMath::MultiplyScalar(n, 0.5 + i);
      normals->SetTuple(i, n);
    }
    if (given == 2)
    {
      normals->SetTuple3(4, 0.0, 0.0, 0.0);
      normals->SetComponent(7, 1, std::numeric_limits<double>::quiet_NaN());
      normals->SetComponent(9, 2, std::numeric_limits<double>::infinity());
    }
    for (int kind = 0; kind < 3; ++kind)
    {
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(2);
      recipe->SetSurface(kind == 1 ? pn.Get() : nullptr);
      recipe->SetDisplacement(kind == 2 ? displacement.Get() : nullptr);
      Mesh refined = Refine(sphere, recipe);
      vtkDataArray* result = refined->GetPointData()->GetNormals();
      if (given == 0 && kind == 0)
      {
        CHECK(!result);
        continue;
      }
      if (!CHECK(result && result->GetName() == std::string("Normals") &&
            vtkFloatArray::SafeDownCast(result)))
      {
        continue;
      }
      for (vtkIdType i = 0; i < result->GetNumberOfTuples(); ++i)
      {
        double n[3];
        result->GetTuple(i, n);
        CHECK_NEAR(vtkMath::Norm(n), 1.0, 1e-5);
        double p[3];
        refined->GetPoint(i, p);
        vtkMath::Normalize(p);
        CHECK_GREATER(vtkMath::Dot(n, p), 0.95);
      }
    }
  }
  // On a two-sided sheet normals cancel, but a unit normal is still computed.
  Mesh sheet = FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } }, { { 0, 2, 1 } } });
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(5);
  recipe->SetSurface(pn);
  Mesh refined = Refine(sheet, recipe);
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    CHECK_NEAR(std::abs(refined->GetPointData()->GetNormals()->GetComponent(i, 2)), 1.0, 1e-6);
  }
}

// A NaN value affects only the faces around its point.
void testNaN(RelevoCheck& check)
{
  Mesh plane = Plane(4, 4);
  addField<vtkFloatArray>(plane, "field", 1);
  plane->GetPointData()->GetArray("field")->SetTuple1(
    12, std::numeric_limits<double>::quiet_NaN()); // the point (0, 0)
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  Mesh refined = Refine(plane, recipe);
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    const double* p = refined->GetPoint(i);
    const double value = refined->GetPointData()->GetArray("field")->GetTuple1(i);
    if (std::abs(p[0]) >= 0.25 || std::abs(p[1]) >= 0.25)
    {
      CHECK_NEAR(value, field(p, 0), 1e-5);
    }
  }
}

// Adds an array of every kind with a value per cell, and field data.
void addCellData(vtkPolyData* mesh)
{
  vtkNew<vtkIntArray> integers;
  integers->SetName("integers");
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("colours");
  colours->SetNumberOfComponents(3);
  vtkNew<vtkStringArray> strings;
  strings->SetName("strings");
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("cell normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("global");
  vtkNew<vtkIdTypeArray> originals;
  originals->SetName("vtkOriginalCellIds");
  vtkNew<vtkBitArray> bits;
  bits->SetName("bits");
  vtkNew<vtkDoubleArray> tooShort;
  tooShort->SetName("short");
  tooShort->InsertNextValue(1.0);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    integers->InsertNextValue(static_cast<int>(100 + i));
    colours->InsertNextTuple3(i, 2 * i, 3 * i);
    strings->InsertNextValue("cell " + std::to_string(i));
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
    globalIds->InsertNextValue(5000 + i);
    originals->InsertNextValue(77);
    bits->InsertNextValue(i % 2);
  }
  vtkCellData* data = mesh->GetCellData();
  for (vtkAbstractArray* array :
    std::initializer_list<vtkAbstractArray*>{ integers, strings, originals, bits, tooShort })
  {
    data->AddArray(array);
  }
  data->SetScalars(colours);
  data->SetNormals(normals);
  data->SetGlobalIds(globalIds);
  vtkNew<vtkStringArray> note;
  note->SetName("note");
  note->InsertNextValue("kept");
  mesh->GetFieldData()->AddArray(note);
}

// Every output cell has the values of its coarse cell, and every coarse cell has pieces.
void checkPieces(RelevoCheck& check, vtkPolyData* refined, vtkIdTypeArray* ids, vtkIdType n)
{
  vtkCellData* result = refined->GetCellData();
  std::vector<int> pieces(static_cast<size_t>(n), 0);
  for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
  {
    const vtkIdType id = ids->GetValue(cell);
    CHECK_GREATER_EQUAL(id, 0);
    CHECK_LESS(id, n);
    ++pieces[id];
    CHECK_EQUAL(result->GetArray("integers")->GetTuple1(cell), 100 + id);
    CHECK_EQUAL(result->GetScalars()->GetComponent(cell, 2), 3 * id);
    CHECK_EQUAL(static_cast<vtkStringArray*>(result->GetAbstractArray("strings"))->GetValue(cell),
      "cell " + std::to_string(id));
    CHECK_EQUAL(result->GetArray("global")->GetTuple1(cell), 5000 + id);
    CHECK_EQUAL(result->GetArray("bits")->GetTuple1(cell), id % 2);
  }
  for (int count : pieces)
  {
    CHECK_GREATER(count, 0);
  }
}

void testCellData(RelevoCheck& check)
{
  Mesh mesh = Mixed();
  AddTags(mesh, 4, 4);
  addCellData(mesh);

  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(3);
  Mesh refined = refineWithShortArray(check, mesh, recipe);
  vtkCellData* result = refined->GetCellData();
  CHECK_EQUAL(refined->GetNumberOfVerts(), 2);
  CHECK_EQUAL(refined->GetNumberOfLines(), 1);
  CHECK_EQUAL(refined->GetNumberOfStrips(), 0);
  vtkIdTypeArray* ids = vtkIdTypeArray::SafeDownCast(result->GetArray("vtkOriginalCellIds"));
  if (!CHECK(ids && ids->GetNumberOfTuples() == refined->GetNumberOfCells()))
  {
    return;
  }
  checkPieces(check, refined, ids, mesh->GetNumberOfCells());
  CHECK_EQUAL(result->GetScalars()->GetName(), std::string("colours"));
  CHECK(!result->GetGlobalIds());
  CHECK_NOT_EQUAL(result->GetNormals(), nullptr);
  CHECK(!result->GetArray("short"));
  CHECK_EQUAL(
    vtkStringArray::SafeDownCast(refined->GetFieldData()->GetAbstractArray("note"))->GetValue(0),
    "kept");
  // Vertices and lines keep their points.
  vtkNew<vtkIdList> line;
  refined->GetCellPoints(2, line);
  CHECK_EQUAL(line->GetNumberOfIds(), 3);
  CHECK_EQUAL(line->GetId(2), 2);

  // Normals of flat cells are wrong for their refined pieces, so they are removed.
  mesh->GetCellData()->RemoveArray("short");
  vtkNew<vtkPNTriangleSurface> pn;
  recipe->SetSurface(pn);
  CHECK(!Refine(mesh, recipe)->GetCellData()->GetNormals());
}
}

int TestAdaptiveRefinementFilterData(int, char*[])
{
  RelevoCheck check;
  testPointData(check);
  testNormals(check);
  testNaN(check);
  testCellData(check);
  return check.GetResult();
}
