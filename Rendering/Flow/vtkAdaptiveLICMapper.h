// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveLICMapper
 * @brief   shows a vector field on the refined surface by line integral convolution
 *
 * A vtkAdaptiveRefinementMapper whose surface carries streaks along a vector field: noise is
 * convolved along the streamlines on the screen (after Laramee, Jobard and Hauser, Image Space
 * Based Visualization of Unsteady Flow on Surfaces, 2003). Vectors go with the surface through
 * refinement and displacement and are projected on its tangent plane, pixel by pixel, then on the
 * screen. Names and defaults are those of VTK's vtkSurfaceLICInterface, here on the mapper itself;
 * lengths are in pixels of the window. To have levels follow the field, give the recipe a
 * vtkCompositeDepthTagMetric, mode MAXIMUM, of vtkFieldVariationDepthTagMetric and
 * vtkScreenEdgeDepthTagMetric, and MaximumLevel 3: the variation knows nothing of pixels, and each
 * level more makes four times the triangles where it is high.
 *
 * The vectors are chosen by SetInputArrayToProcess(0, 0, 0, association, name): an array of three
 * components, or of two (x and y), of points (interpolated linearly) or of cells (constant in each
 * cell); by default the active vectors, of points if there are any. Where there is nothing to
 * follow the surface is drawn without streaks, see SetMaskThreshold(): no-data (not finite, or a
 * component of at least NoDataMagnitude), zero, and vectors that stand on the surface.
 *
 * The streaks are combined with the colours that the surface has otherwise, lit: a white actor
 * without lighting and LICIntensity 1 shows the grey LIC itself. Opacity, depth peeling, clipping
 * planes, textures, representations and picking are those of any other mapper. Where several layers
 * show through each other, the one in front has streaks. Wireframes and points have none;
 * edges are drawn over streaks. In a picture that a window draws in parts (vtkWindowToImageFilter
 * with a scale) the noise goes on from part to part, but streamlines end at their borders.
 *
 * The convolution is kept until the camera, the viewport, the actor's place, the input, the recipe
 * or the settings change; GetNumberOfConvolutions() counts. It costs memory for the viewport: about
 * 36 bytes a pixel, 52 with the contrast of colours enhanced, see GetGraphicsMemorySize().
 *
 * What suits colours that mean something: SetColorModeToMultiply(), SetEnhanceContrastToLIC() and
 * SetMapModeBias(0.3).
 *
 * Needs textures of floating point numbers that can be drawn to (OpenGL 3.0). Errors (ErrorEvent of
 * this object; the surface is drawn without streaks): no vectors, another number of components,
 * nothing but no-data, noise that cannot be made or read, an older OpenGL. A setting out of its
 * range is an error and changes nothing.
 *
 * @sa vtkLineIntegralConvolution vtkSurfaceLineIntegralConvolution vtkFieldVariationDepthTagMetric
 */
#ifndef vtkAdaptiveLICMapper_h
#define vtkAdaptiveLICMapper_h

#include "RelevoRenderingFlowModule.h" // for export macro
#include "vtkAdaptiveRefinementMapper.h"

#include <memory> // for vtkInternals

class vtkImageData;

namespace relevo
{
struct LICArray;
}

class RELEVORENDERINGFLOW_EXPORT vtkAdaptiveLICMapper : public vtkAdaptiveRefinementMapper
{
public:
  static vtkAdaptiveLICMapper* New();
  vtkTypeMacro(vtkAdaptiveLICMapper, vtkAdaptiveRefinementMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Whether there are streaks at all, on by default.
   */
  void SetEnable(int enable);
  vtkGetMacro(Enable, int);
  vtkBooleanMacro(Enable, int);
  //@}

  //@{
  /**
   * Steps of a streamline each way, at least 1, default 20.
   */
  void SetNumberOfSteps(int steps);
  vtkGetMacro(NumberOfSteps, int);
  //@}

  //@{
  /**
   * Length of a step in pixels, above 0, default 1. Where vectors are not normalised, of a vector
   * that is 1 unit long on the screen's plane.
   */
  void SetStepSize(double size);
  vtkGetMacro(StepSize, double);
  //@}

  //@{
  /**
   * Whether all vectors count as equally long, on by default. Off: steps are as long as vectors,
   * and so are streaks.
   */
  void SetNormalizeVectors(int normalize);
  vtkGetMacro(NormalizeVectors, int);
  vtkBooleanMacro(NormalizeVectors, int);
  //@}

  //@{
  /**
   * Whether the result, with its edges sharpened, is convolved once more, with half as many steps;
   * on by default (Okada and Kao, Enhanced Line Integral Convolution with Flow Feature Detection,
   * 1997).
   */
  void SetEnhancedLIC(int enhanced);
  vtkGetMacro(EnhancedLIC, int);
  vtkBooleanMacro(EnhancedLIC, int);
  //@}

  //@{
  /**
   * Whether streaks tell the direction too, off by default: weights fall off upstream, so what
   * flows from a dot fades out towards its tail (Wegenkittl, Groeller and Purgathofer, Animating
   * Flow Fields: Rendering of Oriented Line Integral Convolution, 1997). Best without EnhancedLIC
   * and with sparse noise: SetNoiseType(NOISE_TYPE_UNIFORM), SetImpulseNoiseProbability(0.02),
   * SetNoiseGrainSize(3), and either light dots (SetMinNoiseValue(0.9)) or dark ones
   * (SetMaxNoiseValue(0.02), SetImpulseNoiseBackgroundValue(1)).
   */
  void SetOrientedLIC(int oriented);
  vtkGetMacro(OrientedLIC, int);
  vtkBooleanMacro(OrientedLIC, int);
  //@}

  //@{
  /**
   * How far the pattern has moved down the flow, in loops of 3 NumberOfSteps + 1 steps; default 0.
   * Whole numbers look alike, so phases i / n for i = 0 ... n - 1 make an animation without a seam.
   */
  void SetPhase(double phase);
  vtkGetMacro(Phase, double);
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
   * (ENHANCE_CONTRAST_BOTH, 4); neither (ENHANCE_CONTRAST_OFF, 0, the default). m and M become 0
   * and 1, m being the least value on the surface plus the low factor's share of the range, M the
   * largest less the high factor's.
   */
  void SetEnhanceContrast(int mode);
  vtkGetMacro(EnhanceContrast, int);
  void SetEnhanceContrastToOff() { this->SetEnhanceContrast(ENHANCE_CONTRAST_OFF); }
  void SetEnhanceContrastToLIC() { this->SetEnhanceContrast(ENHANCE_CONTRAST_LIC); }
  void SetEnhanceContrastToColor() { this->SetEnhanceContrast(ENHANCE_CONTRAST_COLOR); }
  void SetEnhanceContrastToBoth() { this->SetEnhanceContrast(ENHANCE_CONTRAST_BOTH); }
  //@}

  //@{
  /**
   * See SetEnhanceContrast(); in [0, 1], default 0.
   */
  void SetLowLICContrastEnhancementFactor(double factor);
  vtkGetMacro(LowLICContrastEnhancementFactor, double);
  void SetHighLICContrastEnhancementFactor(double factor);
  vtkGetMacro(HighLICContrastEnhancementFactor, double);
  void SetLowColorContrastEnhancementFactor(double factor);
  vtkGetMacro(LowColorContrastEnhancementFactor, double);
  void SetHighColorContrastEnhancementFactor(double factor);
  vtkGetMacro(HighColorContrastEnhancementFactor, double);
  //@}

  //@{
  /**
   * How often the LIC is smoothed, by a Gaussian of 3 x 3 pixels; default 0.
   */
  void SetAntiAlias(int passes);
  vtkGetMacro(AntiAlias, int);
  vtkBooleanMacro(AntiAlias, int);
  //@}

  //@{
  /**
   * Vectors at most this long, in the units of the array, leave no streaks; default 0. Negative for
   * streaks of noise even where vectors are zero.
   */
  void SetMaskThreshold(double threshold);
  vtkGetMacro(MaskThreshold, double);
  //@}

  //@{
  /**
   * Whether it is the vector's projection on the surface that SetMaskThreshold() is about, off by
   * default: the vector itself.
   */
  void SetMaskOnSurface(int onSurface);
  vtkGetMacro(MaskOnSurface, int);
  vtkBooleanMacro(MaskOnSurface, int);
  //@}

  //@{
  /**
   * Where there are no streaks, MaskColor's share of the colour: MaskIntensity, in [0, 1], default
   * 0; the rest is the surface's own. MaskColor: default (0.5, 0.5, 0.5).
   */
  void SetMaskColor(double red, double green, double blue);
  void SetMaskColor(const double color[3]) { this->SetMaskColor(color[0], color[1], color[2]); }
  vtkGetVector3Macro(MaskColor, double);
  void SetMaskIntensity(double intensity);
  vtkGetMacro(MaskIntensity, double);
  //@}

  //@{
  /**
   * Vectors with a component of at least this magnitude, and those that are not finite, are
   * no-data; default 1e8, which takes in the usual marks (-1e9, 1e20, 1e30). Above 0.
   */
  void SetNoDataMagnitude(double magnitude);
  vtkGetMacro(NoDataMagnitude, double);
  //@}

  enum
  {
    COLOR_MODE_BLEND = 0,
    COLOR_MODE_MAP = 1
  };

#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Woverloaded-virtual"
#endif
  //@{
  /**
   * How the LIC is combined with the surface's colours: COLOR_MODE_BLEND (0, the default), LIC x
   * LICIntensity + colour x (1 - LICIntensity); COLOR_MODE_MAP (1), colour x (LIC + MapModeBias).
   * How scalars become colours is up to SetColorModeToDefault(), SetColorModeToMapScalars() and
   * SetColorModeToDirectScalars(), and through a pointer to a vtkMapper to its SetColorMode(),
   * which this one hides and does not override.
   */
  void SetColorMode(const int& mode);
  int GetColorMode() const
  {
    return this->LICColorMode;
  }
  void SetColorModeToBlend()
  {
    this->SetColorMode(COLOR_MODE_BLEND);
  }
  void SetColorModeToMultiply()
  {
    this->SetColorMode(COLOR_MODE_MAP);
  }
  void SetColorModeToMap()
  {
    this->SetColorMode(COLOR_MODE_MAP);
  }
  //@}
#ifdef __clang__
#pragma clang diagnostic pop
#endif

  //@{
  /**
   * The LIC's share in COLOR_MODE_BLEND, in [0, 1], default 0.8.
   */
  void SetLICIntensity(double intensity);
  vtkGetMacro(LICIntensity, double);
  //@}

  //@{
  /**
   * Added to the LIC in COLOR_MODE_MAP, in [-1, 1], default 0.
   */
  void SetMapModeBias(double bias);
  vtkGetMacro(MapModeBias, double);
  //@}

  //@{
  /**
   * An image to take for noise, tiled from the viewport's lower left corner: flat, of the first
   * component of its active scalars, in [0, 1] (unsigned char and unsigned short: shares of the
   * largest). nullptr, the default, for generated noise.
   */
  void SetNoiseDataSet(vtkImageData* image);
  vtkImageData* GetNoiseDataSet();
  //@}

  //@{
  /**
   * An image file to take for noise, of any format that vtkImageReader2Factory knows; unset by
   * default. SetNoiseDataSet() goes before it.
   */
  void SetNoiseFileName(const char* name);
  const char* GetNoiseFileName();
  //@}

  enum
  {
    NOISE_TYPE_UNIFORM = 0,
    NOISE_TYPE_GAUSSIAN = 1,
    NOISE_TYPE_PERLIN = 2
  };

  //@{
  /**
   * The noise that is generated, by vtkLICNoiseSource; there are the ranges. GenerateNoiseTexture
   * off: always that of the defaults; it is on by default. NoiseType: NOISE_TYPE_UNIFORM (0),
   * _GAUSSIAN (1, the default) or _PERLIN (2). NoiseTextureSize: pixels a side of what is tiled,
   * default 200. NoiseGrainSize: pixels a side of one value, default 1. MinNoiseValue and
   * MaxNoiseValue: in [0, 1], default 0 and 0.8. NumberOfNoiseLevels: of different values, default
   * 256. ImpulseNoiseProbability: the share of grains that have noise, default 1; the others have
   * ImpulseNoiseBackgroundValue, default 0. NoiseGeneratorSeed: default 1.
   */
  void SetGenerateNoiseTexture(int generate);
  vtkGetMacro(GenerateNoiseTexture, int);
  vtkBooleanMacro(GenerateNoiseTexture, int);
  void SetNoiseType(int type);
  int GetNoiseType();
  void SetNoiseTextureSize(int length);
  int GetNoiseTextureSize();
  void SetNoiseGrainSize(int length);
  int GetNoiseGrainSize();
  void SetMinNoiseValue(double value);
  double GetMinNoiseValue();
  void SetMaxNoiseValue(double value);
  double GetMaxNoiseValue();
  void SetNumberOfNoiseLevels(int levels);
  int GetNumberOfNoiseLevels();
  void SetImpulseNoiseProbability(double probability);
  double GetImpulseNoiseProbability();
  void SetImpulseNoiseBackgroundValue(double value);
  double GetImpulseNoiseBackgroundValue();
  void SetNoiseGeneratorSeed(int seed);
  int GetNoiseGeneratorSeed();
  //@}

  /**
   * How often noise has been convolved since the mapper was made, for all renderers and actors.
   * Several cameras, as vtkWindowToImageFilter makes copies, are several views.
   */
  vtkGetMacro(NumberOfConvolutions, vtkIdType);

  /**
   * With the images of the size of the viewport.
   */
  vtkTypeInt64 GetGraphicsMemorySize() override;

  void RenderPieceDraw(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceFinish(vtkRenderer* ren, vtkActor* act) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkAdaptiveLICMapper();
  ~vtkAdaptiveLICMapper() override;

  void RenderRefined(vtkRenderer* ren, vtkActor* act) override;
  void UpdateBlocks() override;
  void BuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  void ExtendShaders(
    const vtkOpenGLHelper* cellBO, relevo::RefinementShaderOptions& options) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;

  int Enable = 1;
  int NumberOfSteps = 20;
  double StepSize = 1.0;
  int NormalizeVectors = 1;
  int EnhancedLIC = 1;
  int OrientedLIC = 0;
  double Phase = 0.0;
  int EnhanceContrast = ENHANCE_CONTRAST_OFF;
  double LowLICContrastEnhancementFactor = 0.0;
  double HighLICContrastEnhancementFactor = 0.0;
  double LowColorContrastEnhancementFactor = 0.0;
  double HighColorContrastEnhancementFactor = 0.0;
  int AntiAlias = 0;
  double MaskThreshold = 0.0;
  int MaskOnSurface = 0;
  double MaskColor[3] = { 0.5, 0.5, 0.5 };
  double MaskIntensity = 0.0;
  double NoDataMagnitude = 1e8;
  int LICColorMode = COLOR_MODE_BLEND;
  double LICIntensity = 0.8;
  double MapModeBias = 0.0;
  int GenerateNoiseTexture = 1;
  vtkIdType NumberOfConvolutions = 0;

private:
  vtkAdaptiveLICMapper(const vtkAdaptiveLICMapper&) = delete;
  void operator=(const vtkAdaptiveLICMapper&) = delete;

  relevo::LICArray FindArray(vtkPolyData* input);

  struct vtkInternals;
  friend struct vtkInternals;
  std::unique_ptr<vtkInternals> LIC;
};

#endif
