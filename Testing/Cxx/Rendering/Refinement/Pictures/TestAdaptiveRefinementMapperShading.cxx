// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that at level 0 the mapper draws what vtkPolyDataMapper draws: lights, normals, colours
// and textures.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"
#include "RelevoTextures.h"
#include "RelevoUnevenNormals.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkPolyDataTangents.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

namespace
{
using namespace RelevoMeshes;
using Compare = std::function<void(const std::string&, const RelevoComparison::Builder&)>;

Mesh WithPointScalars()
{
  Mesh mesh = Sphere(9, 7);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue((i * 37) % 11);
  }
  mesh->GetPointData()->SetScalars(values);
  return mesh;
}

Mesh WithCellScalars(Mesh mesh)
{
  vtkNew<vtkIntArray> values;
  values->SetName("Cells");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    values->InsertNextValue((i * 37) % 11);
  }
  mesh->GetCellData()->SetScalars(values);
  return mesh;
}

void AddFieldScalars(vtkPolyData* mesh, vtkIdType count)
{
  vtkNew<vtkFloatArray> field;
  field->SetName("Field");
  for (vtkIdType i = 0; i < count; ++i)
  {
    field->InsertNextValue(static_cast<float>((i * 37) % 11));
  }
  mesh->GetFieldData()->AddArray(field);
}

// Point or cell colours.
Mesh WithColors(Mesh mesh, int components, bool ofCells)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(components);
  const vtkIdType count = ofCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      colors->InsertNextValue(
        static_cast<unsigned char>(c == 3 ? 255 - i % 128 : (i * (c + 3) * 29) % 256));
    }
  }
  vtkDataSetAttributes* data = mesh->GetPointData();
  if (ofCells)
  {
    data = mesh->GetCellData();
  }
  data->SetScalars(colors);
  return mesh;
}

vtkSmartPointer<vtkTexture> Checks(bool interpolate, bool translucent = false)
{
  auto texture = RelevoTextures::Make(16, 8, translucent ? 4 : 3,
    [](int x, int y) {
      return RelevoTextures::Texel{ { 16 * x, (x + y) % 2 ? 255 : 60, 32 * y, x % 4 ? 255 : 100 } };
    });
  texture->SetInterpolate(interpolate);
  return texture;
}

void AddLight(RelevoScene& scene, double x, double y, double z, double r, double g, double b)
{
  vtkNew<vtkLight> light;
  light->SetPosition(x, y, z);
  light->SetColor(r, g, b);
  scene.Renderer->AddLight(light);
}

// Interpolation may have another order than vtkPolyDataMapper's, so the last bit of a colour may
// differ. Depths have 24 bits.
const RelevoTolerance Tight{ 1, 2e-7, 0 };

void TestNormals(const Compare& compare)
{
  compare("Normals", [](RelevoScene& s) { s.Add(Sphere(12, 10)); });
  compare("NoNormals", [](RelevoScene& s) { s.Add(Cone())->GetProperty()->SetColor(1, 0.8, 0.2); });
  compare(
    "Flat", [](RelevoScene& s) { s.Add(Sphere(12, 10))->GetProperty()->SetInterpolationToFlat(); });
  compare("Phong",
    [](RelevoScene& s) { s.Add(Sphere(12, 10))->GetProperty()->SetInterpolationToPhong(); });
  compare("NoNormalsSmooth",
    [](RelevoScene& s)
    {
      Mesh mesh = Sphere(12, 10);
      mesh->GetPointData()->SetNormals(nullptr);
      s.Add(mesh);
    });
  compare("CellNormals",
    [](RelevoScene& s)
    {
      Mesh mesh = Sphere(12, 10);
      mesh->GetPointData()->SetNormals(nullptr);
      vtkNew<vtkPolyDataNormals> normals;
      normals->SetInputData(mesh);
      normals->ComputePointNormalsOff();
      normals->ComputeCellNormalsOn();
      normals->Update();
      s.Add(normals->GetOutput());
    });
  compare("CellNormalsOfMixedCells",
    [](RelevoScene& s)
    {
      Mesh mesh = Mixed();
      vtkNew<vtkFloatArray> normals;
      normals->SetNumberOfComponents(3);
      for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
      {
        double n[3] = { 0.3 * (i % 3) - 0.3, 0.4 * (i % 2), 1.0 };
        vtkMath::Normalize(n);
        normals->InsertNextTuple(n);
      }
      mesh->GetCellData()->SetNormals(normals);
      s.Add(mesh);
    });
}

// Normals are unchanged if nothing is refined, even after something was.
void TestUnevenNormals(RelevoComparison& comparison)
{
  comparison.Compare("Shading.UnevenNormals", Tight,
    [](RelevoScene& s)
    {
      vtkProperty* property = s.Add(WithUnevenNormals(Mixed(), true))->GetProperty();
      property->SetPointSize(8);
      property->SetLineWidth(4);
    },
    { { "AfterRefinement",
      [](RelevoScene& s)
      {
        if (s.Kind == RelevoScene::Refining)
        {
          vtkAdaptiveRefinement* recipe = s.GetMapper(0)->GetRefinement();
          recipe->SetMaximumLevel(2);
          s.Render();
          recipe->SetMaximumLevel(0);
        }
      } } });
}

void TestLights(const Compare& compare)
{
  compare("Specular",
    [](RelevoScene& s)
    {
      vtkProperty* property = s.Add(Sphere(12, 10))->GetProperty();
      property->SetColor(0.8, 0.3, 0.2);
      property->SetSpecular(0.8);
      property->SetSpecularPower(20.0);
      property->SetAmbient(0.2);
      property->SetAmbientColor(0.0, 0.0, 1.0);
    });
  compare(
    "NoLighting", [](RelevoScene& s) { s.Add(Sphere(12, 10))->GetProperty()->LightingOff(); });
  compare("SeveralLights",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10))->GetProperty()->SetSpecular(0.5);
      AddLight(s, 5, 0, 0, 1, 0.2, 0.2);
      AddLight(s, 0, 5, 1, 0.2, 1, 0.2);
      AddLight(s, -2, -1, 5, 0.2, 0.2, 1);
    });
  compare("PositionalLights",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10))->GetProperty()->SetSpecular(0.5);
      for (int i = 0; i < 2; ++i)
      {
        vtkNew<vtkLight> light;
        light->PositionalOn();
        light->SetPosition(2.0 - 3.0 * i, 1, 1);
        light->SetFocalPoint(0, 0, 0);
        light->SetConeAngle(i ? 20.0 : 90.0);
        light->SetAttenuationValues(0.5, 0.2, 0.0);
        s.Renderer->AddLight(light);
      }
    });
}

void TestPhysicallyBased(const Compare& compare)
{
  compare("PhysicallyBased",
    [](RelevoScene& s)
    {
      vtkProperty* property = s.Add(Sphere(12, 10))->GetProperty();
      property->SetInterpolationToPBR();
      property->SetMetallic(0.4);
      property->SetRoughness(0.3);
      property->SetColor(0.9, 0.6, 0.2);
    });
  compare("NormalTexture",
    [](RelevoScene& s)
    {
      vtkNew<vtkTriangleFilter> triangles;
      triangles->SetInputData(Plane(3, 2));
      vtkNew<vtkPolyDataTangents> tangents;
      tangents->SetInputConnection(triangles->GetOutputPort());
      tangents->Update();
      vtkProperty* property = s.Add(tangents->GetOutput())->GetProperty();
      property->SetInterpolationToPBR();
      property->SetNormalTexture(Checks(true));
    });
}

void TestPointScalars(const Compare& compare)
{
  for (bool interpolated : { false, true })
  {
    compare(interpolated ? "InterpolatedScalars" : "Scalars",
      [interpolated](RelevoScene& s)
      {
        vtkMapper* mapper = s.Add(WithPointScalars())->GetMapper();
        mapper->SetScalarRange(1, 9);
        mapper->SetInterpolateScalarsBeforeMapping(interpolated);
      });
    compare(interpolated ? "InterpolatedScalarsUnlit" : "ScalarsUnlit",
      [interpolated](RelevoScene& s)
      {
        vtkActor* actor = s.Add(WithPointScalars());
        actor->GetProperty()->LightingOff();
        vtkNew<vtkLookupTable> table;
        table->SetNumberOfTableValues(5);
        table->SetTableRange(0, 10);
        table->Build();
        actor->GetMapper()->SetLookupTable(table);
        actor->GetMapper()->UseLookupTableScalarRangeOn();
        actor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolated);
      });
    compare(interpolated ? "InterpolatedScalarsWithTexture" : "ScalarsWithTexture",
      [interpolated](RelevoScene& s)
      {
        Mesh mesh = WithPointScalars();
        AddTextureCoordinates(mesh,
          [](const double* p) {
            return std::array<double, 2>{ { p[0] + 0.5, p[1] + 0.5 } };
          });
        vtkActor* actor = s.Add(mesh);
        actor->GetMapper()->SetScalarRange(1, 9);
        actor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolated);
        actor->SetTexture(Checks(true));
      });
  }
  compare("NaNScalars",
    [](RelevoScene& s)
    {
      Mesh mesh = WithPointScalars();
      mesh->GetPointData()->GetScalars()->SetComponent(20, 0, vtkMath::Nan());
      vtkMapper* mapper = s.Add(mesh)->GetMapper();
      mapper->SetScalarRange(0, 10);
    });
  compare("ScalarsOff",
    [](RelevoScene& s) { s.Add(WithPointScalars())->GetMapper()->ScalarVisibilityOff(); });
}

void TestSelectedArray(const Compare& compare)
{
  compare("SelectedArray",
    [](RelevoScene& s)
    {
      Mesh mesh = WithPointScalars();
      vtkNew<vtkFloatArray> vectors;
      vectors->SetName("Vectors");
      vectors->SetNumberOfComponents(3);
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        vectors->InsertNextTuple3(i % 5, i % 7, i % 3);
      }
      mesh->GetPointData()->AddArray(vectors);
      vtkMapper* mapper = s.Add(mesh)->GetMapper();
      mapper->SetScalarModeToUsePointFieldData();
      mapper->ColorByArrayComponent("Vectors", 1);
      mapper->SetScalarRange(0, 6);
    });
}

void TestIndexedLookup(const Compare& compare)
{
  compare("IndexedLookup",
    [](RelevoScene& s)
    {
      vtkNew<vtkLookupTable> table;
      table->IndexedLookupOn();
      table->SetNumberOfTableValues(11);
      for (int i = 0; i < 11; ++i)
      {
        table->SetAnnotation(vtkVariant(i), std::to_string(i));
        table->SetTableValue(i, 0.1 * (i % 3), 0.09 * i, 1.0 - 0.09 * i);
      }
      vtkActor* actor = s.Add(WithCellScalars(Sphere(9, 7)));
      actor->GetMapper()->SetLookupTable(table);
    });
}

void TestDirectColors(const Compare& compare)
{
  for (int components : { 1, 2, 3, 4 })
  {
    const std::string number = std::to_string(components);
    compare("DirectPointColors" + number,
      [components](RelevoScene& s) { s.Add(WithColors(Sphere(9, 7), components, false)); });
    compare("DirectCellColors" + number,
      [components](RelevoScene& s) { s.Add(WithColors(Sphere(9, 7), components, true)); });
  }
  compare("DirectColorsOff",
    [](RelevoScene& s)
    {
      vtkMapper* mapper = s.Add(WithColors(Sphere(9, 7), 3, false))->GetMapper();
      mapper->SetColorModeToMapScalars();
      mapper->SetScalarRange(0, 255);
    });
}

void TestCellScalars(const Compare& compare)
{
  compare("CellScalars",
    [](RelevoScene& s)
    { s.Add(WithCellScalars(Sphere(9, 7)))->GetMapper()->SetScalarRange(0, 10); });
  compare("CellScalarsOfQuads",
    [](RelevoScene& s)
    { s.Add(WithCellScalars(Plane(5, 4)))->GetMapper()->SetScalarRange(0, 10); });
  compare("CellScalarsOfStrips",
    [](RelevoScene& s) { s.Add(WithCellScalars(Strips()))->GetMapper()->SetScalarRange(0, 10); });
  compare("CellScalarsOfMixedCells",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(WithCellScalars(Mixed()));
      actor->GetMapper()->SetScalarRange(0, 10);
      actor->GetProperty()->SetPointSize(9);
      actor->GetProperty()->SetLineWidth(5);
    });
  compare("CellScalarsFlat",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(WithCellScalars(Sphere(9, 7)));
      actor->GetMapper()->SetScalarRange(0, 10);
      actor->GetProperty()->SetInterpolationToFlat();
    });
}

void TestFieldScalars(const Compare& compare)
{
  compare("FieldScalars",
    [](RelevoScene& s)
    {
      Mesh mesh = Sphere(9, 7);
      AddFieldScalars(mesh, mesh->GetNumberOfCells());
      vtkMapper* mapper = s.Add(mesh)->GetMapper();
      mapper->SetScalarModeToUseFieldData();
      mapper->SelectColorArray("Field");
      mapper->SetFieldDataTupleId(3);
      mapper->SetScalarRange(0, 10);
    });
  compare("FieldScalarsPerCell",
    [](RelevoScene& s)
    {
      Mesh mesh = Strips();
      // Field data have one value per triangle of the strips, as VTK counts them.
      AddFieldScalars(mesh, 400);
      vtkMapper* mapper = s.Add(mesh)->GetMapper();
      mapper->SetScalarModeToUseFieldData();
      mapper->SelectColorArray("Field");
      mapper->SetScalarRange(0, 10);
    });
}

void TestTextures(const Compare& compare)
{
  for (bool interpolate : { false, true })
  {
    compare(interpolate ? "TextureLinear" : "TextureNearest",
      [interpolate](RelevoScene& s)
      { s.Add(TexturedSphere(12, 8))->SetTexture(Checks(interpolate)); });
  }
  compare("TextureMipmap",
    [](RelevoScene& s)
    {
      auto texture = Checks(true);
      texture->MipmapOn();
      texture->RepeatOn();
      s.Add(TexturedSphere(12, 8))->SetTexture(texture);
    });
  compare("TextureWithAlpha",
    [](RelevoScene& s) { s.Add(TexturedSphere(12, 8))->SetTexture(Checks(true, true)); });
  compare("TextureOfCube", [](RelevoScene& s) { s.Add(Cube())->SetTexture(Checks(false)); });
  compare("TwoTextures",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(TexturedSphere(12, 8));
      actor->SetTexture(Checks(true));
      actor->GetProperty()->SetTexture("other", Checks(false));
    });
}

// Shader replacements of the user.
void TestReplacedShaders(const Compare& compare)
{
  compare("ReplacedFragmentShader",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10))
        ->GetShaderProperty()
        ->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
          "//VTK::Light::Impl\n  gl_FragData[0].rgb = gl_FragData[0].bgr * vec3(1.0, 0.5, 0.2);\n",
          false);
    });
  compare("ReplacedVertexShader",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Sphere(12, 10));
      vtkShaderProperty* shaders = actor->GetShaderProperty();
      shaders->AddVertexShaderReplacement(
        "//VTK::Normal::Dec", true, "//VTK::Normal::Dec\n  out vec4 myVertexMC;\n", false);
      shaders->AddVertexShaderReplacement(
        "//VTK::Normal::Impl", true, "//VTK::Normal::Impl\n  myVertexMC = vertexMC;\n", false);
      shaders->AddFragmentShaderReplacement(
        "//VTK::Normal::Dec", true, "//VTK::Normal::Dec\n  varying vec4 myVertexMC;\n", false);
      shaders->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
        "//VTK::Color::Impl\n  diffuseColor = abs(myVertexMC.xyz) * 2.0;\n", false);
    });
}
}

int TestAdaptiveRefinementMapperShading(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  auto compare = [&](const std::string& name, const RelevoComparison::Builder& build)
  { comparison.Compare("Shading." + name, Tight, build); };

  TestNormals(compare);
  TestUnevenNormals(comparison);
  TestLights(compare);
  TestPhysicallyBased(compare);
  TestPointScalars(compare);
  TestSelectedArray(compare);
  TestIndexedLookup(compare);
  TestDirectColors(compare);
  TestCellScalars(compare);
  TestFieldScalars(compare);
  TestTextures(compare);
  TestReplacedShaders(compare);
  return check.GetResult();
}
