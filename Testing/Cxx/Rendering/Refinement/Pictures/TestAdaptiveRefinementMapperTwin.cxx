// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md: the mapper draws the same triangles as the filter, compared with the picture of
// the filter's output in a vtkPolyDataMapper.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"
#include "RelevoTextures.h"
#include "RelevoUnevenNormals.h"

#include "vtkCellData.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

namespace
{
using namespace RelevoMeshes;

vtkSmartPointer<vtkTexture> Stripes()
{
  auto texture = RelevoTextures::Make(32, 16, 3,
    [](int x, int y) {
      return RelevoTextures::Texel{ { 8 * x, 16 * y, x % 4 < 2 ? 255 : 80, 255 } };
    });
  texture->InterpolateOn();
  return texture;
}

// Points agree up to the last bits of a float, so colours and depths hardly differ. A pixel at a
// triangle's border may show its neighbour or the background.
const RelevoTolerance Close{ 2, 2e-6, 10 };

// The parts of the scenes.
struct Parts
{
  RelevoComparison& Comparison;
  vtkNew<vtkPNTriangleSurface> Quadratic;
  vtkNew<vtkPNTriangleSurface> LinearNormals;
  vtkNew<RelevoHeights> Rough;
  vtkNew<RelevoHeights> Smooth;

  explicit Parts(RelevoComparison& comparison)
    : Comparison(comparison)
  {
    this->LinearNormals->QuadraticNormalsOff();
    this->Rough->FillRandom(40, 30, 3);
    this->Smooth->FillWaves();
  }

  void Compare(const std::string& name, const RelevoComparison::Builder& build,
    const std::vector<RelevoComparison::Step>& steps = {}) const
  {
    this->Comparison.Compare("Twin." + name, Close, build, steps);
  }
};

struct Surface
{
  std::string Name;
  vtkRefinementSurface* Object;
};

std::vector<Surface> GetSurfaces(const Parts& parts)
{
  return { { "Linear", nullptr }, { "Quadratic", parts.Quadratic },
    { "LinearNormals", parts.LinearNormals } };
}

vtkSmartPointer<vtkDisplacement> MakeDisplacementUp(vtkHeightField* heights, double scale)
{
  return MakeDisplacementAlong(0.2, 0.1, 1, heights, scale);
}

void TestMeshes(const Parts& parts, const Surface& surface)
{
  parts.Compare(surface.Name + ".Uniform",
    [&](RelevoScene& s) { s.Add(Sphere(9, 7), MakeRecipe(3, surface.Object)); });
  parts.Compare(surface.Name + ".Tagged",
    [&](RelevoScene& s) { s.Add(Tagged(Sphere(9, 7), 5), MakeRecipe(5, surface.Object)); });
  parts.Compare(surface.Name + ".Coarse",
    [&](RelevoScene& s) { s.Add(Sphere(3, 3), MakeRecipe(4, surface.Object)); });
  parts.Compare(surface.Name + ".TaggedFlat",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(Sphere(9, 7), 4), MakeRecipe(4, surface.Object))
        ->GetProperty()
        ->SetInterpolationToFlat();
    });
  parts.Compare(surface.Name + ".Cube",
    [&](RelevoScene& s) { s.Add(Tagged(Cube(), 5), MakeRecipe(5, surface.Object)); });
  parts.Compare(surface.Name + ".Strips",
    [&](RelevoScene& s) { s.Add(Tagged(Strips(), 4), MakeRecipe(4, surface.Object)); });
  parts.Compare(surface.Name + ".Mixed",
    [&](RelevoScene& s)
    {
      vtkProperty* property = s.Add(Mixed(), MakeRecipe(3, surface.Object))->GetProperty();
      property->SetPointSize(8);
      property->SetLineWidth(4);
    });
}

void TestLook(const Parts& parts, const Surface& surface)
{
  parts.Compare(surface.Name + ".BackfaceCulling",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(Moebius(), 4), MakeRecipe(4, surface.Object))
        ->GetProperty()
        ->BackfaceCullingOn();
    });
  parts.Compare(surface.Name + ".BackfaceProperty",
    [&](RelevoScene& s)
    {
      vtkNew<vtkProperty> back;
      back->SetColor(1, 0, 0);
      s.Add(Tagged(Moebius(), 4), MakeRecipe(4, surface.Object))->SetBackfaceProperty(back);
    });
  parts.Compare(surface.Name + ".Edges",
    [&](RelevoScene& s)
    {
      vtkProperty* property =
        s.Add(Tagged(Sphere(9, 7), 3), MakeRecipe(3, surface.Object))->GetProperty();
      property->EdgeVisibilityOn();
      property->SetLineWidth(2);
    });
  parts.Compare(surface.Name + ".ClippingPlane",
    [&](RelevoScene& s)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1, 0.3, 0.2);
      s.Add(Tagged(Sphere(9, 7), 4), MakeRecipe(4, surface.Object))
        ->GetMapper()
        ->AddClippingPlane(plane);
    });
  parts.Compare(surface.Name + ".Points",
    [&](RelevoScene& s)
    {
      vtkProperty* property =
        s.Add(Tagged(Sphere(6, 5), 3), MakeRecipe(3, surface.Object))->GetProperty();
      property->SetRepresentationToPoints();
      property->SetPointSize(3);
    });
}

// Vertices and lines of a refined mesh use the filter's normals.
void TestUnevenNormals(const Parts& parts)
{
  for (bool someAreZero : { false, true })
  {
    for (const auto& surface : GetSurfaces(parts))
    {
      parts.Compare(surface.Name + (someAreZero ? ".ZeroNormals" : ".UnevenNormals"),
        [&](RelevoScene& s)
        {
          vtkProperty* property =
            s.Add(WithUnevenNormals(Mixed(), someAreZero), MakeRecipe(3, surface.Object))
              ->GetProperty();
          property->SetPointSize(8);
          property->SetLineWidth(4);
        });
    }
  }
}

void TestDisplaced(const Parts& parts, const Surface& surface)
{
  const std::string name = "Displaced." + surface.Name;
  parts.Compare(name + ".Smooth",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(TexturedSphere(9, 7), 6),
        MakeRecipe(6, surface.Object, MakeDisplacement(parts.Smooth, 0.08)));
    });
  parts.Compare(name + ".Rough",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(TexturedSphere(9, 7), 5),
        MakeRecipe(5, surface.Object, MakeDisplacement(parts.Rough, 0.1, -0.05)));
    });
  parts.Compare(name + ".Direction",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(Plane(3, 4), 6),
        MakeRecipe(6, surface.Object, MakeDisplacementUp(parts.Rough, 0.2)));
    });
  parts.Compare(name + ".SplitNormals",
    [&](RelevoScene& s) {
      s.Add(Tagged(Cube(), 5), MakeRecipe(5, surface.Object, MakeDisplacement(parts.Rough, 0.1)));
    });
  parts.Compare(name + ".OffsetOnly",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(TexturedSphere(9, 7), 4),
        MakeRecipe(4, surface.Object, MakeDisplacement(nullptr, 1, 0.2)));
    });
  parts.Compare(name + ".Textured",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(TexturedSphere(9, 7), 5),
         MakeRecipe(5, surface.Object, MakeDisplacement(parts.Smooth, 0.1)))
        ->SetTexture(Stripes());
    });
  parts.Compare(name + ".Transformed",
    [&](RelevoScene& s)
    {
      vtkActor* actor = s.Add(
        Tagged(Cube(), 4), MakeRecipe(4, surface.Object, MakeDisplacement(parts.Smooth, 0.1)));
      actor->RotateX(20);
      actor->SetScale(1, 2, -0.7);
    });
  parts.Compare(name + ".FarAway",
    [&](RelevoScene& s)
    {
      const double offset[3] = { 5e6, -4e6, 100 };
      s.Add(Tagged(Moved(TexturedSphere(9, 7), 100, offset, VTK_DOUBLE), 5),
        MakeRecipe(5, surface.Object, MakeDisplacement(parts.Smooth, 20)));
    });
}

void TestDisplacedLook(const Parts& parts)
{
  parts.Compare("Displaced.Flat",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(TexturedSphere(9, 7), 4),
         MakeRecipe(4, parts.Quadratic, MakeDisplacement(parts.Smooth, 0.1)))
        ->GetProperty()
        ->SetInterpolationToFlat();
    });
  parts.Compare("Displaced.Translucent",
    [&](RelevoScene& s)
    {
      s.Renderer->UseDepthPeelingOn();
      s.Renderer->SetMaximumNumberOfPeels(20);
      s.Add(Tagged(TexturedSphere(9, 7), 4),
         MakeRecipe(4, parts.Quadratic, MakeDisplacement(parts.Smooth, 0.1)))
        ->GetProperty()
        ->SetOpacity(0.5);
    });
}

Mesh WithScalars(Mesh mesh, bool ofCells)
{
  const vtkIdType count = ofCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->InsertNextValue((i * 37) % 11);
  }
  vtkDataSetAttributes* data = mesh->GetPointData();
  if (ofCells)
  {
    data = mesh->GetCellData();
  }
  data->SetScalars(values);
  return mesh;
}

void TestScalars(const Parts& parts, bool ofCells, bool interpolated)
{
  const std::string name = std::string("Scalars.") + (ofCells ? "Cells" : "Points") +
    (interpolated ? ".Interpolated" : "");
  parts.Compare(name,
    [&](RelevoScene& s)
    {
      vtkActor* actor =
        s.Add(WithScalars(Tagged(Sphere(9, 7), 4), ofCells), MakeRecipe(4, parts.Quadratic));
      actor->GetMapper()->SetScalarRange(1, 9);
      actor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolated);
    });
  parts.Compare(name + ".Bands",
    [&](RelevoScene& s)
    {
      vtkNew<vtkLookupTable> table;
      table->SetNumberOfTableValues(4);
      table->SetTableRange(0, 10);
      table->Build();
      vtkActor* actor =
        s.Add(WithScalars(Tagged(Cube(), 4), ofCells), MakeRecipe(4, parts.Quadratic));
      actor->GetMapper()->SetLookupTable(table);
      actor->GetMapper()->UseLookupTableScalarRangeOn();
      actor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolated);
      actor->GetProperty()->LightingOff();
    });
  parts.Compare(name + ".Translucent",
    [&](RelevoScene& s)
    {
      s.Renderer->UseDepthPeelingOn();
      vtkActor* actor =
        s.Add(WithScalars(Tagged(Strips(), 4), ofCells), MakeRecipe(4, parts.Quadratic));
      actor->GetMapper()->SetScalarRange(1, 9);
      actor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolated);
      actor->GetProperty()->SetOpacity(0.5);
    });
}

void TestMixedCellScalars(const Parts& parts)
{
  parts.Compare("CellScalars.Mixed",
    [&](RelevoScene& s)
    {
      vtkActor* actor = s.Add(WithScalars(Mixed(), true), MakeRecipe(2));
      actor->GetMapper()->SetScalarRange(0, 10);
      actor->GetProperty()->SetPointSize(8);
      actor->GetProperty()->SetLineWidth(4);
    });
}

void TestDirectColors(const Parts& parts)
{
  parts.Compare("DirectColors",
    [&](RelevoScene& s)
    {
      Mesh mesh = Tagged(Sphere(9, 7), 4);
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetNumberOfComponents(3);
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        colors->InsertNextTuple3(i * 31 % 256, i * 57 % 256, i * 91 % 256);
      }
      mesh->GetPointData()->SetScalars(colors);
      s.Add(mesh, MakeRecipe(4, parts.LinearNormals));
    });
}

void TestViews(const Parts& parts)
{
  vtkNew<vtkDistanceDepthTagMetric> distance;
  auto nearby = MakeRecipe(6, parts.Quadratic);
  nearby->SetMetric(distance);
  parts.Compare("Distance",
    [&](RelevoScene& s)
    {
      distance->SetMaximumDistance(4);
      vtkActor* actor = s.Add(TexturedSphere(12, 10), nearby);
      actor->GetProperty()->SetInterpolationToFlat();
    },
    { { "Closer", [](RelevoScene& s) { s.Renderer->GetActiveCamera()->Dolly(1.7); } },
      { "Aside", [](RelevoScene& s) { s.Renderer->GetActiveCamera()->Azimuth(70); } },
      { "Stretched", [](RelevoScene& s) { s.GetActor(0)->SetScale(2, 0.5, 1); } },
      { "Moved",
        [](RelevoScene& s)
        {
          s.GetActor(0)->SetPosition(0.3, 0, 0.2);
          s.GetActor(0)->RotateY(25);
        } },
      { "FartherReach", [&](RelevoScene&) { distance->SetMaximumDistance(9); } } });
}

// Composite data. The twin is one mesh, so blocks must not touch.
void TestBlocks(const Parts& parts)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const double aside[3] = { 1.5, 0.3, 0.0 };
  blocks->SetBlock(1, Tagged(TexturedSphere(8, 6), 4));
  blocks->SetBlock(3, Tagged(Moved(TexturedSphere(6, 5), 1, aside, VTK_FLOAT), 4));
  parts.Compare("Blocks",
    [&](RelevoScene& s)
    { s.Add(blocks, MakeRecipe(4, parts.Quadratic, MakeDisplacement(parts.Rough, 0.1))); });
}

// Missing heights: borders of holes cut pixels, not triangles.
void TestHoles(RelevoComparison& comparison)
{
  vtkNew<RelevoHeights> holes;
  holes->FillWavesWithHoles();
  RelevoTolerance rims = Close;
  rims.Pixels = 45;
  const auto withHoles = [&](RelevoScene& s)
  { s.Add(Tagged(Plane(3, 4), 6), MakeRecipe(6, nullptr, MakeDisplacementUp(holes, 0.1))); };
  comparison.Compare("Twin.Displaced.Holes", rims, withHoles);
}
}

int TestAdaptiveRefinementMapperTwin(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  const Parts parts(comparison);
  for (const Surface& surface : GetSurfaces(parts))
  {
    TestMeshes(parts, surface);
    TestLook(parts, surface);
  }
  TestUnevenNormals(parts);
  for (const Surface& surface : GetSurfaces(parts))
  {
    TestDisplaced(parts, surface);
  }
  TestDisplacedLook(parts);
  for (bool ofCells : { false, true })
  {
    for (bool interpolated : { false, true })
    {
      TestScalars(parts, ofCells, interpolated);
    }
  }
  TestMixedCellScalars(parts);
  TestDirectColors(parts);
  TestViews(parts);
  TestBlocks(parts);
  TestHoles(comparison);
  return check.GetResult();
}
