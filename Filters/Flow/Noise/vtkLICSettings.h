// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLICSettings
 * @brief   settings for line integral convolution, shared by the mapper and the filters
 *
 * vtkAdaptiveLICMapper, vtkLineIntegralConvolution and vtkSurfaceLineIntegralConvolution each have
 * such an object and can share one with SetLICSettings(). Their setters change this object.
 * Changing it makes the mappers render again and the filters execute again.
 *
 * Names, values and defaults are those of VTK's vtkSurfaceLICInterface, and the mapper's
 * GetLICInterface() returns this object, so that scripts for vtkSurfaceLICMapper work unchanged.
 * The only different default is GenerateNoiseTexture, which is on. OrientedLIC, Phase,
 * NoDataMagnitude and NoiseFileName are additions.
 *
 * The mapper uses all settings. vtkLineIntegralConvolution ignores Enable, MaskOnSurface and the
 * settings for colours (ColorMode, LICIntensity, MapModeBias, MaskColor, MaskIntensity and the
 * colour contrast). vtkSurfaceLineIntegralConvolution also ignores EnhancedLIC, AntiAlias and all
 * noise settings except NoiseGeneratorSeed, because it uses solid noise.
 *
 * A value out of range is an error (ErrorEvent) and changes nothing. If a setter of a mapper or
 * filter received the value, that object reports the error. For settings that are on (1) or off
 * (0), any other number means on.
 *
 * @sa vtkAdaptiveLICMapper vtkLineIntegralConvolution vtkSurfaceLineIntegralConvolution
 */
#ifndef vtkLICSettings_h
#define vtkLICSettings_h

#include "RelevoFiltersFlowModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for members

#include <string> // for members

class vtkImageData;

class RELEVOFILTERSFLOW_EXPORT vtkLICSettings : public vtkObject
{
public:
  static vtkLICSettings* New();
  vtkTypeMacro(vtkLICSettings, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set whether the mapper draws the LIC; on by default.
   */
  void SetEnable(int enable);
  int GetEnable() const { return this->Values.Enable; }
  vtkBooleanMacro(Enable, int);
  //@}

  //@{
  /**
   * Set the number of steps of a streamline in each direction, 1 to 100000, default 20, which
   * averages 41 samples of noise. The second pass of EnhancedLIC uses half as many.
   */
  void SetNumberOfSteps(int steps);
  int GetNumberOfSteps() const { return this->Values.NumberOfSteps; }
  //@}

  //@{
  /**
   * Set the length of a step, greater than 0, default 1, in pixels of the window (mapper), samples
   * of the image (vtkLineIntegralConvolution), or noise grains (vtkSurfaceLineIntegralConvolution).
   * Without NormalizeVectors, this is the step for a vector of length 1, measured on the screen or
   * in samples. On a surface, it is the step for the longest vector.
   */
  void SetStepSize(double size);
  double GetStepSize() const { return this->Values.StepSize; }
  //@}

  //@{
  /**
   * Set whether vectors are normalized; on by default. If off, the length of steps and streaks is
   * proportional to the vectors.
   */
  void SetNormalizeVectors(int normalize);
  int GetNormalizeVectors() const { return this->Values.NormalizeVectors; }
  vtkBooleanMacro(NormalizeVectors, int);
  //@}

  //@{
  /**
   * Set whether the result is sharpened and convolved again with half the number of steps; on by
   * default (Okada and Kao, Enhanced Line Integral Convolution with Flow Feature Detection, 1997).
   */
  void SetEnhancedLIC(int enhanced);
  int GetEnhancedLIC() const { return this->Values.EnhancedLIC; }
  vtkBooleanMacro(EnhancedLIC, int);
  //@}

  //@{
  /**
   * Set whether streaks show the orientation of the vectors; off by default. Weights decrease
   * upstream, so that streaks fade towards their tails (Wegenkittl, Groeller and Purgathofer,
   * Animating Flow Fields: Rendering of Oriented Line Integral Convolution, 1997). For best
   * results, turn EnhancedLIC off and use sparse noise: SetNoiseType(NOISE_TYPE_UNIFORM),
   * SetImpulseNoiseProbability(0.02), SetNoiseGrainSize(3), and either bright dots
   * (SetMaxNoiseValue(1), SetMinNoiseValue(0.9)) or dark dots (SetMaxNoiseValue(0.02),
   * SetImpulseNoiseBackgroundValue(1)).
   */
  void SetOrientedLIC(int oriented);
  int GetOrientedLIC() const { return this->Values.OrientedLIC; }
  vtkBooleanMacro(OrientedLIC, int);
  //@}

  //@{
  /**
   * Set how far the pattern has moved downstream, in loops of 3 * NumberOfSteps + 1 steps; default
   * 0. All integers give the same result, so that the phases i / n for i = 0 ... n - 1 make a
   * seamless animation.
   */
  void SetPhase(double phase);
  double GetPhase() const { return this->Values.Phase; }
  //@}

  enum
  {
    ENHANCE_CONTRAST_OFF = 0,
    ENHANCE_CONTRAST_LIC = 1,
    ENHANCE_CONTRAST_COLOR = 3,
    ENHANCE_CONTRAST_BOTH = 4
  };

  //@{
  /**
   * Set the contrast enhancement: of the LIC after each convolution (ENHANCE_CONTRAST_LIC, 1), of
   * the lightness of the final colours (ENHANCE_CONTRAST_COLOR, 3), of both (ENHANCE_CONTRAST_BOTH,
   * 4) or none (ENHANCE_CONTRAST_OFF, 0, default). Values are mapped linearly so that min + low *
   * (max - min) becomes 0 and max - high * (max - min) becomes 1. min and max are the smallest and
   * largest value on the surface, low and high the two factors.
   */
  void SetEnhanceContrast(int mode);
  int GetEnhanceContrast() const { return this->Values.EnhanceContrast; }
  void SetEnhanceContrastToOff() { this->SetEnhanceContrast(ENHANCE_CONTRAST_OFF); }
  void SetEnhanceContrastToLIC() { this->SetEnhanceContrast(ENHANCE_CONTRAST_LIC); }
  void SetEnhanceContrastToColor() { this->SetEnhanceContrast(ENHANCE_CONTRAST_COLOR); }
  void SetEnhanceContrastToBoth() { this->SetEnhanceContrast(ENHANCE_CONTRAST_BOTH); }
  //@}

  /// Return whether the contrast of the LIC is enhanced: ENHANCE_CONTRAST_LIC or _BOTH.
  bool EnhancesLICContrast() const;
  /// Return whether the contrast of colours is enhanced: ENHANCE_CONTRAST_COLOR or _BOTH.
  bool EnhancesColorContrast() const;

  //@{
  /**
   * Set the factors for SetEnhanceContrast(), in [-1, 1], default 0. Negative factors enhance the
   * contrast less.
   */
  void SetLowLICContrastEnhancementFactor(double factor);
  double GetLowLICContrastEnhancementFactor() const;
  void SetHighLICContrastEnhancementFactor(double factor);
  double GetHighLICContrastEnhancementFactor() const;
  void SetLowColorContrastEnhancementFactor(double factor);
  double GetLowColorContrastEnhancementFactor() const;
  void SetHighColorContrastEnhancementFactor(double factor);
  double GetHighColorContrastEnhancementFactor() const;
  //@}

  //@{
  /**
   * Set how many times a Gaussian filter of 3 x 3 pixels smooths the LIC, 0 (default) to 1000.
   */
  void SetAntiAlias(int passes);
  int GetAntiAlias() const { return this->Values.AntiAlias; }
  vtkBooleanMacro(AntiAlias, int);
  //@}

  //@{
  /**
   * Set the vector length, in units of the array, up to which no streaks are drawn; default 0. With
   * a negative value, even zero vectors show unfiltered noise.
   */
  void SetMaskThreshold(double threshold);
  double GetMaskThreshold() const { return this->Values.MaskThreshold; }
  //@}

  //@{
  /**
   * Set whether MaskThreshold is compared with the length of the vector projected on the surface.
   * By default (off), it is compared with the length of the vector.
   */
  void SetMaskOnSurface(int onSurface);
  int GetMaskOnSurface() const { return this->Values.MaskOnSurface; }
  vtkBooleanMacro(MaskOnSurface, int);
  //@}

  //@{
  /**
   * Set the colour of masked fragments: MaskIntensity, in [0, 1], default 0, is the fraction of
   * MaskColor, in [0, 1], default (0.5, 0.5, 0.5). The rest is the colour of the surface.
   */
  void SetMaskColor(double red, double green, double blue);
  void SetMaskColor(const double color[3]) { this->SetMaskColor(color[0], color[1], color[2]); }
  double* GetMaskColor() VTK_SIZEHINT(3) { return this->Values.MaskColor; }
  void GetMaskColor(double color[3]) const;
  void GetMaskColor(double& red, double& green, double& blue) const;
  void SetMaskIntensity(double intensity);
  double GetMaskIntensity() const { return this->Values.MaskIntensity; }
  //@}

  //@{
  /**
   * Set the absolute value from which on a component is missing data, as are values that are not
   * finite; greater than 0, default 1e8, which covers usual fill values (-1e9, 1e20, 1e30).
   */
  void SetNoDataMagnitude(double magnitude);
  double GetNoDataMagnitude() const { return this->Values.NoDataMagnitude; }
  //@}

  enum
  {
    COLOR_MODE_BLEND = 0,
    COLOR_MODE_MAP = 1
  };

  //@{
  /**
   * Set how the LIC is combined with the colours of the surface: COLOR_MODE_BLEND (0, default) is
   * LIC * LICIntensity + colour * (1 - LICIntensity), COLOR_MODE_MAP (1) is colour * (LIC +
   * MapModeBias). To set how scalars are mapped to colours, use SetColorMode() of the mapper.
   */
  void SetColorMode(int mode);
  int GetColorMode() const { return this->Values.ColorMode; }
  void SetColorModeToBlend() { this->SetColorMode(COLOR_MODE_BLEND); }
  void SetColorModeToMap() { this->SetColorMode(COLOR_MODE_MAP); }
  //@}

  //@{
  /**
   * Set the weight of the LIC in COLOR_MODE_BLEND, in [0, 1], default 0.8.
   */
  void SetLICIntensity(double intensity);
  double GetLICIntensity() const { return this->Values.LICIntensity; }
  //@}

  //@{
  /**
   * Set the value that COLOR_MODE_MAP adds to the LIC, in [-1, 1], default 0.
   */
  void SetMapModeBias(double bias);
  double GetMapModeBias() const { return this->Values.MapModeBias; }
  //@}

  //@{
  /**
   * Set an image to use as noise. It is tiled from the lower left corner of the viewport or image.
   * The image must be flat. The first component of its active scalars is used, in [0, 1], or in the
   * full range of unsigned char or unsigned short. nullptr (default) generates noise.
   */
  void SetNoiseDataSet(vtkImageData* image);
  vtkImageData* GetNoiseDataSet() const;
  //@}

  //@{
  /**
   * Set an image file to use as noise, in any format that vtkImageReader2Factory supports; nullptr
   * (default) for none. A NoiseDataSet takes precedence.
   */
  void SetNoiseFileName(const char* name);
  const char* GetNoiseFileName() const;
  //@}

  enum
  {
    NOISE_TYPE_UNIFORM = 0,
    NOISE_TYPE_GAUSSIAN = 1,
    NOISE_TYPE_PERLIN = 2
  };

  //@{
  /**
   * Set the noise that vtkLICNoiseSource generates. If GenerateNoiseTexture is off, the defaults of
   * the following settings are used; it is on by default.
   *
   * - NoiseType: NOISE_TYPE_UNIFORM (0), _GAUSSIAN (1, default) or _PERLIN (2).
   * - NoiseTextureSize: pixels per side of the tile, 2 to 16384, default 200.
   * - NoiseGrainSize: pixels per side of a grain, at least 1 and less than NoiseTextureSize,
   *   default 1.
   * - MinNoiseValue, MaxNoiseValue: the range, in [0, 1], default 0 and 0.8.
   * - NumberOfNoiseLevels: the number of distinct values, at least 2, default 256.
   * - ImpulseNoiseProbability: the fraction of grains that have noise, in [0, 1], default 1.
   * - ImpulseNoiseBackgroundValue: the value of other grains, in [0, 1], default 0.
   * - NoiseGeneratorSeed: the seed of the random numbers, default 1.
   *
   * Inconsistent settings are reported when the noise is generated.
   */
  void SetGenerateNoiseTexture(int generate);
  int GetGenerateNoiseTexture() const { return this->Values.GenerateNoiseTexture; }
  vtkBooleanMacro(GenerateNoiseTexture, int);
  void SetNoiseType(int type);
  int GetNoiseType() const { return this->Values.NoiseType; }
  void SetNoiseTextureSize(int length);
  int GetNoiseTextureSize() const { return this->Values.NoiseTextureSize; }
  void SetNoiseGrainSize(int length);
  int GetNoiseGrainSize() const { return this->Values.NoiseGrainSize; }
  void SetMinNoiseValue(double value);
  double GetMinNoiseValue() const { return this->Values.MinNoiseValue; }
  void SetMaxNoiseValue(double value);
  double GetMaxNoiseValue() const { return this->Values.MaxNoiseValue; }
  void SetNumberOfNoiseLevels(int levels);
  int GetNumberOfNoiseLevels() const { return this->Values.NumberOfNoiseLevels; }
  void SetImpulseNoiseProbability(double probability);
  double GetImpulseNoiseProbability() const { return this->Values.ImpulseNoiseProbability; }
  void SetImpulseNoiseBackgroundValue(double value);
  double GetImpulseNoiseBackgroundValue() const { return this->Values.ImpulseNoiseBackground; }
  void SetNoiseGeneratorSeed(int seed);
  int GetNoiseGeneratorSeed() const { return this->Values.NoiseGeneratorSeed; }
  //@}

  enum
  {
    COMPOSITE_INPLACE = 0,
    COMPOSITE_INPLACE_DISJOINT = 1,
    COMPOSITE_BALANCED = 2,
    COMPOSITE_AUTO = 3
  };

  //@{
  /**
   * Set how VTK's parallel surface LIC divides the screen: COMPOSITE_INPLACE (0) to COMPOSITE_AUTO
   * (3, default). The setting exists for compatibility and has no effect.
   */
  void SetCompositeStrategy(int strategy);
  int GetCompositeStrategy() const { return this->Values.CompositeStrategy; }
  //@}

  /**
   * Copy all settings of another object. NoiseDataSet is shared, not copied.
   */
  void ShallowCopy(vtkLICSettings* other);

  /**
   * Include the modification time of the NoiseDataSet.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Apply a change (a function of these settings) and report its errors on `holder`. For classes
   * with setters that call those of this object. C++ only.
   */
  template <typename Change>
  void ChangeFor(vtkObject* holder, const Change& change)
  {
    vtkObject* previous = this->Holder;
    this->Holder = holder;
    change(*this);
    this->Holder = previous;
  }

protected:
  vtkLICSettings();
  ~vtkLICSettings() override;

private:
  vtkLICSettings(const vtkLICSettings&) = delete;
  void operator=(const vtkLICSettings&) = delete;

  struct SettingValues
  {
    int Enable = 1;
    int NumberOfSteps = 20;
    double StepSize = 1.0;
    int NormalizeVectors = 1;
    int EnhancedLIC = 1;
    int OrientedLIC = 0;
    double Phase = 0.0;
    int EnhanceContrast = ENHANCE_CONTRAST_OFF;
    double LowLICContrast = 0.0;
    double HighLICContrast = 0.0;
    double LowColorContrast = 0.0;
    double HighColorContrast = 0.0;
    int AntiAlias = 0;
    double MaskThreshold = 0.0;
    int MaskOnSurface = 0;
    double MaskColor[3] = { 0.5, 0.5, 0.5 };
    double MaskIntensity = 0.0;
    double NoDataMagnitude = 1e8;
    int ColorMode = COLOR_MODE_BLEND;
    double LICIntensity = 0.8;
    double MapModeBias = 0.0;
    vtkSmartPointer<vtkImageData> NoiseDataSet;
    std::string NoiseFileName;
    int GenerateNoiseTexture = 1;
    int NoiseType = NOISE_TYPE_GAUSSIAN;
    int NoiseTextureSize = 200;
    int NoiseGrainSize = 1;
    double MinNoiseValue = 0.0;
    double MaxNoiseValue = 0.8;
    int NumberOfNoiseLevels = 256;
    double ImpulseNoiseProbability = 1.0;
    double ImpulseNoiseBackground = 0.0;
    int NoiseGeneratorSeed = 1;
    int CompositeStrategy = COMPOSITE_AUTO;
  };

  vtkObject* GetErrorSource();
  template <typename Value>
  void Set(Value& setting, Value value);
  template <typename Value>
  void SetInRange(const char* name, Value& setting, Value value, Value lowest, Value highest);
  void SetShare(const char* name, double& share, double value);
  void SetFactor(const char* name, double& factor, double value);
  void SetFlag(int& flag, int value);

  SettingValues Values;
  vtkObject* Holder = nullptr; // the object that reports errors; nullptr for this object
};

#endif
