// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineIntegralConvolution
 * @brief   shows the directions of an image's vectors: noise, blurred along their streamlines
 *
 * B. Cabral, L. Leedom, "Imaging Vector Fields Using Line Integral Convolution", SIGGRAPH 1993; in
 * two passes by A. Okada, D. Kao, "Enhanced Line Integral Convolution with Flow Feature Detection",
 * 1997. Runs on all processors that vtkSMPTools uses; their number does not change the result.
 * Settings are those of its vtkLICSettings, which it can share with a mapper and other filters. The
 * setters here change that object.
 *
 * Input 0: a vtkImageData, flat along an axis (n x m x 1, n x 1 x m or 1 x n x m points), with
 * vectors of any type as a point array: by SetInputArrayToProcess(0, ...), or the active vectors,
 * or the first array of 2 or 3 components. Vectors of 2 components run along the two axes of the
 * image; of those of 3, in the coordinates of the image's points, the part in the image's plane
 * counts. Spacing and directions of the image turn vectors into samples.
 *
 * Input 1, optional (SetNoiseConnection, SetNoiseData): noise, a flat vtkImageData whose active
 * point scalars, first component, are in [0, 1], or unsigned char or unsigned short for the same
 * range. Its first sample lies on the first sample of input 0; it is repeated in both directions,
 * and looked up at the nearest sample. Without it, the noise that the settings choose: a
 * NoiseDataSet, a file, or what vtkLICNoiseSource generates, by default with its own defaults.
 *
 * Output: a vtkImageData of the same extent, with the float point scalars "LIC" in [0, 1] and the
 * unsigned char point array "LICMask": 1 where the noise stays as it is, since there is no LIC, and
 * 0 elsewhere. Masked are samples
 *
 * - without data: a component is not finite or at least NoDataMagnitude in absolute value, or the
 *   point is blanked. They count as zero vectors: nothing else depends on what is stored there;
 * - whose vector in the plane is no longer than MaskThreshold, with the default 0 zero vectors.
 *
 * A streamline ends where it leaves the image or comes to a sample with no vector. Samples beyond
 * its end are ignored, so that fewer are averaged near the border.
 *
 * Errors, with an empty output: an input that is empty or not flat; an array that is not there or
 * not of 2 or 3 components for each point; cell arrays; a spacing of zero; noise without scalars or
 * with values outside [0, 1], or that cannot be read or made; contrast enhancement factors whose
 * sum is not less than 1. A setting out of its range is an error and changes nothing.
 *
 * @sa vtkLICSettings vtkLICNoiseSource
 */
#ifndef vtkLineIntegralConvolution_h
#define vtkLineIntegralConvolution_h

#include "RelevoFiltersFlowModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkLICSettings.h"  // for enumerators
#include "vtkSmartPointer.h" // for members

#include <string> // for messages
#include <vector> // for images

class vtkDataArray;
namespace relevo
{
struct LICPlane;
}

class RELEVOFILTERSFLOW_EXPORT vtkLineIntegralConvolution : public vtkImageAlgorithm
{
public:
  static vtkLineIntegralConvolution* New();
  vtkTypeMacro(vtkLineIntegralConvolution, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The noise, input 1.
   */
  void SetNoiseConnection(vtkAlgorithmOutput* noise) { this->SetInputConnection(1, noise); }
  void SetNoiseData(vtkImageData* noise);
  //@}

  //@{
  /**
   * All settings; never nullptr: a nullptr gives the filter new ones with their defaults.
   */
  void SetLICSettings(vtkLICSettings* settings);
  vtkLICSettings* GetLICSettings() const;
  //@}

  //@{
  /**
   * How many steps a streamline goes each way, 1 to 100000, default 20. See vtkLICSettings.
   */
  void SetNumberOfSteps(int steps);
  int GetNumberOfSteps();
  //@}

  //@{
  /**
   * Length of a step in samples of the image, more than 0, default 1; without NormalizeVectors,
   * times the length of the vector in samples. See vtkLICSettings.
   */
  void SetStepSize(double size);
  double GetStepSize();
  //@}

  //@{
  /**
   * Whether all streamlines are equally long (the default), or by how long the vectors are. See
   * vtkLICSettings.
   */
  void SetNormalizeVectors(bool normalize);
  bool GetNormalizeVectors();
  vtkBooleanMacro(NormalizeVectors, bool);
  //@}

  //@{
  /**
   * Whether the result of the first pass is sharpened (the Laplacian is added) and convolved a
   * second time, which gives finer and longer lines. Default on; off, the mean along the
   * streamlines is the result. See vtkLICSettings.
   */
  void SetEnhancedLIC(bool enhanced);
  bool GetEnhancedLIC();
  vtkBooleanMacro(EnhancedLIC, bool);
  //@}

  enum
  {
    ENHANCE_CONTRAST_OFF = vtkLICSettings::ENHANCE_CONTRAST_OFF,
    ENHANCE_CONTRAST_LIC = vtkLICSettings::ENHANCE_CONTRAST_LIC
  };

  //@{
  /**
   * ENHANCE_CONTRAST_OFF (0, the default) or ENHANCE_CONTRAST_LIC (1): values are stretched, as
   * (L - m) / (M - m), so that the smallest is 0 and the largest 1, of those that are not masked;
   * after the first pass of two, and in the end. An image of streaks has no colours: of shared
   * settings, only what they say about the LIC counts. See vtkLICSettings.
   */
  void SetEnhanceContrast(int mode);
  int GetEnhanceContrast();
  void SetEnhanceContrastToOff() { this->SetEnhanceContrast(ENHANCE_CONTRAST_OFF); }
  void SetEnhanceContrastToLIC() { this->SetEnhanceContrast(ENHANCE_CONTRAST_LIC); }
  //@}

  //@{
  /**
   * How much further the values are stretched in the end: m = min + low * (max - min) and M = max -
   * high * (max - min), clamped to [0, 1]. Both are in [-1, 1], default 0, and their sum is less
   * than 1. See vtkLICSettings.
   */
  void SetLowLICContrastEnhancementFactor(double factor);
  double GetLowLICContrastEnhancementFactor();
  void SetHighLICContrastEnhancementFactor(double factor);
  double GetHighLICContrastEnhancementFactor();
  //@}

  //@{
  /**
   * How often the result is smoothed by a small Gaussian filter, at least 0, the default. See
   * vtkLICSettings.
   */
  void SetAntiAlias(int passes);
  int GetAntiAlias();
  //@}

  //@{
  /**
   * Samples whose vector is no longer, in units of the array, are masked. Default 0; a negative one
   * masks no zero vectors. Streamlines run through them. See vtkLICSettings.
   */
  void SetMaskThreshold(double threshold);
  double GetMaskThreshold();
  //@}

  //@{
  /**
   * From which absolute value on a component stands for "no data", as -1e9 does; more than 0,
   * default 1e8. See vtkLICSettings.
   */
  void SetNoDataMagnitude(double magnitude);
  double GetNoDataMagnitude();
  //@}

  //@{
  /**
   * Whether the weights rise upstream, so that, with sparse noise (ImpulseNoiseProbability), lines
   * grow brighter downstream: their heads show which of the two ways the vectors point. Default
   * off. See vtkLICSettings.
   */
  void SetOrientedLIC(bool oriented);
  bool GetOrientedLIC();
  vtkBooleanMacro(OrientedLIC, bool);
  //@}

  //@{
  /**
   * For animations: as it grows by 1, the pattern moves downstream by 3 NumberOfSteps + 1 steps and
   * fades into what it was; a loop of as many frames moves by one step in each. The contrast stays
   * as it is, except close to where streamlines end. Whole numbers give the same image as the
   * default, 0. Others take about twice as long. See vtkLICSettings.
   */
  void SetPhase(double phase);
  double GetPhase();
  //@}

  /// Includes the modification time of the settings.
  vtkMTimeType GetMTime() override;

protected:
  vtkLineIntegralConvolution();
  ~vtkLineIntegralConvolution() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLineIntegralConvolution(const vtkLineIntegralConvolution&) = delete;
  void operator=(const vtkLineIntegralConvolution&) = delete;

  vtkDataArray* FindVectors(vtkInformationVector** inputVector, std::string& error);
  bool MakeNoise(vtkInformationVector* noiseVector, const relevo::LICPlane& plane,
    std::vector<float>& noise, float& mean, std::string& error);
  int Convolve(vtkInformationVector** inputVector, vtkImageData* input, vtkImageData* output);

  vtkSmartPointer<vtkLICSettings> LICSettings;
};

#endif
