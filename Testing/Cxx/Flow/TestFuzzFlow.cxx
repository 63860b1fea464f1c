// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random calls of the public classes of FiltersFlow, on random images and meshes,
// neither crash nor give LIC values or masks out of range.
#include "RelevoCheck.h"
#include "RelevoFuzzImages.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkLICNoiseSource.h"
#include "vtkLineIntegralConvolution.h"
#include "vtkPointData.h"
#include "vtkSurfaceLineIntegralConvolution.h"

#include <cmath>
#include <sstream>

namespace
{
using RelevoFuzz::Call;
using RelevoFuzz::Dice;

class Machine
{
public:
  explicit Machine(Dice& dice)
    : D(dice)
  {
    this->Flat->SetInputData(RelevoFuzz::MakeImage(this->D));
    this->Surface->SetInputData(RelevoFuzz::MakeMesh(this->D));
    this->Noise->SetNoiseTextureSize(8);
  }

  std::vector<Call> GetCalls()
  {
    std::vector<Call> calls = {
      { "image", [this] { this->Flat->SetInputData(RelevoFuzz::MakeImage(this->D)); } },
      { "mesh", [this] { this->Surface->SetInputData(RelevoFuzz::MakeMesh(this->D)); } },
      { "noise", [this] { this->SetNoise(); } }, { "print", [this] { this->Print(); } },
      { "array",
        [this]
        {
          vtkAlgorithm* filter = this->D.Once(2) ? static_cast<vtkAlgorithm*>(this->Flat)
                                                 : static_cast<vtkAlgorithm*>(this->Surface);
          filter->SetInputArrayToProcess(
            0, 0, 0, this->D.Throw(3), RelevoFuzz::ChooseName(this->D).c_str());
        } }
    };
    this->AddSettings(calls);
    for (int i = 0; i < 4; ++i)
    {
      calls.push_back({ "update flat", [this] { this->Flat->Update(); } });
      calls.push_back({ "update surface", [this] { this->Surface->Update(); } });
      calls.push_back({ "update noise", [this] { this->Noise->Update(); } });
    }
    return calls;
  }

  std::string FindError()
  {
    for (vtkDataSet* output : { static_cast<vtkDataSet*>(this->Flat->GetOutput()),
           static_cast<vtkDataSet*>(this->Surface->GetOutput()),
           static_cast<vtkDataSet*>(this->Noise->GetOutput()) })
    {
      for (const char* name : { "LIC", "LICMask", "Noise" })
      {
        vtkDataArray* values = output->GetPointData()->GetArray(name);
        for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
        {
          if (!(values->GetComponent(i, 0) >= 0.0 && values->GetComponent(i, 0) <= 1.0))
          {
            return std::string(name) + " is not in [0, 1]";
          }
        }
      }
    }
    return {};
  }

private:
  void SetNoise()
  {
    switch (this->D.Throw(3))
    {
      case 0:
        this->Flat->SetNoiseData(nullptr);
        break;
      case 1:
        this->Flat->SetNoiseConnection(this->Noise->GetOutputPort());
        break;
      default:
        this->Flat->SetNoiseData(RelevoFuzz::MakeImage(this->D));
    }
  }

  // Larger values only take longer.
  int Steps() { return this->D.Choose(std::vector<int>{ -3, 0, 1, 2, 5, 30 }); }
  double Share() { return this->D.Once(4) ? this->D.Number() : this->D.Share(); }

  // Adds the calls that both filters share.
  template <typename Filter>
  void AddLICSettings(std::vector<Call>& calls, Filter* filter)
  {
    calls.insert(calls.end(),
      { { "steps",
          [this, filter]
          {
            filter->SetNumberOfSteps(this->Steps());
            filter->SetStepSize(std::abs(this->D.Number()));
            filter->SetNormalizeVectors(this->D.Once(2));
          } },
        { "contrast",
          [this, filter]
          {
            filter->SetEnhanceContrast(this->D.Whole());
            filter->SetLowLICContrastEnhancementFactor(this->Share());
            filter->SetHighLICContrastEnhancementFactor(this->Share());
          } },
        { "no contrast", [filter] { filter->SetEnhanceContrastToOff(); } },
        { "thresholds",
          [this, filter]
          {
            filter->SetMaskThreshold(this->D.Number());
            filter->SetNoDataMagnitude(this->D.Once(2) ? this->D.Number() : 1e8);
          } },
        { "phase",
          [this, filter]
          {
            filter->SetOrientedLIC(this->D.Once(2));
            filter->SetPhase(this->D.Number());
          } },
        { "good settings",
          [filter]
          {
            filter->SetNumberOfSteps(3);
            filter->SetStepSize(0.5);
            filter->SetEnhanceContrastToOff();
            filter->SetLowLICContrastEnhancementFactor(0.0);
            filter->SetHighLICContrastEnhancementFactor(0.0);
            filter->SetNoDataMagnitude(1e8);
            filter->SetPhase(0.0);
          } } });
  }

  void AddSettings(std::vector<Call>& calls)
  {
    this->AddLICSettings(calls, this->Flat.Get());
    this->AddLICSettings(calls, this->Surface.Get());
    calls.insert(calls.end(),
      { { "passes",
          [this]
          {
            this->Flat->SetEnhancedLIC(this->D.Once(2));
            this->Flat->SetAntiAlias(this->D.Throw(4) - 1);
          } },
        { "solid noise",
          [this]
          {
            this->Surface->SetGrainSize(this->D.Once(2) ? this->D.Number() : 0.0);
            this->Surface->SetNoiseGeneratorSeed(this->D.Whole());
          } },
        { "texture",
          [this]
          {
            const std::vector<int> sides = { -3, 0, 1, 7, 32 };
            const int width = this->D.Choose(sides);
            this->Surface->SetTextureSize(width, this->D.Choose(sides));
          } },
        { "no texture", [this] { this->Surface->SetTextureSize(0, 0); } },
        { "noise settings",
          [this]
          {
            this->Noise->SetNoiseType(this->D.Once(3) ? this->D.Whole() : this->D.Throw(3));
            this->Noise->SetNoiseTextureSize(this->D.Throw(40) - 1);
            this->Noise->SetNoiseGrainSize(this->D.Throw(6) - 1);
            this->Noise->SetMinNoiseValue(0.5 * this->Share());
            this->Noise->SetMaxNoiseValue(0.5 + 0.5 * this->Share());
            this->Noise->SetNoiseGeneratorSeed(this->D.Whole());
          } },
        { "impulses",
          [this]
          {
            this->Noise->SetGaussianNoiseSmoothing(this->Share());
            this->Noise->SetNumberOfNoiseLevels(this->D.Once(3) ? this->D.Whole() : 16);
            this->Noise->SetImpulseNoiseProbability(this->Share());
            this->Noise->SetImpulseNoiseBackgroundValue(this->Share());
          } } });
  }

  void Print()
  {
    std::ostringstream text;
    this->Flat->Print(text);
    this->Surface->Print(text);
    this->Noise->Print(text);
  }

  Dice& D;
  vtkNew<vtkLineIntegralConvolution> Flat;
  vtkNew<vtkSurfaceLineIntegralConvolution> Surface;
  vtkNew<vtkLICNoiseSource> Noise;
};
}

RELEVO_FUZZ_TARGET(Machine)

int TestFuzzFlow(int, char*[])
{
  RelevoCheck check;
  int calls = 0;
  CHECK_EQUAL(RelevoFuzz::Run<Machine>(1000, 40, calls), 0);
  std::cout << calls << " calls\n";
  return check.GetResult();
}
