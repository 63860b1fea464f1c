// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random calls of vtkAdaptiveLICMapper and of VTK's classes around a mapper, with
// random inputs, never crash, and that the mapper's counters stay consistent.
#include "RelevoCheck.h"
#include "RelevoFuzzImages.h"
#include "RelevoFuzzMapper.h"

#include "vtkAdaptiveLICMapper.h"

namespace
{
using RelevoFuzz::Call;
using RelevoFuzz::Dice;

class Machine : public RelevoFuzz::MapperMachine<vtkAdaptiveLICMapper>
{
public:
  using MapperMachine::MapperMachine;

  std::vector<Call> GetCalls()
  {
    std::vector<Call> calls = this->MapperMachine::GetCalls();
    this->AddLICCalls(calls);
    this->AddNoiseCalls(calls);
    return calls;
  }

private:
  double Share() { return this->D.Once(4) ? this->D.Number() : this->D.Share(); }

  void AddLICCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "vectors",
          [this]
          {
            this->ChooseMapper()->SetInputArrayToProcess(
              0, 0, 0, this->D.Throw(3), RelevoFuzz::ChooseName(this->D).c_str());
          } },
        { "enable", [this] { this->ChooseMapper()->SetEnable(this->D.Throw(3) != 0); } },
        { "steps",
          [this]
          {
            vtkAdaptiveLICMapper* mapper = this->ChooseMapper();
            mapper->SetNumberOfSteps(this->D.Throw(8) - 1);
            mapper->SetStepSize(this->D.Number());
            mapper->SetNormalizeVectors(this->D.Throw(2));
          } },
        { "passes",
          [this]
          {
            vtkAdaptiveLICMapper* mapper = this->ChooseMapper();
            mapper->SetEnhancedLIC(this->D.Throw(2));
            mapper->SetOrientedLIC(this->D.Throw(2));
            mapper->SetPhase(this->D.Number());
            mapper->SetAntiAlias(this->D.Throw(4) - 1);
          } },
        { "contrast",
          [this]
          {
            vtkAdaptiveLICMapper* mapper = this->ChooseMapper();
            mapper->SetEnhanceContrast(this->D.Whole());
            mapper->SetLowLICContrastEnhancementFactor(this->Share());
            mapper->SetHighColorContrastEnhancementFactor(this->Share());
          } },
        { "mask",
          [this]
          {
            vtkAdaptiveLICMapper* mapper = this->ChooseMapper();
            mapper->SetMaskThreshold(this->D.Number());
            mapper->SetMaskOnSurface(this->D.Throw(2));
            mapper->SetMaskIntensity(this->Share());
            mapper->SetMaskColor(this->Share(), this->Share(), this->Share());
            mapper->SetNoDataMagnitude(this->D.Number());
          } },
        { "share",
          [this]
          {
            vtkAdaptiveLICMapper* mapper = this->ChooseMapper();
            mapper->GetLICInterface()->SetColorMode(this->D.Whole());
            mapper->SetLICIntensity(this->Share());
            mapper->SetMapModeBias(this->Share());
          } } });
  }

  void AddNoiseCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "noise",
          [this]
          {
            vtkAdaptiveLICMapper* mapper = this->ChooseMapper();
            mapper->SetNoiseDataSet(
              this->D.Once(2) ? nullptr : RelevoFuzz::MakeImage(this->D).Get());
            mapper->SetNoiseFileName(this->D.Once(2) ? nullptr : "no such file.png");
          } },
        { "generated noise",
          [this]
          {
            vtkAdaptiveLICMapper* mapper = this->ChooseMapper();
            mapper->SetGenerateNoiseTexture(this->D.Throw(2));
            mapper->SetNoiseType(this->D.Whole());
            mapper->SetNoiseTextureSize(this->D.Throw(40) - 1);
            mapper->SetNoiseGrainSize(this->D.Throw(6) - 1);
            mapper->SetMinNoiseValue(this->Share());
            mapper->SetMaxNoiseValue(this->Share());
            mapper->SetNumberOfNoiseLevels(this->D.Whole());
            mapper->SetImpulseNoiseProbability(this->Share());
          } } });
  }
};
}

int TestFuzzLICMapper(int, char*[])
{
  RelevoCheck check;
  int calls = 0;
  CHECK_EQUAL(RelevoFuzz::Run<Machine>(15, 60, calls), 0);
  std::cout << calls << " calls\n";
  return check.GetResult();
}
