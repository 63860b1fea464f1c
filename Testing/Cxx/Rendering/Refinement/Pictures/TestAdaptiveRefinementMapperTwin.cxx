// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinementMapper draws what vtkPolyDataMapper draws of
// vtkAdaptiveRefinementFilter's output, and as many triangles.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"
#include "RelevoUnevenNormals.h"

#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

namespace
{
using namespace RelevoMeshes;

vtkSmartPointer<vtkTexture> Stripes()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(32, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 16; ++y)
  {
    for (int x = 0; x < 32; ++x)
    {
      unsigned char* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = static_cast<unsigned char>(8 * x);
      pixel[1] = static_cast<unsigned char>(16 * y);
      pixel[2] = static_cast<unsigned char>(x % 4 < 2 ? 255 : 80);
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

// Points are the same up to the last bits of a float, so colours and depths of a pixel hardly
// differ; but a pixel at the rim of a triangle may go to its neighbour, or to the background.
const RelevoTolerance Close{ 2, 2e-6, 10 };
}

int TestAdaptiveRefinementMapperTwin(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  auto compare = [&](const std::string& name, const RelevoComparison::Builder& build,
                   const std::vector<RelevoComparison::Step>& steps = {})
  { comparison.Compare("Twin." + name, Close, build, steps); };

  vtkNew<vtkPNTriangleSurface> quadratic;
  vtkNew<vtkPNTriangleSurface> linear;
  linear->QuadraticNormalsOff();
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(40, 30, 3);
  vtkNew<RelevoHeights> smooth;
  smooth->FillWaves();
  vtkNew<RelevoHeights> holes;
  holes->FillWavesWithHoles();

  auto displace = [](vtkHeightField* heights, double scale, double offset = 0.0)
  {
    auto displacement = vtkSmartPointer<vtkDisplacement>::New();
    displacement->SetHeightMap(heights);
    displacement->SetScale(scale);
    displacement->SetOffset(offset);
    return displacement;
  };
  auto displaceUp = [](vtkHeightField* heights, double scale)
  {
    auto displacement = vtkSmartPointer<vtkDisplacement>::New();
    displacement->SetHeightMap(heights);
    displacement->SetScale(scale);
    displacement->SetDirection(0.2, 0.1, 1);
    return displacement;
  };

  // Surfaces.
  const struct
  {
    const char* Name;
    vtkRefinementSurface* Surface;
  } surfaces[] = { { "Linear", nullptr }, { "Quadratic", quadratic }, { "LinearNormals", linear } };
  for (const auto& surface : surfaces)
  {
    const std::string name = surface.Name;
    compare(name + ".Uniform",
      [&](RelevoScene& s) { s.Add(Sphere(9, 7), MakeRecipe(3, surface.Surface)); });
    compare(name + ".Tagged",
      [&](RelevoScene& s) { s.Add(Tagged(Sphere(9, 7), 5), MakeRecipe(5, surface.Surface)); });
    compare(name + ".Coarse",
      [&](RelevoScene& s) { s.Add(Sphere(3, 3), MakeRecipe(4, surface.Surface)); });
    compare(name + ".TaggedFlat",
      [&](RelevoScene& s)
      {
        s.Add(Tagged(Sphere(9, 7), 4), MakeRecipe(4, surface.Surface))
          ->GetProperty()
          ->SetInterpolationToFlat();
      });
    compare(name + ".Cube",
      [&](RelevoScene& s) { s.Add(Tagged(Cube(), 5), MakeRecipe(5, surface.Surface)); });
    compare(name + ".Strips",
      [&](RelevoScene& s) { s.Add(Tagged(Strips(), 4), MakeRecipe(4, surface.Surface)); });
    compare(name + ".Mixed",
      [&](RelevoScene& s)
      {
        vtkProperty* property = s.Add(Mixed(), MakeRecipe(3, surface.Surface))->GetProperty();
        property->SetPointSize(8);
        property->SetLineWidth(4);
      });
    compare(name + ".BackfaceCulling",
      [&](RelevoScene& s)
      {
        s.Add(Tagged(Moebius(), 4), MakeRecipe(4, surface.Surface))
          ->GetProperty()
          ->BackfaceCullingOn();
      });
    compare(name + ".BackfaceProperty",
      [&](RelevoScene& s)
      {
        vtkNew<vtkProperty> back;
        back->SetColor(1, 0, 0);
        s.Add(Tagged(Moebius(), 4), MakeRecipe(4, surface.Surface))->SetBackfaceProperty(back);
      });
    compare(name + ".Edges",
      [&](RelevoScene& s)
      {
        vtkProperty* property =
          s.Add(Tagged(Sphere(9, 7), 3), MakeRecipe(3, surface.Surface))->GetProperty();
        property->EdgeVisibilityOn();
        property->SetLineWidth(2);
      });
    compare(name + ".ClippingPlane",
      [&](RelevoScene& s)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1, 0.3, 0.2);
        s.Add(Tagged(Sphere(9, 7), 4), MakeRecipe(4, surface.Surface))
          ->GetMapper()
          ->AddClippingPlane(plane);
      });
    compare(name + ".Points",
      [&](RelevoScene& s)
      {
        vtkProperty* property =
          s.Add(Tagged(Sphere(6, 5), 3), MakeRecipe(3, surface.Surface))->GetProperty();
        property->SetRepresentationToPoints();
        property->SetPointSize(3);
      });
  }

  // Vertices and lines of a refined mesh take the filter's normals.
  for (bool someAreZero : { false, true })
  {
    for (const auto& surface : surfaces)
    {
      compare(std::string(surface.Name) + (someAreZero ? ".ZeroNormals" : ".UnevenNormals"),
        [&](RelevoScene& s)
        {
          vtkProperty* property =
            s.Add(WithUnevenNormals(Mixed(), someAreZero), MakeRecipe(3, surface.Surface))
              ->GetProperty();
          property->SetPointSize(8);
          property->SetLineWidth(4);
        });
    }
  }

  // Displacements.
  for (const auto& surface : surfaces)
  {
    const std::string name = std::string("Displaced.") + surface.Name;
    compare(name + ".Smooth",
      [&](RelevoScene& s)
      {
        s.Add(
          Tagged(TexturedSphere(9, 7), 6), MakeRecipe(6, surface.Surface, displace(smooth, 0.08)));
      });
    compare(name + ".Rough",
      [&](RelevoScene& s)
      {
        s.Add(Tagged(TexturedSphere(9, 7), 5),
          MakeRecipe(5, surface.Surface, displace(rough, 0.1, -0.05)));
      });
    compare(name + ".Direction",
      [&](RelevoScene& s)
      { s.Add(Tagged(Plane(3, 4), 6), MakeRecipe(6, surface.Surface, displaceUp(rough, 0.2))); });
    compare(name + ".SplitNormals",
      [&](RelevoScene& s)
      { s.Add(Tagged(Cube(), 5), MakeRecipe(5, surface.Surface, displace(rough, 0.1))); });
    compare(name + ".OffsetOnly",
      [&](RelevoScene& s)
      {
        s.Add(Tagged(TexturedSphere(9, 7), 4),
          MakeRecipe(4, surface.Surface, displace(nullptr, 1, 0.2)));
      });
    compare(name + ".Textured",
      [&](RelevoScene& s)
      {
        s.Add(
           Tagged(TexturedSphere(9, 7), 5), MakeRecipe(5, surface.Surface, displace(smooth, 0.1)))
          ->SetTexture(Stripes());
      });
    compare(name + ".Transformed",
      [&](RelevoScene& s)
      {
        vtkActor* actor =
          s.Add(Tagged(Cube(), 4), MakeRecipe(4, surface.Surface, displace(smooth, 0.1)));
        actor->RotateX(20);
        actor->SetScale(1, 2, -0.7);
      });
    compare(name + ".FarAway",
      [&](RelevoScene& s)
      {
        const double offset[3] = { 5e6, -4e6, 100 };
        s.Add(Tagged(Moved(TexturedSphere(9, 7), 100, offset, VTK_DOUBLE), 5),
          MakeRecipe(5, surface.Surface, displace(smooth, 20)));
      });
  }
  compare("Displaced.Flat",
    [&](RelevoScene& s)
    {
      s.Add(Tagged(TexturedSphere(9, 7), 4), MakeRecipe(4, quadratic, displace(smooth, 0.1)))
        ->GetProperty()
        ->SetInterpolationToFlat();
    });
  compare("Displaced.Translucent",
    [&](RelevoScene& s)
    {
      s.Renderer->UseDepthPeelingOn();
      s.Renderer->SetMaximumNumberOfPeels(20);
      s.Add(Tagged(TexturedSphere(9, 7), 4), MakeRecipe(4, quadratic, displace(smooth, 0.1)))
        ->GetProperty()
        ->SetOpacity(0.5);
    });

  // Attributes.
  auto withScalars = [](Mesh mesh, bool ofCells)
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
  };
  for (bool ofCells : { false, true })
  {
    for (bool interpolated : { false, true })
    {
      const std::string name = std::string("Scalars.") + (ofCells ? "Cells" : "Points") +
        (interpolated ? ".Interpolated" : "");
      compare(name,
        [&](RelevoScene& s)
        {
          vtkActor* actor =
            s.Add(withScalars(Tagged(Sphere(9, 7), 4), ofCells), MakeRecipe(4, quadratic));
          actor->GetMapper()->SetScalarRange(1, 9);
          actor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolated);
        });
      compare(name + ".Bands",
        [&](RelevoScene& s)
        {
          vtkNew<vtkLookupTable> table;
          table->SetNumberOfTableValues(4);
          table->SetTableRange(0, 10);
          table->Build();
          vtkActor* actor =
            s.Add(withScalars(Tagged(Cube(), 4), ofCells), MakeRecipe(4, quadratic));
          actor->GetMapper()->SetLookupTable(table);
          actor->GetMapper()->UseLookupTableScalarRangeOn();
          actor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolated);
          actor->GetProperty()->LightingOff();
        });
      compare(name + ".Translucent",
        [&](RelevoScene& s)
        {
          s.Renderer->UseDepthPeelingOn();
          vtkActor* actor =
            s.Add(withScalars(Tagged(Strips(), 4), ofCells), MakeRecipe(4, quadratic));
          actor->GetMapper()->SetScalarRange(1, 9);
          actor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolated);
          actor->GetProperty()->SetOpacity(0.5);
        });
    }
  }
  compare("CellScalars.Mixed",
    [&](RelevoScene& s)
    {
      vtkActor* actor = s.Add(withScalars(Mixed(), true), MakeRecipe(2));
      actor->GetMapper()->SetScalarRange(0, 10);
      actor->GetProperty()->SetPointSize(8);
      actor->GetProperty()->SetLineWidth(4);
    });
  compare("DirectColors",
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
      s.Add(mesh, MakeRecipe(4, linear));
    });

  // Views.
  vtkNew<vtkDistanceDepthTagMetric> distance;
  auto nearby = MakeRecipe(6, quadratic);
  nearby->SetMetric(distance);
  compare("Distance",
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

  // Composite data: the twin's is one whole, so blocks do not touch.
  vtkNew<vtkMultiBlockDataSet> blocks;
  const double aside[3] = { 1.5, 0.3, 0.0 };
  blocks->SetBlock(1, Tagged(TexturedSphere(8, 6), 4));
  blocks->SetBlock(3, Tagged(Moved(TexturedSphere(6, 5), 1, aside, VTK_FLOAT), 4));
  compare("Blocks",
    [&](RelevoScene& s) { s.Add(blocks, MakeRecipe(4, quadratic, displace(rough, 0.1))); });

  // Without data: rims of holes go through pixels, not triangles.
  RelevoTolerance rims = Close;
  rims.Pixels = 45;
  const auto withHoles = [&](RelevoScene& s)
  { s.Add(Tagged(Plane(3, 4), 6), MakeRecipe(6, nullptr, displaceUp(holes, 0.1))); };
  comparison.Compare("Twin.Displaced.Holes", rims, withHoles);
  return check.GetResult();
}
