// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A LIC beside all else that a mapper does: half of the picture's colours are the LIC, half those
// of the surface without it. Translucent layers, actors' matrices, picks, copies.
#include "RelevoLICView.h"
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkAppendPolyData.h"
#include "vtkAssembly.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
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
#include <cmath>

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

// A square of side 2 at height z that fills the upper or the lower half or the whole of a picture
// that LookDown() shows.
Mesh Square(double z)
{
  const double offset[3] = { 0, 0, z };
  Mesh mesh = Moved(Plane(4, 4), 2.0, offset, VTK_FLOAT);
  RelevoLICVectors::AddVectors(mesh,
    [](const double* p) {
      return std::array<double, 3>{ { 1.0 - p[1], p[0], 0.0 } };
    });
  return mesh;
}

void LookDown(RelevoScene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(0, 0, 5);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 1, 0);
  camera->SetParallelScale(1.1);
  scene.Window->SetSize(160, 160);
  scene.Renderer->ResetCameraClippingRange();
}
}

int TestAdaptiveLICMapperFeatures(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);

  // Half LIC, half what is seen without.
  using Change = std::function<void(RelevoLICView&)>;
  auto compare = [&](const std::string& name, Mesh mesh, vtkAdaptiveRefinement* recipe,
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
    view.Compare(comparison, "LICFeatures." + name, { tolerance, 0.0, 0 }, Half);
    if (!errors.None())
    {
      errors.Said("");
      check.Fail(__FILE__, __LINE__, name + ": an error");
    }
  };
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<RelevoHeights> waves;
  waves->FillWaves();
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(waves);
  displacement->SetScale(0.1);

  compare("Linear", Sphere(12, 10), MakeRecipe(0), [](RelevoLICView&) {});
  compare("Curved", Sphere(8, 6), MakeRecipe(4, surface), [](RelevoLICView&) {});
  compare("Displaced", Torus(), MakeRecipe(4, surface, displacement), [](RelevoLICView&) {});
  compare("Strips", Strips(), MakeRecipe(2), [](RelevoLICView&) {});
  compare("Flat", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->GetProperty()->SetInterpolationToFlat(); });
  compare("PhysicallyBased", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->GetProperty()->SetInterpolationToPBR(); });
  compare("Unlit", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v)
    {
      v.Actor->GetProperty()->LightingOff();
      v.Actor->GetProperty()->SetColor(0.9, 0.4, 0.1);
    });
  compare("NoNormals", Cone(), MakeRecipe(2), [](RelevoLICView&) {});
  compare(
    "Texture", Torus(), MakeRecipe(2), [](RelevoLICView& v) { v.Actor->SetTexture(Stripes()); });
  for (const bool interpolated : { false, true })
  {
    compare(interpolated ? "InterpolatedScalars" : "Scalars", WithScalars(Sphere(12, 10)),
      MakeRecipe(2),
      [interpolated](RelevoLICView& v)
      {
        v.Mapper->ScalarVisibilityOn();
        v.Mapper->SetScalarRange(0, 10);
        v.Mapper->SetInterpolateScalarsBeforeMapping(interpolated);
      });
  }
  compare("DirectScalars", WithScalars(Sphere(12, 10)), MakeRecipe(2),
    [](RelevoLICView& v)
    {
      v.Mapper->ScalarVisibilityOn();
      v.Mapper->SetScalarModeToUsePointFieldData();
      v.Mapper->SelectColorArray("Colors");
      v.Mapper->SetColorModeToDirectScalars();
    });
  compare("Levels", Tagged(Sphere(12, 10), 4), MakeRecipe(4),
    [](RelevoLICView& v) { v.Mapper->SetColorModeToLevel(); });
  compare("Patterns", Tagged(Sphere(12, 10), 4), MakeRecipe(4),
    [](RelevoLICView& v) { v.Mapper->SetColorModeToPattern(); });
  compare("Metric", Tagged(Sphere(12, 10), 4), MakeRecipe(4),
    [](RelevoLICView& v) { v.Mapper->SetColorModeToMetric(); });
  auto morphing = MakeRecipe(4, surface);
  morphing->GeomorphingOn();
  compare("Geomorphing", Tagged(Sphere(12, 10), 4), morphing, [](RelevoLICView&) {});
  compare("Budget", Sphere(12, 10), MakeRecipe(5, surface),
    [](RelevoLICView& v) { v.Mapper->SetTargetNumberOfTriangles(3000); });
  compare("Clipped", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.3, 1, 0.2);
      v.Mapper->AddClippingPlane(plane);
    });
  compare("BackFacesOff", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->GetProperty()->BackfaceCullingOn(); });
  compare("FrontFacesOff", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->GetProperty()->FrontfaceCullingOn(); });
  compare("ReplacedShader", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v)
    {
      v.Actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
        "//VTK::Light::Impl\n  gl_FragData[0].rgb = gl_FragData[0].bgr * vec3(1.0, 0.5, 0.2);\n",
        false);
    });
  compare(
    "FarAway", Sphere(12, 10), MakeRecipe(2),
    [](RelevoLICView& v) { v.Actor->SetPosition(1e5, 2e5, -1e5); }, 3);

  // Edges are drawn over the LIC.
  {
    RelevoLICView view;
    vtkActor* actor = view.Add(Square(0.0));
    LookDown(*view.Scene);
    actor->GetProperty()->EdgeVisibilityOn();
    actor->GetProperty()->SetEdgeColor(1, 0, 0);
    view.Mapper->SetLICIntensity(1.0);
    const RelevoPicture picture = view.Draw();
    size_t red = 0;
    for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
    {
      const Color color = RelevoLICView::At(picture, i);
      red += color[0] > color[1] + 0.25 ? 1 : 0;
    }
    CHECK(red > 800);
  }

  // Without faces there is nothing to convolve.
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    RelevoLICView view;
    vtkActor* actor = view.Add(Sphere(12, 10), MakeRecipe(2));
    RelevoErrors errors(view.Mapper);
    actor->GetProperty()->SetRepresentation(representation);
    view.Scene->ResetCameras();
    comparison.Compare("LICFeatures.Representation" + std::to_string(representation), {},
      view.Draw(), view.DrawColors());
    CHECK(errors.None());
    CHECK(view.Mapper->GetNumberOfConvolutions() == 0);
    actor->GetProperty()->SetRepresentationToSurface();
    view.Draw();
    CHECK(view.Mapper->GetNumberOfConvolutions() == 1);
  }

  // Translucent layers: each mesh has its LIC, and of one mesh the layer in front.
  for (const bool peeling : { false, true })
  {
    const std::string suffix = peeling ? "Peeled" : "Blended";
    const auto setUp = [peeling](RelevoScene& scene)
    {
      scene.Renderer->SetUseDepthPeeling(peeling);
      scene.Renderer->SetMaximumNumberOfPeels(12);
      scene.Renderer->SetOcclusionRatio(0.0);
      LookDown(scene);
    };
    const auto mix = [](const RelevoPicture& behind, const RelevoPicture& front)
    {
      RelevoPicture result = front;
      for (size_t i = 0; i < front.Colors.size(); ++i)
      {
        result.Colors[i] =
          static_cast<unsigned char>(std::lround(0.5 * (behind.Colors[i] + front.Colors[i])));
      }
      return result;
    };
    const auto compareColors =
      [&](const std::string& name, const RelevoPicture& actual, RelevoPicture expected)
    {
      expected.Depths = actual.Depths; // translucent layers have none
      comparison.Compare("LICFeatures." + name + suffix, { 2, 0.0, 0 }, actual, expected);
    };
    for (const int contrast : { 0, 1, 3, 4 })
    {
      // In front of the back layer's opaque picture; then an opaque LIC behind a translucent one.
      RelevoLICView view;
      vtkActor* back = view.Scene->Add(Square(0.0), MakeRecipe(1));
      vtkActor* front = view.Add(Square(1.0), MakeRecipe(2));
      for (vtkActor* actor : { back, front })
      {
        RelevoLICVectors::GetMapper(actor)->SetEnhanceContrast(contrast);
      }
      front->GetProperty()->SetColor(1.0, 0.6, 0.2);
      setUp(*view.Scene);
      const RelevoPicture fore = view.Draw();
      front->VisibilityOff();
      const RelevoPicture behind = view.Draw();
      front->VisibilityOn();
      front->GetProperty()->SetOpacity(0.5);
      const std::string number = std::to_string(contrast);
      compareColors("OverLIC" + number, view.Draw(), mix(behind, fore));
      if (!peeling)
      {
        continue; // several layers are blended in no order
      }
      back->GetProperty()->SetOpacity(0.5);
      front->VisibilityOff();
      const RelevoPicture translucent = view.Draw();
      front->VisibilityOn();
      compareColors("TwoLayers" + number, view.Draw(), mix(translucent, fore));
    }
    if (peeling)
    {
      vtkNew<vtkAppendPolyData> append;
      append->AddInputData(Square(0.0));
      append->AddInputData(Square(1.0));
      append->Update();
      RelevoLICView view;
      vtkActor* actor = view.Add(append->GetOutput(), MakeRecipe(1));
      setUp(*view.Scene);
      const RelevoPicture fore = view.Draw();
      view.Mapper->EnableOff();
      const RelevoPicture plain = view.Draw();
      actor->VisibilityOff();
      const RelevoPicture empty = view.Draw();
      actor->VisibilityOn();
      view.Mapper->EnableOn();
      actor->GetProperty()->SetOpacity(0.5);
      compareColors("OneMesh", view.Draw(), mix(mix(empty, plain), fore));
      CHECK(view.Mapper->GetNumberOfConvolutions() <= 2);
    }
  }

  // Vectors turn with the actor: as if the mesh, with its vectors, had been transformed.
  {
    struct Placement
    {
      const char* Name;
      double Scale[3];
      double Angle;
    };
    for (const Placement& placement : { Placement{ "Rotated", { 1, 1, 1 }, 50 },
           Placement{ "Mirrored", { -1, 1, 1 }, 30 }, Placement{ "Stretched", { 1, 2.5, 0.5 }, 20 },
           Placement{ "Small", { 1e-6, 1e-6, 1e-6 }, 0 },
           Placement{ "Large", { 1e9, 1e9, 1e9 }, 10 } })
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
      // Points differ by a rounding, and so may a streamline that passes the border of a texel.
      comparison.Compare(name, { 12, 1e-4, 150 }, moved.Draw(), expected);
      comparison.Compare(name + "Assembly", { 12, 1e-4, 150 }, assembled.Draw(), expected);
    }
  }

  // Props of several levels of detail hand their mapper to another actor.
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

  // Picks.
  for (const int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    RelevoLICView view;
    view.Add(Cube(), MakeRecipe(2));
    view.Scene->Window->SetSize(100, 100);
    view.Scene->ResetCameras();
    const RelevoPicture before = view.Draw();
    const auto with = RelevoPicks::SelectPixels(*view.Scene, association);
    comparison.Compare("LICFeatures.AfterPick", {}, view.Draw(), before);
    CHECK(view.Mapper->GetNumberOfConvolutions() == 1);
    view.Mapper->EnableOff();
    view.Draw();
    const auto without = RelevoPicks::SelectPixels(*view.Scene, association);
    CHECK(with.size() == 10000 && with == without);
    CHECK(std::any_of(
      with.begin(), with.end(), [](const RelevoPicks::Hit& hit) { return hit.Id >= 0; }));
  }

  // Copies; and the two meanings of a colour mode.
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
    CHECK(mapper->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS);
    CHECK(mapper->GetLICInterface()->GetColorMode() == vtkLICSettings::COLOR_MODE_MAP);
    vtkNew<vtkAdaptiveLICMapper> copy;
    copy->ShallowCopy(mapper);
    copy->BackFaceCullingOff();
    actor->SetMapper(copy);
    comparison.Compare("LICFeatures.Copy", {}, view.Draw(), expected);
    copy->SetColorModeToBlend();
    CHECK(copy->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS);
    copy->SetColorMode(VTK_COLOR_MODE_MAP_SCALARS);
    CHECK(copy->GetColorMode() == VTK_COLOR_MODE_MAP_SCALARS);
    CHECK(copy->GetLICInterface()->GetColorMode() == vtkLICSettings::COLOR_MODE_BLEND);
    vtkNew<vtkPolyDataMapper> plain;
    plain->SetColorModeToDirectScalars();
    plain->SetInputData(mesh);
    copy->ShallowCopy(plain);
    CHECK(copy->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS);
    CHECK(copy->GetLICInterface()->GetColorMode() == vtkLICSettings::COLOR_MODE_BLEND);
  }
  return check.GetResult();
}
