// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveLICMapper promises how it combines the LIC with the surface's colours. The formulae
// are applied to pictures of the LIC alone and of the colours alone.
#include "RelevoLICView.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace
{
using namespace RelevoMeshes;
using Color = RelevoLICView::Color;

Mesh Colored()
{
  Mesh mesh = Torus();
  mesh->SetLines(nullptr); // lines of the seams, which have no LIC
  mesh->SetVerts(nullptr);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<double>((i * 37) % 11));
  }
  mesh->GetPointData()->SetScalars(values);
  RelevoLICVectors::AddVectors(mesh, RelevoLICVectors::Screw);
  return mesh;
}

RelevoLICView MakeView(vtkPolyData* mesh)
{
  RelevoLICView view;
  view.Scene->Window->SetSize(200, 150);
  view.Add(mesh, MakeRecipe(2));
  view.Mapper->SetScalarRange(0, 10);
  view.Scene->ResetCameras();
  return view;
}

double Lightness(const Color& c)
{
  return 0.5 * (*std::min_element(c.begin(), c.end()) + *std::max_element(c.begin(), c.end()));
}

// The low and high factors define m and M, which are mapped to 0 and 1.
double Stretch(double value, const std::array<double, 2>& range, double low, double high)
{
  const double width = range[1] - range[0];
  const double from = range[0] + low * width;
  const double to = range[1] - high * width;
  return vtkMath::ClampValue((value - from) / (to - from), 0.0, 1.0);
}

// A colour with the same hue and saturation, but another lightness.
Color WithLightness(const Color& color, double lightness)
{
  double hsl[3];
  const double old = Lightness(color);
  const double chroma =
    *std::max_element(color.begin(), color.end()) - *std::min_element(color.begin(), color.end());
  hsl[1] = chroma > 0.0 ? chroma / (1.0 - std::abs(2.0 * old - 1.0)) : 0.0;
  const double newChroma = hsl[1] * (1.0 - std::abs(2.0 * lightness - 1.0));
  Color result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] = lightness + (chroma > 0.0 ? (color[i] - old) / chroma * newChroma : 0.0);
  }
  return result;
}

// Whether the pixel shows a surface with LIC.
bool HasLIC(const RelevoPicture& lic, size_t pixel)
{
  return lic.Depths[pixel] < 1.0f && !RelevoLICView::IsMasked(RelevoLICView::At(lic, pixel));
}

size_t CountLIC(const RelevoPicture& lic)
{
  size_t count = 0;
  for (size_t i = 0; i < lic.GetNumberOfPixels(); ++i)
  {
    count += HasLIC(lic, i) ? 1 : 0;
  }
  return count;
}

// Range over the pixels with LIC.
std::array<double, 2> FindRange(
  const RelevoPicture& lic, const std::function<double(size_t)>& getValue)
{
  std::array<double, 2> range{ { 1.0, 0.0 } };
  for (size_t i = 0; i < lic.GetNumberOfPixels(); ++i)
  {
    if (HasLIC(lic, i))
    {
      const double value = getValue(i);
      range = { { std::min(range[0], value), std::max(range[1], value) } };
    }
  }
  return range;
}

std::array<double, 2> FindRange(const RelevoPicture& lic)
{
  return FindRange(lic, [&lic](size_t i) { return RelevoLICView::At(lic, i)[0]; });
}

void TestGreys(RelevoCheck& check, RelevoLICView& view)
{
  const RelevoPicture lic = view.DrawLIC();
  CHECK_GREATER(CountLIC(lic), 5000);
  const std::array<double, 2> range = FindRange(lic);
  CHECK_GREATER(range[1] - range[0], 0.2);
}

void TestBlend(RelevoComparison& comparison, RelevoLICView& view)
{
  for (const double intensity : { 0.0, 0.3, 0.8, 1.0 })
  {
    view.Mapper->SetLICIntensity(intensity);
    view.Compare(comparison, "LICColors.Blend" + std::to_string(intensity),
      { intensity == 0.0 ? 0 : 2, 0.0, 0 },
      [intensity](const Color& color, double value) {
        return RelevoLICView::Mix(color, Color{ { value, value, value } }, intensity);
      });
  }
}

void TestMultiply(RelevoComparison& comparison, RelevoLICView& view)
{
  view.Mapper->SetColorModeToMultiply();
  for (const double bias : { 0.0, 0.4, -0.3, 1.0 })
  {
    view.Mapper->SetMapModeBias(bias);
    view.Compare(comparison, "LICColors.Multiply" + std::to_string(bias),
      { bias == 1.0 ? 0 : 2, 0.0, 0 },
      [bias](const Color& color, double value)
      {
        return RelevoLICView::Mix(
          Color{ { 0, 0, 0 } }, color, vtkMath::ClampValue(value + bias, 0.0, 1.0));
      });
  }
  view.Mapper->SetMapModeBias(0.0);
}

// Lightness is stretched in both modes, by the range over pixels with LIC.
void TestLightnessContrast(
  RelevoComparison& comparison, RelevoLICView& view, int mode, double factor)
{
  view.Mapper->GetLICInterface()->SetColorMode(mode);
  view.Mapper->SetLICIntensity(0.5);
  view.Mapper->SetLowColorContrastEnhancementFactor(factor);
  view.Mapper->SetHighColorContrastEnhancementFactor(0.5 * factor);
  const auto combine = [mode](const Color& color, double value)
  {
    return mode == 0 ? RelevoLICView::Mix(color, Color{ { value, value, value } }, 0.5)
                     : RelevoLICView::Mix(Color{ { 0, 0, 0 } }, color, value);
  };
  const RelevoPicture colors = view.DrawColors();
  const RelevoPicture greys = view.DrawLIC();
  const std::array<double, 2> lightness = FindRange(greys,
    [&](size_t i)
    { return Lightness(combine(RelevoLICView::At(colors, i), RelevoLICView::At(greys, i)[0])); });
  view.Compare(comparison, "LICColors.Lightness" + std::to_string(mode) + std::to_string(factor),
    { 8, 0.0, 0 },
    [&](const Color& color, double value)
    {
      const Color combined = combine(color, value);
      return WithLightness(combined, Stretch(Lightness(combined), lightness, factor, 0.5 * factor));
    });
}

void TestLightnessContrasts(RelevoComparison& comparison, RelevoLICView& view)
{
  view.Mapper->SetEnhanceContrastToColor();
  for (const int mode : { 0, 1 })
  {
    for (const double factor : { 0.0, 0.2 })
    {
      TestLightnessContrast(comparison, view, mode, factor);
    }
  }
  view.Mapper->SetEnhanceContrastToOff();
}

void TestLICContrast(RelevoComparison& comparison)
{
  RelevoLICView view = MakeView(Colored());
  view.Mapper->EnhancedLICOff();
  const RelevoPicture plain = view.DrawLIC();
  const std::array<double, 2> range = FindRange(plain);
  view.Mapper->SetEnhanceContrastToLIC();
  for (const double factor : { 0.0, 0.25 })
  {
    view.Mapper->SetLowLICContrastEnhancementFactor(0.5 * factor);
    view.Mapper->SetHighLICContrastEnhancementFactor(factor);
    RelevoPicture expected = plain;
    for (size_t i = 0; i < plain.GetNumberOfPixels(); ++i)
    {
      if (HasLIC(plain, i))
      {
        std::fill_n(&expected.Colors[3 * i], 3,
          static_cast<unsigned char>(std::lround(
            255.0 * Stretch(RelevoLICView::At(plain, i)[0], range, 0.5 * factor, factor))));
      }
    }
    comparison.Compare(
      "LICColors.Contrast" + std::to_string(factor), { 4, 0.0, 0 }, view.DrawLIC(), expected);
  }
}

void TestMasks(RelevoComparison& comparison)
{
  const auto field = [](const double* p) {
    return std::array<double, 3>{ { 0.0, p[0] > 0.0 ? 1.0 : 0.0, 0.0 } };
  };
  for (const double intensity : { 0.0, 0.6, 1.0 })
  {
    Mesh mesh = Colored();
    RelevoLICVectors::AddVectors(mesh, field, "Half");
    RelevoLICView view = MakeView(mesh);
    view.Mapper->SetMaskColor(0.1, 0.9, 0.4);
    view.Mapper->SetMaskIntensity(intensity);
    view.Compare(
      comparison, "LICColors.Mask" + std::to_string(intensity), { 2, 0.0, 0 },
      [](const Color& color, double value) {
        return RelevoLICView::Mix(color, Color{ { value, value, value } }, 0.8);
      },
      [intensity](const Color& color, double) {
        return RelevoLICView::Mix(color, Color{ { 0.1, 0.9, 0.4 } }, intensity);
      });
  }
}

// A square of side 2 that fills the picture. Vectors have length 1 + x and are tilted by 60
// degrees.
RelevoLICView MakeSquareView()
{
  Mesh mesh = Plane(8, 8);
  const double origin[3] = { 0, 0, 0 };
  mesh = Moved(mesh, 2.0, origin, VTK_FLOAT);
  RelevoLICVectors::AddVectors(mesh,
    [](const double* p)
    {
      const double length = 1.0 + p[0];
      return std::array<double, 3>{ { 0.0, 0.5 * length, std::sqrt(0.75) * length } };
    });
  RelevoLICView view = MakeView(mesh);
  view.LookDown(1.0, 200);
  return view;
}

// The length of the vectors at the border of the LIC.
double FindBorder(RelevoLICView& view)
{
  const RelevoPicture lic = view.DrawLIC();
  int first = 0;
  while (first < 200 &&
    RelevoLICView::IsMasked(RelevoLICView::At(lic, static_cast<size_t>(100 * 200 + first))))
  {
    ++first;
  }
  return 0.01 * first;
}

// Pixels are masked by the length of vectors, or of their projections.
void TestThreshold(RelevoCheck& check)
{
  RelevoLICView view = MakeSquareView();
  CHECK_NEAR(FindBorder(view), 0.0, 0.011);
  view.Mapper->SetMaskThreshold(0.7);
  CHECK_NEAR(FindBorder(view), 0.7, 0.011);
  view.Mapper->MaskOnSurfaceOn();
  CHECK_NEAR(FindBorder(view), 1.4, 0.011);
  view.Mapper->SetMaskThreshold(1.5);
  CHECK_NEAR(FindBorder(view), 2.0, 1e-9);
  view.Mapper->SetMaskThreshold(-1.0);
  CHECK_NEAR(FindBorder(view), 0.0, 1e-9);
}
}

int TestAdaptiveLICMapperColors(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);

  RelevoLICView view = MakeView(Colored());
  TestGreys(check, view);
  TestBlend(comparison, view);
  TestMultiply(comparison, view);
  TestLightnessContrasts(comparison, view);
  TestLICContrast(comparison);
  TestMasks(comparison);
  TestThreshold(check);
  return check.GetResult();
}
