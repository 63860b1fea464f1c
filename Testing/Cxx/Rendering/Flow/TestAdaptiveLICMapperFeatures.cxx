// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that streaks work together with all other features of a mapper: half of each colour comes
// from the LIC and half from the picture without it. Actor matrices, picks and copies are tested
// too.
#include "RelevoDisplacements.h"
#include "RelevoLICView.h"
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkAssembly.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLODProp3D.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>
#include <string>

namespace
{
using namespace RelevoMeshes;
using Color = RelevoLICView::Color;
using RelevoLICVectors::Screw;

Color Half(const Color& color, double lic)
{
  return RelevoLICView::Mix(color, Color{ { lic, lic, lic } }, 0.5);
}

Mesh WithScalars(Mesh mesh)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<double>((i * 37) % 11));
    colors->InsertNextTuple3((i * 50) % 256, 200, (i * 90) % 256);
  }
  mesh->GetPointData()->SetScalars(values);
  mesh->GetPointData()->AddArray(colors);
  return mesh;
}

vtkSmartPointer<vtkTexture> Stripes()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 256; ++i)
  {
    unsigned char* texel = static_cast<unsigned char*>(image->GetScalarPointer(i % 16, i / 16, 0));
    texel[0] = static_cast<unsigned char>(i % 2 ? 250 : 40);
    texel[1] = static_cast<unsigned char>(i);
    texel[2] = 100;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

using Change = std::function<void(RelevoLICView&)>;

// Half of the LIC plus half of the picture without it.
struct Features
{
  RelevoCheck& Check;
  RelevoComparison& Comparison;

  void Compare(const std::string& name, Mesh mesh, vtkAdaptiveRefinement* recipe,
    const Change& change, int tolerance = 2)
  {
    if (!mesh->GetPointData()->GetVectors())
    {
      RelevoLICVectors::AddVectors(mesh, Screw);
    }
    RelevoLICView view;
    RelevoErrors errors(view.Add(mesh, recipe)->GetMapper());
    view.Scene->Window->SetSize(150, 150);
    view.Mapper->SetLICIntensity(0.5);
    view.Mapper->ScalarVisibilityOff();
    change(view);
    view.Scene->ResetCameras();
    view.Compare(this->Comparison, "LICFeatures." + name, { tolerance, 0.0, 0 }, Half);
    if (!errors.None())
    {
      errors.Said("");
      this->Check.Fail(__FILE__, __LINE__, name + ": an error");
    }
  }
};

void TestSurfaces(Features& features)
{
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<RelevoHeights> waves;
  waves->FillWaves();
  auto displacement = MakeDisplacement(waves, 0.1);

  features.Compare("Linear", Sphere(12, 10), MakeRecipe(0), [](RelevoLICView&) {});
  features.Compare("Curved", Sphere(8, 6), MakeRecipe(4, surface), [](RelevoLICView&) {});
  features.Compare(
    "Displaced", Torus(), MakeRecipe(4, surface, displacement), [](RelevoLICView&) {});
  features.Compare("Strips", Strips(), MakeRecipe(2), [](RelevoLICView&) {});
}

void TestShading(Features& features)
{
  features.Compare("Flat", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->GetProperty()->SetInterpolationToFlat(); });
  features.Compare("PhysicallyBased", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->GetProperty()->SetInterpolationToPBR(); });
  features.Compare("Unlit", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v)
    {
      v.Actor->GetProperty()->LightingOff();
      v.Actor->GetProperty()->SetColor(0.9, 0.4, 0.1);
    });
  features.Compare("NoNormals", Cone(), MakeRecipe(2), [](RelevoLICView&) {});
  features.Compare(
    "Texture", Torus(), MakeRecipe(2), [](RelevoLICView& v) { v.Actor->SetTexture(Stripes()); });
}

void TestScalars(Features& features)
{
  for (const bool interpolated : { false, true })
  {
    features.Compare(interpolated ? "InterpolatedScalars" : "Scalars", WithScalars(Sphere(12, 10)),
      MakeRecipe(2),
      [interpolated](RelevoLICView& v)
      {
        v.Mapper->ScalarVisibilityOn();
        v.Mapper->SetScalarRange(0, 10);
        v.Mapper->SetInterpolateScalarsBeforeMapping(interpolated);
      });
  }
  features.Compare("DirectScalars", WithScalars(Sphere(12, 10)), MakeRecipe(2),
    [](RelevoLICView& v)
    {
      v.Mapper->ScalarVisibilityOn();
      v.Mapper->SetScalarModeToUsePointFieldData();
      v.Mapper->SelectColorArray("Colors");
      v.Mapper->SetColorModeToDirectScalars();
    });
}

void TestRefinementColors(Features& features)
{
  features.Compare("Levels", Tagged(Sphere(12, 10), 4), MakeRecipe(4),
    [](RelevoLICView& v) { v.Mapper->SetColorModeToLevel(); });
  features.Compare("Patterns", Tagged(Sphere(12, 10), 4), MakeRecipe(4),
    [](RelevoLICView& v) { v.Mapper->SetColorModeToPattern(); });
  features.Compare("Metric", Tagged(Sphere(12, 10), 4), MakeRecipe(4),
    [](RelevoLICView& v) { v.Mapper->SetColorModeToMetric(); });
}

void TestLevels(Features& features)
{
  vtkNew<vtkPNTriangleSurface> surface;
  auto morphing = MakeRecipe(4, surface);
  morphing->GeomorphingOn();
  features.Compare("Geomorphing", Tagged(Sphere(12, 10), 4), morphing, [](RelevoLICView&) {});
  features.Compare("Budget", Sphere(12, 10), MakeRecipe(5, surface),
    [](RelevoLICView& v) { v.Mapper->SetTargetNumberOfTriangles(3000); });
}

void TestHiddenFaces(Features& features)
{
  features.Compare("Clipped", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.3, 1, 0.2);
      v.Mapper->AddClippingPlane(plane);
    });
  features.Compare("BackFacesOff", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->GetProperty()->BackfaceCullingOn(); });
  features.Compare("FrontFacesOff", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->GetProperty()->FrontfaceCullingOn(); });
}

void TestReplacedShader(Features& features)
{
  features.Compare("ReplacedShader", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v)
    {
      v.Actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
        "//VTK::Light::Impl\n  gl_FragData[0].rgb = gl_FragData[0].bgr * vec3(1.0, 0.5, 0.2);\n",
        false);
    });
}

void TestFarAway(Features& features)
{
  features.Compare(
    "FarAway", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->SetPosition(1e5, 2e5, -1e5); }, 3);
}

// Without faces there is nothing to convolve.
void TestRepresentations(RelevoCheck& check, RelevoComparison& comparison)
{
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    CHECK_CASE(representation);
    RelevoLICView view;
    vtkActor* actor = view.Add(Sphere(12, 10), MakeRecipe(2));
    RelevoErrors errors(view.Mapper);
    actor->GetProperty()->SetRepresentation(representation);
    view.Scene->ResetCameras();
    comparison.Compare("LICFeatures.Representation" + std::to_string(representation), {},
      view.Draw(), view.DrawColors());
    CHECK(errors.None());
    CHECK_EQUAL(view.Mapper->GetNumberOfConvolutions(), 0);
    actor->GetProperty()->SetRepresentationToSurface();
    view.Draw();
    CHECK_EQUAL(view.Mapper->GetNumberOfConvolutions(), 1);
  }
}

struct Placement
{
  const char* Name;
  double Scale[3];
  double Angle;
};

// The picture equals that of the transformed mesh with transformed vectors.
void TestPlacement(RelevoComparison& comparison, const Placement& placement)
{
  vtkNew<vtkTransform> transform;
  transform->RotateX(placement.Angle);
  transform->RotateZ(0.5 * placement.Angle);
  transform->Scale(placement.Scale);
  Mesh mesh = Sphere(16, 14);
  RelevoLICVectors::AddVectors(mesh, Screw);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(mesh);
  filter->SetTransform(transform);
  filter->Update();
  RelevoLICView moved;
  vtkActor* actor = moved.Add(mesh, MakeRecipe(1));
  actor->SetUserTransform(transform);
  RelevoLICView baked;
  baked.Add(filter->GetOutput(), MakeRecipe(1));
  RelevoLICView assembled;
  vtkSmartPointer<vtkActor> part = assembled.Add(mesh, MakeRecipe(1));
  assembled.Scene->Renderer->RemoveActor(part);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(part);
  assembly->SetUserTransform(transform);
  assembled.Scene->Renderer->AddActor(assembly);
  for (RelevoLICView* view : { &moved, &baked, &assembled })
  {
    view->Mapper->SetNoDataMagnitude(1e20);
    view->Scene->Window->SetSize(150, 150);
    view->Mapper->SetLICIntensity(1.0);
  }
  baked.Scene->ResetCameras();
  moved.Scene->CopyCameras(*baked.Scene);
  assembled.Scene->CopyCameras(*baked.Scene);
  const RelevoPicture expected = baked.Draw();
  const std::string name = std::string("LICFeatures.") + placement.Name;
  // Points differ by rounding, and so may a streamline that passes the border of a texel.
  comparison.Compare(name, { 12, 1e-4, 150 }, moved.Draw(), expected);
  comparison.Compare(name + "Assembly", { 12, 1e-4, 150 }, assembled.Draw(), expected);
}

// Vectors rotate with the actor.
void TestPlacements(RelevoComparison& comparison)
{
  for (const Placement& placement :
    { Placement{ "Rotated", { 1, 1, 1 }, 50 }, Placement{ "Mirrored", { -1, 1, 1 }, 30 },
      Placement{ "Stretched", { 1, 2.5, 0.5 }, 20 }, Placement{ "Small", { 1e-6, 1e-6, 1e-6 }, 0 },
      Placement{ "Large", { 1e9, 1e9, 1e9 }, 10 } })
  {
    TestPlacement(comparison, placement);
  }
}

// Props with several levels of detail pass their mapper to another actor.
void TestLevelOfDetail(RelevoComparison& comparison)
{
  RelevoLICView view;
  vtkSmartPointer<vtkActor> actor = view.Add(Sphere(12, 10), MakeRecipe(2));
  view.Scene->ResetCameras();
  const RelevoPicture expected = view.Draw();
  view.Scene->Renderer->RemoveActor(actor);
  vtkNew<vtkLODProp3D> lod;
  lod->AddLOD(view.Mapper, 0.0);
  view.Scene->Renderer->AddActor(lod);
  comparison.Compare("LICFeatures.LevelOfDetail", {}, view.Draw(), expected);
}

void TestPicks(RelevoCheck& check, RelevoComparison& comparison)
{
  for (const int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    CHECK_CASE(association);
    RelevoLICView view;
    view.Add(Cube(), MakeRecipe(2));
    view.Scene->Window->SetSize(100, 100);
    view.Scene->ResetCameras();
    const RelevoPicture before = view.Draw();
    const auto with = RelevoPicks::SelectPixels(*view.Scene, association);
    comparison.Compare("LICFeatures.AfterPick", {}, view.Draw(), before);
    CHECK_EQUAL(view.Mapper->GetNumberOfConvolutions(), 1);
    view.Mapper->EnableOff();
    view.Draw();
    const auto without = RelevoPicks::SelectPixels(*view.Scene, association);
    CHECK_EQUAL(with.size(), 10000);
    CHECK_EQUAL(with, without);
    CHECK(std::any_of(
      with.begin(), with.end(), [](const RelevoPicks::Hit& hit) { return hit.Id >= 0; }));
  }
}

// Copies, and the two meanings of a colour mode.
void TestCopies(RelevoCheck& check, RelevoComparison& comparison)
{
  Mesh mesh = WithScalars(Sphere(12, 10));
  RelevoLICVectors::AddVectors(mesh, Screw);
  RelevoLICView view;
  vtkActor* actor = view.Add(mesh, MakeRecipe(2));
  vtkAdaptiveLICMapper* mapper = view.Mapper;
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Colors");
  mapper->SetNumberOfSteps(13);
  mapper->SetStepSize(0.7);
  mapper->SetColorModeToMultiply();
  mapper->SetColorModeToDirectScalars();
  mapper->SetMapModeBias(0.2);
  mapper->SetNoiseGeneratorSeed(5);
  view.Scene->ResetCameras();
  const RelevoPicture expected = view.Draw();
  CHECK_EQUAL(mapper->GetColorMode(), VTK_COLOR_MODE_DIRECT_SCALARS);
  CHECK_EQUAL(mapper->GetLICInterface()->GetColorMode(), vtkLICSettings::COLOR_MODE_MAP);
  vtkNew<vtkAdaptiveLICMapper> copy;
  copy->ShallowCopy(mapper);
  copy->BackFaceCullingOff();
  actor->SetMapper(copy);
  comparison.Compare("LICFeatures.Copy", {}, view.Draw(), expected);
  copy->SetColorModeToBlend();
  CHECK_EQUAL(copy->GetColorMode(), VTK_COLOR_MODE_DIRECT_SCALARS);
  copy->SetColorMode(VTK_COLOR_MODE_MAP_SCALARS);
  CHECK_EQUAL(copy->GetColorMode(), VTK_COLOR_MODE_MAP_SCALARS);
  CHECK_EQUAL(copy->GetLICInterface()->GetColorMode(), vtkLICSettings::COLOR_MODE_BLEND);
  vtkNew<vtkPolyDataMapper> plain;
  plain->SetColorModeToDirectScalars();
  plain->SetInputData(mesh);
  copy->ShallowCopy(plain);
  CHECK_EQUAL(copy->GetColorMode(), VTK_COLOR_MODE_DIRECT_SCALARS);
  CHECK_EQUAL(copy->GetLICInterface()->GetColorMode(), vtkLICSettings::COLOR_MODE_BLEND);
}
}

int TestAdaptiveLICMapperFeatures(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  Features features{ check, comparison };
  TestSurfaces(features);
  TestShading(features);
  TestScalars(features);
  TestRefinementColors(features);
  TestLevels(features);
  TestHiddenFaces(features);
  TestReplacedShader(features);
  TestFarAway(features);
  TestRepresentations(check, comparison);
  TestPlacements(comparison);
  TestLevelOfDetail(comparison);
  TestPicks(check, comparison);
  TestCopies(check, comparison);
  return check.GetResult();
}
