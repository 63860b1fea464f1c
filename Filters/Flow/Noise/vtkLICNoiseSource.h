// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLICNoiseSource
 * @brief   generate noise images for line integral convolution
 *
 * The output is a square image of NoiseTextureSize texels per side, with origin 0, spacing 1 and
 * one float point scalar "Noise". The image can be tiled without seams. It depends on the settings
 * only, not on the machine or the number of threads. Names and defaults are those of
 * vtkSurfaceLICInterface, but it generates other random numbers.
 *
 * The source reports an error and produces an empty output if NoiseGrainSize is not less than
 * NoiseTextureSize, or MinNoiseValue is not less than MaxNoiseValue. A setting out of range is an
 * error and changes nothing.
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
   * Set the distribution of the values:
   *
   * - NOISE_TYPE_UNIFORM (0): uniform between MinNoiseValue and MaxNoiseValue, one value per grain.
   * - NOISE_TYPE_GAUSSIAN (1, default): normal, one value per grain. Mean and standard deviation
   *   are 0.41 and 0.159 of the range, which is added to the minimum; values are clamped. The mean
   *   matches the noise of VTK's surface LIC, and with default settings the contrast of the result
   *   matches within 5 %.
   * - NOISE_TYPE_PERLIN (2): smooth noise of several octaves (Perlin, Improving Noise, 2002). The
   *   coarsest has a period of about NoiseGrainSize texels. Each following octave has half the
   *   period and half the amplitude, down to two texels. Values cover the whole range.
   *
   * Another value is an error and changes nothing.
   */
  virtual void SetNoiseType(int type);
  vtkGetMacro(NoiseType, int);
  void SetNoiseTypeToUniform() { this->SetNoiseType(NOISE_TYPE_UNIFORM); }
  void SetNoiseTypeToGaussian() { this->SetNoiseType(NOISE_TYPE_GAUSSIAN); }
  void SetNoiseTypeToPerlin() { this->SetNoiseType(NOISE_TYPE_PERLIN); }
  //@}

  //@{
  /**
   * Set the number of texels per side, 2 to 16384, default 200. Another value is an error and
   * changes nothing.
   */
  virtual void SetNoiseTextureSize(int length);
  vtkGetMacro(NoiseTextureSize, int);
  //@}

  //@{
  /**
   * Set the number of texels per side of a grain, which is a square of one value; default 1. For
   * Perlin noise, this is the longest period. A number out of 1 to 16383 is an error and changes
   * nothing. Generating noise with a grain size of NoiseTextureSize or more is an error.
   */
  virtual void SetNoiseGrainSize(int length);
  vtkGetMacro(NoiseGrainSize, int);
  //@}

  //@{
  /**
   * Set the smallest and the largest value, in [0, 1]; default 0 and 0.8. A value out of range is
   * an error and changes nothing. Generating noise with a minimum that is not less than the maximum
   * is an error.
   */
  virtual void SetMinNoiseValue(double value);
  vtkGetMacro(MinNoiseValue, double);
  virtual void SetMaxNoiseValue(double value);
  vtkGetMacro(MaxNoiseValue, double);
  //@}

  //@{
  /**
   * Set the standard deviation, in grains, of the Gaussian filter for NOISE_TYPE_GAUSSIAN, 0 (no
   * filter) to 100, default 1. Smoothing makes streaks easier to follow. It preserves the mean and
   * the standard deviation of the values. Another value is an error and changes nothing.
   */
  virtual void SetGaussianNoiseSmoothing(double deviation);
  vtkGetMacro(GaussianNoiseSmoothing, double);
  //@}

  //@{
  /**
   * Set the number of distinct values, evenly spaced from the smallest to the largest; at least 2,
   * default 256. Less is an error and changes nothing.
   */
  virtual void SetNumberOfNoiseLevels(int levels);
  vtkGetMacro(NumberOfNoiseLevels, int);
  //@}

  //@{
  /**
   * Set the fraction of grains (for Perlin noise, of texels) that have noise, in [0, 1], default 1.
   * The others have ImpulseNoiseBackgroundValue, in [0, 1], default 0. Another value is an error
   * and changes nothing.
   */
  virtual void SetImpulseNoiseProbability(double probability);
  vtkGetMacro(ImpulseNoiseProbability, double);
  virtual void SetImpulseNoiseBackgroundValue(double value);
  vtkGetMacro(ImpulseNoiseBackgroundValue, double);
  //@}

  //@{
  /**
   * Set the seed of the random numbers; default 1.
   */
  vtkSetMacro(NoiseGeneratorSeed, int);
  vtkGetMacro(NoiseGeneratorSeed, int);
  //@}

  /**
   * Return the error message of the last Update(), without class and source line; "" if there was
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
