// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Height fields for tests.
#ifndef RelevoHeights_h
#define RelevoHeights_h

#include "vtkHeightField.h"

#include <functional>
#include <vector>

// Heights given by a function of texel centres.
class RelevoHeights : public vtkHeightField
{
public:
  static RelevoHeights* New();
  vtkTypeMacro(RelevoHeights, vtkHeightField);

  void Fill(int width, int height, const std::function<double(double, double)>& function);
  void FillRandom(int width, int height, unsigned int seed);
  // Marks the samples for which the function returns true as missing.
  void Punch(const std::function<bool(int, int)>& isHole);

  void FillWaves();
  // A round hole and a slot that is open at the border.
  void FillWavesWithHoles();

  bool Update() override;
  void GetDimensions(int dimensions[2]) override;
  void GetRange(double range[2]) override;
  bool HasNoData() override { return !this->Validity.empty(); }
  vtkMTimeType GetSamplesMTime() override { return this->GetMTime(); }
  const float* GetSamples() override { return this->Samples.data(); }
  const unsigned char* GetValidity() override;

protected:
  RelevoHeights() = default;
  ~RelevoHeights() override = default;

private:
  std::vector<float> Samples;
  std::vector<unsigned char> Validity;
  int Dimensions[2] = { 0, 0 };
};

#endif
