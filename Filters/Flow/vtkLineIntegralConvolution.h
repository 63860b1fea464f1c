// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineIntegralConvolution
 * @brief   line integral convolution of an image
 *
 * The filter averages noise along the streamlines of the vectors of an image (B. Cabral, L. Leedom,
 * "Imaging Vector Fields Using Line Integral Convolution", SIGGRAPH 1993), in two passes (A. Okada,
 * D. Kao, "Enhanced Line Integral Convolution with Flow Feature Detection", 1997). Work is
 * distributed with vtkSMPTools; the number of threads does not change the result. Settings are
 * those of a vtkLICSettings, which the filter can share with a mapper and other filters. The
 * setters of this class change that object.
 *
 * Input 0: a vtkImageData that is flat along one axis (n x m x 1, n x 1 x m or 1 x n x m points),
 * with a point array of vectors of any type. To choose the array, call SetInputArrayToProcess().
 * The default is the active vectors, or else the first array of 2 or 3 components. Two components
 * run along the two axes of the image. Three components are in the coordinates of the image points
 * and are projected to the plane of the image. Spacing and direction of the image convert vectors
 * to samples.
 *
 * Input 1, optional: noise, see SetNoiseConnection() and SetNoiseData(). This is a flat
 * vtkImageData with the noise in the first component of its active point scalars, in [0, 1], or in
 * the full range of unsigned char or unsigned short. It starts at the first sample of input 0, is
 * tiled, and uses nearest-neighbour lookup. Without this input, the settings determine the noise: a
 * NoiseDataSet, a file, or vtkLICNoiseSource (default).
 *
 * Output: a vtkImageData of the same extent with two point arrays: "LIC" (float, in [0, 1]), the
 * active scalars, and "LICMask" (unsigned char), which is 1 where "LIC" is unfiltered noise and 0
 * elsewhere. A sample is masked if
 *
 * - data is missing: a component is not finite or at least NoDataMagnitude in absolute value, or
 *   the point is blanked. Missing vectors are treated as zero;
 * - the length of the projected vector is not greater than MaskThreshold, which by default masks
 *   zero vectors.
 *
 * A streamline ends at the border of the image and at zero vectors. Near its ends, fewer samples
 * are averaged.
 *
 * The filter reports an error and produces an empty output if the input is empty or not flat; the
 * array is missing, is a cell array, or has a wrong number of components or tuples; a spacing is
 * zero; the noise has no scalars, has values outside of [0, 1], or cannot be read or generated; or
 * the contrast enhancement factors add up to 1 or more. A setting out of range is an error and
 * changes nothing.
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
   * Set the noise, input 1.
   */
  void SetNoiseConnection(vtkAlgorithmOutput* noise) { this->SetInputConnection(1, noise); }
  void SetNoiseData(vtkImageData* noise);
  //@}

  //@{
  /**
   * Set the object with all settings. nullptr creates new default settings. The getter never
   * returns nullptr.
   */
  void SetLICSettings(vtkLICSettings* settings);
  vtkLICSettings* GetLICSettings() const;
  //@}

  //@{
  /**
   * Set the number of steps of a streamline in each direction, 1 to 100000, default 20. See
   * vtkLICSettings.
   */
  void SetNumberOfSteps(int steps);
  int GetNumberOfSteps();
  //@}

  //@{
  /**
   * Set the length of a step in samples, greater than 0, default 1. Without NormalizeVectors, it is
   * multiplied by the length of the vector in samples. See vtkLICSettings.
   */
  void SetStepSize(double size);
  double GetStepSize();
  //@}

  //@{
  /**
   * Set whether all streamlines are equally long (default), or proportional to the vectors. See
   * vtkLICSettings.
   */
  void SetNormalizeVectors(bool normalize);
  bool GetNormalizeVectors();
  vtkBooleanMacro(NormalizeVectors, bool);
  //@}

  //@{
  /**
   * Set whether the result of the first pass is sharpened with a Laplacian and convolved again,
   * which gives finer and longer streaks; on by default. See vtkLICSettings.
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
   * Set the contrast enhancement: ENHANCE_CONTRAST_OFF (0, default), or ENHANCE_CONTRAST_LIC (1),
   * which maps values with (L - m) / (M - m) so that the smallest value that is not masked becomes
   * 0 and the largest 1. With two passes, this is done after each of them. The colour contrast of
   * shared settings is ignored. See vtkLICSettings.
   */
  void SetEnhanceContrast(int mode);
  int GetEnhanceContrast();
  void SetEnhanceContrastToOff() { this->SetEnhanceContrast(ENHANCE_CONTRAST_OFF); }
  void SetEnhanceContrastToLIC() { this->SetEnhanceContrast(ENHANCE_CONTRAST_LIC); }
  //@}

  //@{
  /**
   * Set how much further the contrast is enhanced after the last pass: m = min + low * (max - min)
   * and M = max - high * (max - min), with the result clamped to [0, 1]. Each factor is in [-1, 1],
   * default 0, and their sum must be less than 1. See vtkLICSettings.
   */
  void SetLowLICContrastEnhancementFactor(double factor);
  double GetLowLICContrastEnhancementFactor();
  void SetHighLICContrastEnhancementFactor(double factor);
  double GetHighLICContrastEnhancementFactor();
  //@}

  //@{
  /**
   * Set how many times a small Gaussian filter smooths the result, 0 (default) to 1000. See
   * vtkLICSettings.
   */
  void SetAntiAlias(int passes);
  int GetAntiAlias();
  //@}

  //@{
  /**
   * Set the vector length, in units of the array, up to which samples are masked; default 0. A
   * negative value does not mask zero vectors. Streamlines continue through masked samples. See
   * vtkLICSettings.
   */
  void SetMaskThreshold(double threshold);
  double GetMaskThreshold();
  //@}

  //@{
  /**
   * Set the absolute value from which on a component is missing data; greater than 0, default 1e8.
   * See vtkLICSettings.
   */
  void SetNoDataMagnitude(double magnitude);
  double GetNoDataMagnitude();
  //@}

  //@{
  /**
   * Set whether streaks show the orientation of the vectors; off by default. Weights then increase
   * upstream, so that streaks get brighter downstream. Use sparse noise (ImpulseNoiseProbability).
   * See vtkLICSettings.
   */
  void SetOrientedLIC(bool oriented);
  bool GetOrientedLIC();
  vtkBooleanMacro(OrientedLIC, bool);
  //@}

  //@{
  /**
   * Set the phase of an animation; default 0. While the phase grows by 1, the pattern moves 3 *
   * NumberOfSteps + 1 steps downstream and fades into its initial state, so that a loop of as many
   * frames moves one step per frame. The contrast is preserved except near the ends of streamlines.
   * All integers give the same image; other values take about twice as long. See vtkLICSettings.
   */
  void SetPhase(double phase);
  double GetPhase();
  //@}

  /// Include the modification time of the settings.
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
