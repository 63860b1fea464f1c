// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLICNoiseSource
 * @brief   noise images for line integral convolution
 *
 * The output is a square image of NoiseTextureSize texels a side, origin 0, spacing 1, with one
 * float point scalar "Noise". It tiles: its left border continues its right one, its lower border
 * its upper one. It depends on the settings alone, not on the machine or its threads. Names and
 * defaults are those of vtkSurfaceLICInterface, whose numbers differ, though.
 *
 * Errors, with an empty output: a NoiseGrainSize that is not below NoiseTextureSize; a
 * MinNoiseValue that is not below MaxNoiseValue. A setting out of its range is an error and changes
 * nothing.
 *
 * @sa vtkLineIntegralConvolution
 */
#ifndef vtkLICNoiseSource_h
#define vtkLICNoiseSource_h

#include "RelevoFiltersFlowModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for messages
#include <vector> // for images

class RELEVOFILTERSFLOW_EXPORT vtkLICNoiseSource : public vtkImageAlgorithm
{
public:
  static vtkLICNoiseSource* New();
  vtkTypeMacro(vtkLICNoiseSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum NoiseTypes
  {
    NOISE_TYPE_UNIFORM = 0,
    NOISE_TYPE_GAUSSIAN = 1,
    NOISE_TYPE_PERLIN = 2
  };

  //@{
  /**
   * How the values are distributed: NOISE_TYPE_UNIFORM (0), each grain's value is anywhere between
   * MinNoiseValue and MaxNoiseValue; NOISE_TYPE_GAUSSIAN (1, the default), each grain's value is
   * normally distributed about 0.41 of the way from the minimum to the maximum with a standard
   * deviation of 0.159 of that way, clamped: the mean is that of the noise image of VTK's surface
   * LIC, and so, within 5 %, is the contrast of what the defaults make of it;
   * NOISE_TYPE_PERLIN (2), smooth noise of several octaves (Perlin, Improving Noise, 2002), the
   * coarsest with a period of about NoiseGrainSize texels, each of the next ones half as long and
   * high, down to two texels; it reaches the minimum and the maximum. Another value is an error and
   * changes nothing.
   */
  virtual void SetNoiseType(int type);
  vtkGetMacro(NoiseType, int);
  void SetNoiseTypeToUniform() { this->SetNoiseType(NOISE_TYPE_UNIFORM); }
  void SetNoiseTypeToGaussian() { this->SetNoiseType(NOISE_TYPE_GAUSSIAN); }
  void SetNoiseTypeToPerlin() { this->SetNoiseType(NOISE_TYPE_PERLIN); }
  //@}

  //@{
  /**
   * Number of texels along each side, 2 to 16384, default 200. Another value is an error and
   * changes nothing.
   */
  virtual void SetNoiseTextureSize(int length);
  vtkGetMacro(NoiseTextureSize, int);
  //@}

  //@{
  /**
   * Number of texels along each side of the squares of one value (of Perlin noise: its longest
   * period), default 1. Less than 1, or more than 16383, is an error and changes nothing; at least
   * NoiseTextureSize is an error when the noise is made.
   */
  virtual void SetNoiseGrainSize(int length);
  vtkGetMacro(NoiseGrainSize, int);
  //@}

  //@{
  /**
   * The smallest and the largest value, in [0, 1]; default 0 and 0.8. Another value is an error and
   * changes nothing; a minimum that is not below the maximum is an error when the noise is made.
   */
  virtual void SetMinNoiseValue(double value);
  vtkGetMacro(MinNoiseValue, double);
  virtual void SetMaxNoiseValue(double value);
  vtkGetMacro(MaxNoiseValue, double);
  //@}

  //@{
  /**
   * Standard deviation, in grains, of the Gaussian filter that smooths the noise of
   * NOISE_TYPE_GAUSSIAN; mean and spread of the values stay as they are. 0 (no filter) to 100,
   * default 1: lines show their direction better in noise without the finest detail. Another value
   * is an error and changes nothing.
   */
  virtual void SetGaussianNoiseSmoothing(double deviation);
  vtkGetMacro(GaussianNoiseSmoothing, double);
  //@}

  //@{
  /**
   * How many different values there are, evenly spaced from the smallest to the largest; at least
   * 2, default 256. Less is an error and changes nothing.
   */
  virtual void SetNumberOfNoiseLevels(int levels);
  vtkGetMacro(NumberOfNoiseLevels, int);
  //@}

  //@{
  /**
   * Share of the grains (of Perlin noise: of the texels) that have noise, in [0, 1], default 1. The
   * others have ImpulseNoiseBackgroundValue, in [0, 1], default 0. Another value is an error and
   * changes nothing.
   */
  virtual void SetImpulseNoiseProbability(double probability);
  vtkGetMacro(ImpulseNoiseProbability, double);
  virtual void SetImpulseNoiseBackgroundValue(double value);
  vtkGetMacro(ImpulseNoiseBackgroundValue, double);
  //@}

  //@{
  /**
   * Another number gives other noise of the same kind; default 1.
   */
  vtkSetMacro(NoiseGeneratorSeed, int);
  vtkGetMacro(NoiseGeneratorSeed, int);
  //@}

  /**
   * What the last Update() reported as an error, without class and source line; "" when there was
   * none.
   */
  const char* GetErrorMessage() { return this->ErrorMessage.c_str(); }

protected:
  vtkLICNoiseSource();
  ~vtkLICNoiseSource() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int NoiseType = NOISE_TYPE_GAUSSIAN;
  int NoiseTextureSize = 200;
  int NoiseGrainSize = 1;
  double MinNoiseValue = 0.0;
  double MaxNoiseValue = 0.8;
  double GaussianNoiseSmoothing = 1.0;
  int NumberOfNoiseLevels = 256;
  double ImpulseNoiseProbability = 1.0;
  double ImpulseNoiseBackgroundValue = 0.0;
  int NoiseGeneratorSeed = 1;

private:
  vtkLICNoiseSource(const vtkLICNoiseSource&) = delete;
  void operator=(const vtkLICNoiseSource&) = delete;

  std::string FindError() const;
  std::vector<float> MakeUnitNoise() const;
  void MapToLevels(const std::vector<float>& image, float* noise) const;

  std::string ErrorMessage;
};

#endif
