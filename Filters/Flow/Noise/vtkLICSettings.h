// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLICSettings
 * @brief   settings for line integral convolution, shared by the mapper and the filters
 *
 * vtkAdaptiveLICMapper, vtkLineIntegralConvolution and vtkSurfaceLineIntegralConvolution each have
 * one, GetLICSettings(), and can share one, SetLICSettings(). Their own setters change this object.
 * Changing it makes the mappers draw again and the filters execute again.
 *
 * Names, numbers and defaults are those of VTK's vtkSurfaceLICInterface, and the mapper's
 * GetLICInterface() returns this object, so that scripts for vtkSurfaceLICMapper run as they are.
 * Only GenerateNoiseTexture has another default: on. OrientedLIC, Phase, NoDataMagnitude and
 * NoiseFileName are additions.
 *
 * The mapper uses all settings. vtkLineIntegralConvolution leaves out those of colours (ColorMode,
 * LICIntensity, MapModeBias, MaskColor, MaskIntensity, the contrast of colours), MaskOnSurface and
 * Enable. vtkSurfaceLineIntegralConvolution leaves out EnhancedLIC, AntiAlias and, but for
 * NoiseGeneratorSeed, those of noise, too: its noise fills space.
 *
 * A value out of its range is an error (ErrorEvent) and changes nothing. If it was given to a
 * setter of a mapper or filter, the error is that object's. For settings that are on (1) or off
 * (0), any number but 0 means on.
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
   * Whether the mapper shows streaks at all, on by default.
   */
  void SetEnable(int enable);
  int GetEnable() const { return this->Values.Enable; }
  vtkBooleanMacro(Enable, int);
  //@}

  //@{
  /**
   * Steps of a streamline each way, 1 to 100000, default 20: the mean of 41 samples of the noise.
   * In the second pass of EnhancedLIC half as many.
   */
  void SetNumberOfSteps(int steps);
  int GetNumberOfSteps() const { return this->Values.NumberOfSteps; }
  //@}

  //@{
  /**
   * Length of a step, above 0, default 1: in pixels of the window (mapper), samples of the image
   * (vtkLineIntegralConvolution), or grains of the noise (vtkSurfaceLineIntegralConvolution). If
   * vectors are not normalised, that is the step for a vector of length 1 on the screen's plane or
   * in samples; on a surface, for the longest vector.
   */
  void SetStepSize(double size);
  double GetStepSize() const { return this->Values.StepSize; }
  //@}

  //@{
  /**
   * Whether all vectors count as equally long, on by default. Off: steps are as long as vectors,
   * and so are streaks.
   */
  void SetNormalizeVectors(int normalize);
  int GetNormalizeVectors() const { return this->Values.NormalizeVectors; }
  vtkBooleanMacro(NormalizeVectors, int);
  //@}

  //@{
  /**
   * Whether the result, with its edges sharpened, is convolved once more, with half as many steps;
   * on by default (Okada and Kao, Enhanced Line Integral Convolution with Flow Feature Detection,
   * 1997).
   */
  void SetEnhancedLIC(int enhanced);
  int GetEnhancedLIC() const { return this->Values.EnhancedLIC; }
  vtkBooleanMacro(EnhancedLIC, int);
  //@}

  //@{
  /**
   * Whether streaks show the direction too, off by default: weights fall off upstream, so what
   * flows from a dot fades out towards its tail (Wegenkittl, Groeller and Purgathofer, Animating
   * Flow Fields: Rendering of Oriented Line Integral Convolution, 1997). Best without EnhancedLIC
   * and with sparse noise: SetNoiseType(NOISE_TYPE_UNIFORM), SetImpulseNoiseProbability(0.02),
   * SetNoiseGrainSize(3), and either light dots (SetMaxNoiseValue(1), SetMinNoiseValue(0.9)) or
   * dark ones (SetMaxNoiseValue(0.02), SetImpulseNoiseBackgroundValue(1)).
   */
  void SetOrientedLIC(int oriented);
  int GetOrientedLIC() const { return this->Values.OrientedLIC; }
  vtkBooleanMacro(OrientedLIC, int);
  //@}

  //@{
  /**
   * How far the pattern has moved down the flow, in loops of 3 NumberOfSteps + 1 steps; default 0.
   * Whole numbers look alike, so phases i / n for i = 0 ... n - 1 make an animation without a seam.
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
   * Whether the range of greys is stretched: of the LIC (ENHANCE_CONTRAST_LIC, 1), after each
   * convolution; of the lightness of the colours combined with it (ENHANCE_CONTRAST_COLOR, 3); both
   * (ENHANCE_CONTRAST_BOTH, 4); neither (ENHANCE_CONTRAST_OFF, 0, the default). Values are mapped
   * linearly: min + low * (max - min) becomes 0, and max - high * (max - min) becomes 1, with the
   * least and the largest value on the surface and the two factors.
   */
  void SetEnhanceContrast(int mode);
  int GetEnhanceContrast() const { return this->Values.EnhanceContrast; }
  void SetEnhanceContrastToOff() { this->SetEnhanceContrast(ENHANCE_CONTRAST_OFF); }
  void SetEnhanceContrastToLIC() { this->SetEnhanceContrast(ENHANCE_CONTRAST_LIC); }
  void SetEnhanceContrastToColor() { this->SetEnhanceContrast(ENHANCE_CONTRAST_COLOR); }
  void SetEnhanceContrastToBoth() { this->SetEnhanceContrast(ENHANCE_CONTRAST_BOTH); }
  //@}

  /// Whether the LIC itself is stretched: ENHANCE_CONTRAST_LIC or _BOTH.
  bool EnhancesLICContrast() const;
  /// Whether the colours are stretched: ENHANCE_CONTRAST_COLOR or _BOTH.
  bool EnhancesColorContrast() const;

  //@{
  /**
   * See SetEnhanceContrast(); in [-1, 1], default 0. Below 0 the range is stretched less.
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
   * How often the LIC is smoothed, by a Gaussian of 3 x 3 pixels: 0, the default, to 1000.
   */
  void SetAntiAlias(int passes);
  int GetAntiAlias() const { return this->Values.AntiAlias; }
  vtkBooleanMacro(AntiAlias, int);
  //@}

  //@{
  /**
   * Vectors at most this long, in the units of the array, leave no streaks; default 0. Negative for
   * streaks of noise even where vectors are zero.
   */
  void SetMaskThreshold(double threshold);
  double GetMaskThreshold() const { return this->Values.MaskThreshold; }
  //@}

  //@{
  /**
   * Whether it is the vector's projection on the surface that SetMaskThreshold() is about, off by
   * default: the vector itself.
   */
  void SetMaskOnSurface(int onSurface);
  int GetMaskOnSurface() const { return this->Values.MaskOnSurface; }
  vtkBooleanMacro(MaskOnSurface, int);
  //@}

  //@{
  /**
   * Where there are no streaks, MaskColor's share of the colour: MaskIntensity, in [0, 1], default
   * 0; the rest is the surface's own. MaskColor: in [0, 1], default (0.5, 0.5, 0.5).
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
   * Vectors with a component of at least this magnitude, and those that are not finite, are
   * no-data; default 1e8, which covers the usual fill values (-1e9, 1e20, 1e30). Must be greater
   * than 0.
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
   * How the LIC is combined with the surface's colours: COLOR_MODE_BLEND (0, the default), LIC x
   * LICIntensity + colour x (1 - LICIntensity); COLOR_MODE_MAP (1), colour x (LIC + MapModeBias).
   * How scalars become colours is up to the mapper's own SetColorMode().
   */
  void SetColorMode(int mode);
  int GetColorMode() const { return this->Values.ColorMode; }
  void SetColorModeToBlend() { this->SetColorMode(COLOR_MODE_BLEND); }
  void SetColorModeToMap() { this->SetColorMode(COLOR_MODE_MAP); }
  //@}

  //@{
  /**
   * The LIC's share in COLOR_MODE_BLEND, in [0, 1], default 0.8.
   */
  void SetLICIntensity(double intensity);
  double GetLICIntensity() const { return this->Values.LICIntensity; }
  //@}

  //@{
  /**
   * Added to the LIC in COLOR_MODE_MAP, in [-1, 1], default 0.
   */
  void SetMapModeBias(double bias);
  double GetMapModeBias() const { return this->Values.MapModeBias; }
  //@}

  //@{
  /**
   * An image to use as noise, tiled from the lower left corner of the viewport or image: flat, of
   * the first component of its active scalars, in [0, 1] (unsigned char and unsigned short: shares
   * of the largest). nullptr, the default, for generated noise.
   */
  void SetNoiseDataSet(vtkImageData* image);
  vtkImageData* GetNoiseDataSet() const;
  //@}

  //@{
  /**
   * An image file to use as noise, of any format that vtkImageReader2Factory knows; nullptr, the
   * default, for none. A NoiseDataSet is used instead of it.
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
   * The noise that vtkLICNoiseSource generates. GenerateNoiseTexture off: always that of the
   * defaults; it is on by default. NoiseType: NOISE_TYPE_UNIFORM (0), _GAUSSIAN (1, the default) or
   * _PERLIN (2). NoiseTextureSize: pixels a side of what is tiled, 2 to 16384, default 200.
   * NoiseGrainSize: pixels a side of one value, at least 1 and less than NoiseTextureSize, default
   * 1. MinNoiseValue and MaxNoiseValue: in [0, 1], default 0 and 0.8, the first the smaller one.
   * NumberOfNoiseLevels: of different values, at least 2, default 256. ImpulseNoiseProbability: the
   * share of grains that have noise, in [0, 1], default 1; the others have
   * ImpulseNoiseBackgroundValue, in [0, 1], default 0. NoiseGeneratorSeed: default 1.
   *
   * Whether they fit together is checked when the noise is generated.
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
   * How VTK's parallel surface LIC divides the screen: COMPOSITE_INPLACE (0) to COMPOSITE_AUTO (3,
   * the default). It is kept for scripts that set it, and changes nothing: there is no parallel
   * rendering here.
   */
  void SetCompositeStrategy(int strategy);
  int GetCompositeStrategy() const { return this->Values.CompositeStrategy; }
  //@}

  /**
   * Take all settings of another object; NoiseDataSet is then the same image.
   */
  void ShallowCopy(vtkLICSettings* other);

  /**
   * Includes the modification time of the NoiseDataSet.
   */
  vtkMTimeType GetMTime() override;

  /**
   * For classes whose own setters call those of this object: apply a change (a function of these
   * settings) and report its errors on `holder`. C++ only.
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
  vtkObject* Holder = nullptr; // whose errors they are; this object if there is none
};

#endif
