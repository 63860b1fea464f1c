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
 * screen. The settings are one object, vtkLICSettings, with the names and defaults of VTK's
 * vtkSurfaceLICInterface: GetLICInterface() returns it, and the setters here change it. Lengths are
 * in pixels of the window. The recipe is by default one of MaximumLevel 0: the mesh is drawn as it
 * is, as by VTK's vtkSurfaceLICMapper. To have levels follow the field, give the recipe a
 * vtkCompositeDepthTagMetric, mode MAXIMUM, of vtkFieldVariationDepthTagMetric and
 * vtkScreenEdgeDepthTagMetric, and MaximumLevel 3: field variation ignores the size on the screen,
 * and each further level quadruples the triangles where it is high.
 *
 * The vectors are chosen by SetInputArrayToProcess(0, 0, 0, association, name): an array of three
 * components, or of two (x and y), of points (interpolated linearly) or of cells (constant in each
 * cell); by default the active vectors, of points if there are any. Where there is nothing to
 * follow the surface is drawn without streaks, see SetMaskThreshold(): no-data (not finite, or a
 * component of at least NoDataMagnitude), zero, and vectors that are perpendicular to the surface.
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
 * Recommended where colours encode data: SetColorModeToMultiply(), SetEnhanceContrastToLIC() and
 * SetMapModeBias(0.3).
 *
 * Needs textures of floating point numbers that can be drawn to (OpenGL 3.0). Errors (ErrorEvent of
 * this object; the surface is drawn without streaks): no vectors, another number of components,
 * nothing but no-data, noise that cannot be made or read, low and high factors of a contrast in use
 * whose sum is 1 or more, an older OpenGL. A setting out of its range is an error and changes
 * nothing.
 *
 * @sa vtkLICSettings vtkLineIntegralConvolution vtkSurfaceLineIntegralConvolution
 * vtkFieldVariationDepthTagMetric
 */
#ifndef vtkAdaptiveLICMapper_h
#define vtkAdaptiveLICMapper_h

#include "RelevoRenderingFlowModule.h" // for export macro
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkLICSettings.h"  // for enumerators
#include "vtkSmartPointer.h" // for members

#include <memory> // for vtkInternals

class vtkImageData;
class vtkMultiProcessController;

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
   * All settings of the streaks; never nullptr: a nullptr gives the mapper new ones with their
   * defaults. Several mappers and filters can share an object, and ShallowCopy() shares it. They
   * are part of the mapper: its GetMTime() counts them. GetLICInterface() is what
   * vtkSurfaceLICMapper calls it.
   */
  void SetLICSettings(vtkLICSettings* settings);
  vtkLICSettings* GetLICSettings() const;
  vtkLICSettings* GetLICInterface() const { return this->GetLICSettings(); }
  //@}

  //@{
  /**
   * Whether there are streaks at all, on by default. See vtkLICSettings.
   */
  void SetEnable(int enable);
  int GetEnable();
  vtkBooleanMacro(Enable, int);
  //@}

  //@{
  /**
   * Streamlines: how many steps each way (default 20) of how many pixels (default 1), all equally
   * long (on) or as long as vectors. See vtkLICSettings.
   */
  void SetNumberOfSteps(int steps);
  int GetNumberOfSteps();
  void SetStepSize(double size);
  double GetStepSize();
  void SetNormalizeVectors(int normalize);
  int GetNormalizeVectors();
  vtkBooleanMacro(NormalizeVectors, int);
  //@}

  //@{
  /**
   * Whether noise is convolved twice (on), streaks have heads (off), and how far they have moved,
   * in loops (0). See vtkLICSettings.
   */
  void SetEnhancedLIC(int enhanced);
  int GetEnhancedLIC();
  vtkBooleanMacro(EnhancedLIC, int);
  void SetOrientedLIC(int oriented);
  int GetOrientedLIC();
  vtkBooleanMacro(OrientedLIC, int);
  void SetPhase(double phase);
  double GetPhase();
  //@}

  enum
  {
    ENHANCE_CONTRAST_OFF = vtkLICSettings::ENHANCE_CONTRAST_OFF,
    ENHANCE_CONTRAST_LIC = vtkLICSettings::ENHANCE_CONTRAST_LIC,
    ENHANCE_CONTRAST_COLOR = vtkLICSettings::ENHANCE_CONTRAST_COLOR,
    ENHANCE_CONTRAST_BOTH = vtkLICSettings::ENHANCE_CONTRAST_BOTH
  };

  //@{
  /**
   * Whether the range of greys (1), of the lightness of colours (3) or of both (4) is stretched; by
   * default of neither (0). The factors are the shares of the range that are cut off at its ends,
   * default 0. AntiAlias: how often the LIC is smoothed, default 0. See vtkLICSettings.
   */
  void SetEnhanceContrast(int mode);
  int GetEnhanceContrast();
  void SetEnhanceContrastToOff() { this->SetEnhanceContrast(ENHANCE_CONTRAST_OFF); }
  void SetEnhanceContrastToLIC() { this->SetEnhanceContrast(ENHANCE_CONTRAST_LIC); }
  void SetEnhanceContrastToColor() { this->SetEnhanceContrast(ENHANCE_CONTRAST_COLOR); }
  void SetEnhanceContrastToBoth() { this->SetEnhanceContrast(ENHANCE_CONTRAST_BOTH); }
  void SetLowLICContrastEnhancementFactor(double factor);
  double GetLowLICContrastEnhancementFactor();
  void SetHighLICContrastEnhancementFactor(double factor);
  double GetHighLICContrastEnhancementFactor();
  void SetLowColorContrastEnhancementFactor(double factor);
  double GetLowColorContrastEnhancementFactor();
  void SetHighColorContrastEnhancementFactor(double factor);
  double GetHighColorContrastEnhancementFactor();
  void SetAntiAlias(int passes);
  int GetAntiAlias();
  vtkBooleanMacro(AntiAlias, int);
  //@}

  //@{
  /**
   * Where there are no streaks: for vectors at most MaskThreshold long (0), or projected on the
   * surface (off), and for no-data, of NoDataMagnitude (1e8) or more. MaskIntensity (0) is
   * MaskColor's share of the colour there. See vtkLICSettings.
   */
  void SetMaskThreshold(double threshold);
  double GetMaskThreshold();
  void SetMaskOnSurface(int onSurface);
  int GetMaskOnSurface();
  vtkBooleanMacro(MaskOnSurface, int);
  void SetMaskColor(double red, double green, double blue);
  void SetMaskColor(const double color[3]) { this->SetMaskColor(color[0], color[1], color[2]); }
  double* GetMaskColor() VTK_SIZEHINT(3);
  void GetMaskColor(double color[3]);
  void GetMaskColor(double& red, double& green, double& blue);
  void SetMaskIntensity(double intensity);
  double GetMaskIntensity();
  void SetNoDataMagnitude(double magnitude);
  double GetNoDataMagnitude();
  //@}

  //@{
  /**
   * How the LIC is combined with the surface's colours: blended, with LICIntensity (0.8) as its
   * share (the default), or multiplied with them, after MapModeBias (0) has been added; "map" is
   * VTK's word for that. The setting itself is ColorMode of GetLICInterface(). SetColorMode() of
   * the mapper, SetColorModeToDefault() and its like are vtkMapper's, and about how scalars become
   * colours.
   */
  void SetColorModeToBlend();
  void SetColorModeToMultiply();
  void SetColorModeToMap();
  void SetLICIntensity(double intensity);
  double GetLICIntensity();
  void SetMapModeBias(double bias);
  double GetMapModeBias();
  //@}

  //@{
  /**
   * An image, or an image file, to use as noise; both nullptr, the default, for generated noise.
   * See vtkLICSettings.
   */
  void SetNoiseDataSet(vtkImageData* image);
  vtkImageData* GetNoiseDataSet();
  void SetNoiseFileName(const char* name);
  const char* GetNoiseFileName();
  //@}

  enum
  {
    NOISE_TYPE_UNIFORM = vtkLICSettings::NOISE_TYPE_UNIFORM,
    NOISE_TYPE_GAUSSIAN = vtkLICSettings::NOISE_TYPE_GAUSSIAN,
    NOISE_TYPE_PERLIN = vtkLICSettings::NOISE_TYPE_PERLIN
  };

  //@{
  /**
   * The noise that vtkLICNoiseSource generates. See vtkLICSettings for ranges and defaults.
   */
  void SetGenerateNoiseTexture(int generate);
  int GetGenerateNoiseTexture();
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
   * Includes the modification time of the settings.
   */
  vtkMTimeType GetMTime() override;

  /**
   * How often noise has been convolved since the mapper was made, for all renderers and actors.
   * Several cameras, as vtkWindowToImageFilter makes copies, are several views.
   */
  vtkGetMacro(NumberOfConvolutions, vtkIdType);

  //@{
  /**
   * For processes that draw one picture together, each its part of the surface: their controller,
   * which a representation of the plugin for ParaView sets; nullptr, the default, or one of a
   * single process where this process draws all. Streaks then go on from process to process, if all
   * of them call PrepareParallelFrame() before each picture, in the same order and with the same
   * settings, camera and size of the viewport, those that have nothing to draw, too. It composites
   * the vectors by depth and convolves them as far as this process needs them, unless nothing has
   * changed on any process. An error of one process leaves all without streaks; a part that has no
   * array of vectors is drawn without.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  void PrepareParallelFrame(vtkRenderer* ren, vtkActor* act);
  //@}

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
  bool DrawsAllBlocks() const override;
  void BuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  void ExtendShaders(const vtkOpenGLHelper* cellBO, relevo::ShaderExtension& extension) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;

  vtkIdType NumberOfConvolutions = 0;

private:
  vtkAdaptiveLICMapper(const vtkAdaptiveLICMapper&) = delete;
  void operator=(const vtkAdaptiveLICMapper&) = delete;

  relevo::LICArray FindArray(vtkPolyData* input);

  struct vtkInternals;
  friend struct vtkInternals;
  vtkSmartPointer<vtkLICSettings> LICSettings;
  std::unique_ptr<vtkInternals> LIC;
};

#endif
