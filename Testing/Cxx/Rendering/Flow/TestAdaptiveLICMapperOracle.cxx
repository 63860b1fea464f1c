// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that on a plane that faces the camera, with one point per pixel, vtkAdaptiveLICMapper
// gives the result of vtkLineIntegralConvolution for the same vectors.
#include "RelevoLICScene.h"

#include "vtkLICNoiseSource.h"

#include <iostream>

namespace
{
constexpr int Columns = 256;
constexpr int Rows = 192;

// Fields around (0, 0). The lower and upper borders are at -1 and 1.
RelevoField InPixels(const RelevoField& field, double factor = 1.0)
{
  return [=](double x, double y, double* v)
  {
    field((x - 0.5 * Columns) / (0.5 * Rows), (y - 0.5 * Rows) / (0.5 * Rows), v);
    v[0] *= factor;
    v[1] *= factor;
  };
}

// A setting with the same name in both classes.
struct Setting
{
  std::string Name;
  std::function<void(vtkAdaptiveLICMapper*)> SetMapper;
  std::function<void(vtkLineIntegralConvolution*)> SetFilter;
};

template <typename Function>
Setting MakeSetting(const std::string& name, const Function& set)
{
  return { name, set, set };
}

const std::vector<Setting> Defaults = { MakeSetting("defaults", [](auto*) {}) };

std::vector<Setting> MakeSettings()
{
  return { MakeSetting("defaults", [](auto*) {}),
    MakeSetting("plain", [](auto* lic) { lic->EnhancedLICOff(); }),
    MakeSetting("contrast", [](auto* lic) { lic->SetEnhanceContrastToLIC(); }),
    MakeSetting("cut contrast",
      [](auto* lic)
      {
        lic->SetEnhanceContrastToLIC();
        lic->SetLowLICContrastEnhancementFactor(0.1);
        lic->SetHighLICContrastEnhancementFactor(0.2);
      }),
    MakeSetting("anti-alias", [](auto* lic) { lic->SetAntiAlias(2); }),
    MakeSetting("oriented", [](auto* lic) { lic->OrientedLICOn(); }),
    MakeSetting("phase", [](auto* lic) { lic->SetPhase(0.3); }),
    MakeSetting("longer steps", [](auto* lic) { lic->SetStepSize(1.7); }),
    MakeSetting("few steps", [](auto* lic) { lic->SetNumberOfSteps(3); }),
    MakeSetting("not normalised", [](auto* lic) { lic->NormalizeVectorsOff(); }),
    MakeSetting("masked where slow", [](auto* lic) { lic->SetMaskThreshold(0.8); }) };
}

class Oracle
{
public:
  Oracle(RelevoCheck& check, const std::string& name, const RelevoField& field, int spacing = 1)
    : Check(check)
    , Name(name)
  {
    this->Mapper = this->Scene.Add(MakePixelMesh(Columns, Rows, spacing, field));
    this->Scene.LookAtPixels();
    this->Filter->SetInputData(MakeFlowImage(Columns, Rows, field));
  }

  void Set(const Setting& setting)
  {
    setting.SetMapper(this->Mapper);
    setting.SetFilter(this->Filter);
    this->Name += ", " + setting.Name;
  }

  // At most the given share of pixels may differ by more than rounding, or have LIC in only one of
  // both.
  void Compare(double different, double oneSided = 0.0)
  {
    RelevoGrey expected = GreyOf(RunLIC(this->Filter), Columns);
    const std::vector<double> mask = ValuesOf(this->Filter->GetOutput(), "LICMask");
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      expected.Values[i] = mask[i] != 0.0 ? VTK_DOUBLE_MAX : expected.Values[i];
    }
    const RelevoLikeness likeness = CompareLIC(this->Scene.Render().Grey, expected);
    std::cout << this->Name << ": " << likeness << "\n";
    RelevoCheck& check = this->Check;
    CHECK_GREATER(likeness.Count, Columns * Rows / 5);
    CHECK_GREATER_EQUAL(likeness.SSIM, 0.99);
    CHECK_LESS_EQUAL(likeness.MeanDifference, 0.5 / 255.0 + 0.03 * different);
    CHECK_LESS_EQUAL(likeness.Different, different * likeness.Count);
    CHECK_LESS_EQUAL(likeness.OneSided, oneSided * likeness.Count);
  }

  RelevoCheck& Check;
  std::string Name;
  RelevoLICScene Scene{ Columns, Rows };
  vtkAdaptiveLICMapper* Mapper = nullptr;
  vtkNew<vtkLineIntegralConvolution> Filter;
};

// At the borders of texels, a float's last bits decide which noise is used and how a streamline
// passes a singular point.
void TestSettings(RelevoCheck& check)
{
  for (const RelevoNamedField& field : MakeNamedFields())
  {
    const bool isCurved = field.Name == "vortex" || field.Name == "dipole";
    for (const Setting& setting : isCurved ? MakeSettings() : Defaults)
    {
      Oracle oracle(check, field.Name, InPixels(field.Field));
      oracle.Set(setting);
      // Long steps jump over the dipole's poles, and the longer lines of an animation do so more
      // often.
      oracle.Compare(setting.Name == "not normalised" ? 0.15
          : setting.Name == "phase"                   ? 0.06
                                                      : 0.01);
    }
  }
}

// Streamlines end at slightly different points beside missing data: where the nearest sample is
// missing, or half of the bilinear weight.
void TestNoData(RelevoCheck& check)
{
  const double holes[3] = { -1e9, std::nan(""), 0.0 };
  for (double hole : holes)
  {
    const RelevoField vortex = InPixels(MakeNamedFields()[1].Field);
    const RelevoField field = [=](double x, double y, double* v)
    {
      vortex(x, y, v);
      if (std::hypot(x - 70.0, y - 60.0) < 20.0 || std::abs(x - 180.0) < 5.0)
      {
        v[0] = v[1] = hole;
      }
    };
    Oracle oracle(check, "no-data " + std::to_string(hole), field);
    // If a zero lies exactly at a pixel's centre, rounding gives its neighbours a LIC.
    oracle.Compare(hole == 0.0 ? 0.06 : 0.01, hole == 0.0 ? 0.006 : 0.0);
  }
}

void TestNoise(RelevoCheck& check)
{
  Oracle oracle(check, "another noise", InPixels(MakeNamedFields()[3].Field));
  const auto noise = MakeNoiseImage(37, 53);
  oracle.Mapper->SetNoiseDataSet(noise);
  oracle.Filter->SetNoiseData(noise);
  oracle.Compare(0.01);

  vtkNew<vtkLICNoiseSource> source;
  source->SetNoiseTypeToPerlin();
  source->SetNoiseGrainSize(8);
  source->SetNoiseTextureSize(64);
  source->SetNoiseGeneratorSeed(4);
  oracle.Name = "Perlin noise";
  oracle.Mapper->SetNoiseDataSet(nullptr);
  oracle.Mapper->SetNoiseType(vtkAdaptiveLICMapper::NOISE_TYPE_PERLIN);
  oracle.Mapper->SetNoiseGrainSize(8);
  oracle.Mapper->SetNoiseTextureSize(64);
  oracle.Mapper->SetNoiseGeneratorSeed(4);
  oracle.Filter->SetInputConnection(1, source->GetOutputPort());
  oracle.Compare(0.01);
}

// Linear fields are the same on a coarse mesh and on its refinement.
void TestRefined(RelevoCheck& check)
{
  Oracle coarse(check, "coarse saddle", InPixels(MakeNamedFields()[2].Field), 32);
  coarse.Compare(0.01);
  coarse.Mapper->SetRefinement(RelevoMeshes::MakeRecipe(3));
  coarse.Name = "refined saddle";
  coarse.Compare(0.01);
}
}

int TestAdaptiveLICMapperOracle(int, char*[])
{
  RelevoCheck check;
  TestSettings(check);
  TestNoData(check);
  TestNoise(check);
  TestRefined(check);
  return check.GetResult();
}
