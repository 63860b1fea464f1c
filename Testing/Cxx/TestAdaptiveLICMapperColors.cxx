// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// How vtkAdaptiveLICMapper combines its LIC with the colours of the surface: against the formulae,
// from pictures of the LIC alone and of the colours alone.
#include "RelevoLICVectors.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkTriangleFilter.h"

#include <array>

namespace
{
using namespace RelevoMeshes;
using Color = std::array<double, 3>;
using Formula = std::function<Color(const Color& color, double lic)>;

Mesh Colored()
{
  Mesh mesh = Torus();
  mesh->SetLines(nullptr); // of its seams: no faces, no LIC
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

// A torus; colours and light are turned off to see the LIC alone.
struct View
{
  RelevoScene Scene{ RelevoScene::Refining };
  vtkActor* Actor;
  vtkAdaptiveLICMapper* Mapper;

  explicit View(vtkPolyData* mesh)
  {
    this->Actor = this->Scene.Add(mesh, MakeRecipe(2));
    this->Mapper = RelevoLICVectors::GetMapper(this->Actor);
    this->Mapper->SetScalarRange(0, 10);
    this->Scene.Window->SetSize(200, 150);
    this->Scene.ResetCameras();
  }

  RelevoPicture Draw()
  {
    this->Scene.Render();
    return RelevoPicture(this->Scene.Window);
  }

  RelevoPicture DrawColors()
  {
    this->Mapper->EnableOff();
    RelevoPicture picture = this->Draw();
    this->Mapper->EnableOn();
    return picture;
  }

  // Red where it is masked.
  RelevoPicture DrawLIC()
  {
    const double intensity = this->Mapper->GetLICIntensity();
    const double maskIntensity = this->Mapper->GetMaskIntensity();
    const int mode = this->Mapper->GetColorMode();
    const int contrast = this->Mapper->GetEnhanceContrast();
    const Color maskColor{ { this->Mapper->GetMaskColor()[0], this->Mapper->GetMaskColor()[1],
      this->Mapper->GetMaskColor()[2] } };
    this->Mapper->ScalarVisibilityOff();
    this->Mapper->SetLICIntensity(1.0);
    this->Mapper->SetMaskIntensity(1.0);
    this->Mapper->SetMaskColor(1, 0, 0);
    this->Mapper->SetColorModeToBlend();
    if (contrast == vtkAdaptiveLICMapper::ENHANCE_CONTRAST_COLOR)
    {
      this->Mapper->SetEnhanceContrastToOff();
    }
    this->Actor->GetProperty()->LightingOff();
    RelevoPicture picture = this->Draw();
    this->Mapper->ScalarVisibilityOn();
    this->Mapper->SetLICIntensity(intensity);
    this->Mapper->SetMaskIntensity(maskIntensity);
    this->Mapper->SetMaskColor(maskColor.data());
    this->Mapper->SetColorMode(mode);
    this->Mapper->SetEnhanceContrast(contrast);
    this->Actor->GetProperty()->LightingOn();
    return picture;
  }
};

Color At(const RelevoPicture& picture, size_t pixel)
{
  return { { picture.Colors[3 * pixel] / 255.0, picture.Colors[3 * pixel + 1] / 255.0,
    picture.Colors[3 * pixel + 2] / 255.0 } };
}

bool IsMasked(const Color& lic)
{
  return lic[0] != lic[1];
}

Color Mix(const Color& a, const Color& b, double share)
{
  Color result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] = a[i] * (1.0 - share) + b[i] * share;
  }
  return result;
}

double Lightness(const Color& c)
{
  return 0.5 * (*std::min_element(c.begin(), c.end()) + *std::max_element(c.begin(), c.end()));
}

// m and M of the low and the high factor become 0 and 1.
double Stretch(double value, const std::array<double, 2>& range, double low, double high)
{
  const double width = range[1] - range[0];
  const double from = range[0] + low * width;
  const double to = range[1] - high * width;
  return vtkMath::ClampValue((value - from) / (to - from), 0.0, 1.0);
}

// Hue and saturation of a colour with another lightness.
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
}

int TestAdaptiveLICMapperColors(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  RelevoScene::NewMapper = RelevoLICVectors::NewVisible;

  // Draw the view, and compare with what the formulae make of LIC and colours.
  auto compare = [&](const std::string& name, View& view, int tolerance, const Formula& formula,
                   const Formula& ofMasked = nullptr)
  {
    const RelevoPicture colors = view.DrawColors();
    const RelevoPicture lic = view.DrawLIC();
    const RelevoPicture actual = view.Draw();
    RelevoPicture expected = colors;
    size_t masked = 0;
    size_t shown = 0;
    for (size_t i = 0; i < colors.GetNumberOfPixels(); ++i)
    {
      if (colors.Depths[i] < 1.0f)
      {
        const Color grey = At(lic, i);
        const Color color = At(colors, i);
        const Color result = !IsMasked(grey) ? formula(color, grey[0])
          : ofMasked                         ? ofMasked(color, 0.0)
                                             : color;
        ++(IsMasked(grey) ? masked : shown);
        for (int c = 0; c < 3; ++c)
        {
          expected.Colors[3 * i + c] = static_cast<unsigned char>(
            std::lround(255.0 * vtkMath::ClampValue(result[c], 0.0, 1.0)));
        }
      }
    }
    if (shown < 2000 || (ofMasked && masked < 1000))
    {
      check.Fail(__FILE__, __LINE__, name + ": too little to see");
    }
    comparison.Compare("LICColors." + name, { tolerance, 0.0, 0 }, actual, expected);
  };

  {
    View view(Colored());
    const RelevoPicture lic = view.DrawLIC();
    size_t grey = 0;
    std::array<double, 2> range{ { 1.0, 0.0 } };
    for (size_t i = 0; i < lic.GetNumberOfPixels(); ++i)
    {
      if (lic.Depths[i] < 1.0f && !IsMasked(At(lic, i)))
      {
        ++grey;
        range = { { std::min(range[0], At(lic, i)[0]), std::max(range[1], At(lic, i)[0]) } };
      }
    }
    CHECK(grey > 5000);
    CHECK(range[1] - range[0] > 0.2);

    for (const double intensity : { 0.0, 0.3, 0.8, 1.0 })
    {
      view.Mapper->SetLICIntensity(intensity);
      compare("Blend" + std::to_string(intensity), view, intensity == 0.0 ? 0 : 2,
        [intensity](const Color& color, double value) {
          return Mix(color, Color{ { value, value, value } }, intensity);
        });
    }
    view.Mapper->SetColorModeToMultiply();
    for (const double bias : { 0.0, 0.4, -0.3, 1.0 })
    {
      view.Mapper->SetMapModeBias(bias);
      compare("Multiply" + std::to_string(bias), view, bias == 1.0 ? 0 : 2,
        [bias](const Color& color, double value) {
          return Mix(Color{ { 0, 0, 0 } }, color, vtkMath::ClampValue(value + bias, 0.0, 1.0));
        });
    }
    view.Mapper->SetMapModeBias(0.0);

    // Lightness stretched, of either mode; the range is that of pixels with LIC.
    view.Mapper->SetEnhanceContrastToColor();
    for (const int mode : { 0, 1 })
    {
      for (const double factor : { 0.0, 0.2 })
      {
        view.Mapper->SetColorMode(mode);
        view.Mapper->SetLICIntensity(0.5);
        view.Mapper->SetLowColorContrastEnhancementFactor(factor);
        view.Mapper->SetHighColorContrastEnhancementFactor(0.5 * factor);
        const auto combine = [mode](const Color& color, double value)
        {
          return mode == 0 ? Mix(color, Color{ { value, value, value } }, 0.5)
                           : Mix(Color{ { 0, 0, 0 } }, color, value);
        };
        const RelevoPicture colors = view.DrawColors();
        const RelevoPicture greys = view.DrawLIC();
        std::array<double, 2> lightness{ { 1.0, 0.0 } };
        for (size_t i = 0; i < colors.GetNumberOfPixels(); ++i)
        {
          if (colors.Depths[i] < 1.0f && !IsMasked(At(greys, i)))
          {
            const double l = Lightness(combine(At(colors, i), At(greys, i)[0]));
            lightness = { { std::min(lightness[0], l), std::max(lightness[1], l) } };
          }
        }
        compare("Lightness" + std::to_string(mode) + std::to_string(factor), view, 8,
          [&](const Color& color, double value)
          {
            const Color combined = combine(color, value);
            return WithLightness(
              combined, Stretch(Lightness(combined), lightness, factor, 0.5 * factor));
          });
      }
    }
    view.Mapper->SetEnhanceContrastToOff();
  }

  // The LIC's own contrast.
  {
    View view(Colored());
    view.Mapper->EnhancedLICOff();
    const RelevoPicture plain = view.DrawLIC();
    std::array<double, 2> range{ { 1.0, 0.0 } };
    for (size_t i = 0; i < plain.GetNumberOfPixels(); ++i)
    {
      if (plain.Depths[i] < 1.0f && !IsMasked(At(plain, i)))
      {
        range = { { std::min(range[0], At(plain, i)[0]), std::max(range[1], At(plain, i)[0]) } };
      }
    }
    view.Mapper->SetEnhanceContrastToLIC();
    for (const double factor : { 0.0, 0.25 })
    {
      view.Mapper->SetLowLICContrastEnhancementFactor(0.5 * factor);
      view.Mapper->SetHighLICContrastEnhancementFactor(factor);
      RelevoPicture expected = plain;
      for (size_t i = 0; i < plain.GetNumberOfPixels(); ++i)
      {
        if (plain.Depths[i] < 1.0f && !IsMasked(At(plain, i)))
        {
          std::fill_n(&expected.Colors[3 * i], 3,
            static_cast<unsigned char>(
              std::lround(255.0 * Stretch(At(plain, i)[0], range, 0.5 * factor, factor))));
        }
      }
      comparison.Compare(
        "LICColors.Contrast" + std::to_string(factor), { 4, 0.0, 0 }, view.DrawLIC(), expected);
    }
  }

  // Masks: by the length of vectors, or of their projections.
  {
    const auto field = [](const double* p) {
      return std::array<double, 3>{ { 0.0, p[0] > 0.0 ? 1.0 : 0.0, 0.0 } };
    };
    for (const double intensity : { 0.0, 0.6, 1.0 })
    {
      Mesh mesh = Colored();
      RelevoLICVectors::AddVectors(mesh, field, "Half");
      View view(mesh);
      view.Mapper->SetMaskColor(0.1, 0.9, 0.4);
      view.Mapper->SetMaskIntensity(intensity);
      compare(
        "Mask" + std::to_string(intensity), view, 2,
        [](const Color& color, double value) {
          return Mix(color, Color{ { value, value, value } }, 0.8);
        },
        [intensity](const Color& color, double) {
          return Mix(color, Color{ { 0.1, 0.9, 0.4 } }, intensity);
        });
    }
  }
  {
    // A square of side 2 that fills the picture; vectors are 1 + x long, and slanted by 60 degrees.
    Mesh mesh = Plane(8, 8);
    const double origin[3] = { 0, 0, 0 };
    mesh = Moved(mesh, 2.0, origin, VTK_FLOAT);
    RelevoLICVectors::AddVectors(mesh,
      [](const double* p)
      {
        const double length = 1.0 + p[0];
        return std::array<double, 3>{ { 0.0, 0.5 * length, std::sqrt(0.75) * length } };
      });
    View view(mesh);
    vtkCamera* camera = view.Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetPosition(0, 0, 5);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 1, 0);
    camera->SetParallelScale(1.0);
    view.Scene.Renderer->ResetCameraClippingRange();
    view.Scene.Window->SetSize(200, 200);
    const auto findBorder = [&view]()
    {
      const RelevoPicture lic = view.DrawLIC();
      int first = 0;
      while (first < 200 && IsMasked(At(lic, static_cast<size_t>(100 * 200 + first))))
      {
        ++first;
      }
      return 0.01 * first; // length of the vectors there
    };
    CHECK_NEAR(findBorder(), 0.0, 0.011);
    view.Mapper->SetMaskThreshold(0.7);
    CHECK_NEAR(findBorder(), 0.7, 0.011);
    view.Mapper->MaskOnSurfaceOn();
    CHECK_NEAR(findBorder(), 1.4, 0.011);
    view.Mapper->SetMaskThreshold(1.5);
    CHECK_NEAR(findBorder(), 2.0, 1e-9);
    view.Mapper->SetMaskThreshold(-1.0);
    CHECK_NEAR(findBorder(), 0.0, 1e-9);
  }
  return check.GetResult();
}
