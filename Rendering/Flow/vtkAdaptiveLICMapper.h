// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveLICMapper
 * @brief   shows a vector field on a refined surface by line integral convolution
 *
 * This vtkAdaptiveRefinementMapper draws streaks along a vector field on its surface. Noise is
 * convolved along the streamlines in screen space (after Laramee, Jobard and Hauser, Image Space
 * Based Visualization of Unsteady Flow on Surfaces, 2003). The vectors follow the surface through
 * refinement and displacement. At each pixel they are projected onto the tangent plane and then
 * onto the screen. The settings are one object, vtkLICSettings, with the names and defaults of
 * VTK's vtkSurfaceLICInterface. GetLICInterface() returns it, and the setters of this class change
 * it. Lengths are in pixels of the window.
 *
 * The default recipe has MaximumLevel 0: the mesh is drawn unrefined, as by VTK's
 * vtkSurfaceLICMapper. To make levels follow the field, set MaximumLevel 3 and a
 * vtkCompositeDepthTagMetric of mode MAXIMUM that combines vtkFieldVariationDepthTagMetric and
 * vtkScreenEdgeDepthTagMetric. Field variation ignores the size on the screen, so each further
 * level quadruples the triangles where the variation is high.
 *
 * SetInputArrayToProcess(0, 0, 0, association, name) selects the vectors: an array with three
 * components, or with two (x and y), of points (interpolated linearly) or of cells (constant in
 * each cell). The default is the active vectors, of points if there are any. The surface is drawn
 * without streaks where vectors are missing (not finite, or with a component of at least
 * NoDataMagnitude), zero, or perpendicular to the surface; see SetMaskThreshold().
 *
 * The streaks are combined with the surface's lit colours. A white actor without lighting and with
 * LICIntensity 1 shows the grey LIC itself. Opacity, depth peeling, clipping planes, textures,
 * representations and picking work as with other mappers. Where several translucent layers overlap,
 * the front layer has streaks. Wireframes and points have no streaks; edges are drawn over streaks.
 * If a window is captured in tiles (vtkWindowToImageFilter with a scale), the noise continues from
 * tile to tile, but streamlines end at tile borders.
 *
 * The convolution is cached until the camera, the viewport, the actor's matrix, the input, the
 * recipe or the settings change; GetNumberOfConvolutions() counts the convolutions. It needs about
 * 36 bytes per pixel of the viewport, 52 if the contrast of colours is enhanced; see
 * GetGraphicsMemorySize().
 *
 * If colours encode data, use SetColorModeToMultiply(), SetEnhanceContrastToLIC() and
 * SetMapModeBias(0.3).
 *
 * Requires floating-point colour attachments (OpenGL 3.0). These are errors (ErrorEvent of this
 * object): no vectors, a wrong number of components, an array without any valid vector, noise that
 * cannot be generated or read, a low and a high contrast factor in use whose sum is 1 or more, and
 * an older OpenGL. The surface is then drawn without streaks. A setting out of its range is an
 * error and changes nothing.
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
   * Set the settings of the streaks. nullptr creates new settings with default values, so that Get
   * never returns nullptr. Several mappers and filters can share the object, and ShallowCopy()
   * shares it. The mapper's GetMTime() includes the settings. GetLICInterface() has the name that
   * vtkSurfaceLICMapper uses.
   */
  void SetLICSettings(vtkLICSettings* settings);
  vtkLICSettings* GetLICSettings() const;
  vtkLICSettings* GetLICInterface() const { return this->GetLICSettings(); }
  //@}

  //@{
  /**
   * Set whether streaks are drawn. On by default. See vtkLICSettings.
   */
  void SetEnable(int enable);
  int GetEnable();
  vtkBooleanMacro(Enable, int);
  //@}

  //@{
  /**
   * Set the number of steps along a streamline in each direction (default 20), the length of a step
   * in pixels (default 1), and whether all steps are equally long (on, the default) or proportional
   * to the vectors (off). See vtkLICSettings.
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
   * Set whether noise is convolved twice (default on), whether streaks have heads that show the
   * direction (default off), and how far the pattern has moved along the flow, in loops (default
   * 0). See vtkLICSettings.
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
   * Set whether the range of greys (1), of the lightness of colours (3) or of both (4) is
   * stretched. The default is neither (0). The factors are the fractions of the range that are cut
   * off at its two ends; the default is 0. AntiAlias is the number of smoothing passes; the default
   * is 0. See vtkLICSettings.
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
   * Set where no streaks are drawn: for vectors of length MaskThreshold (default 0) or less,
   * measured on the surface if MaskOnSurface is on (default off), and for vectors with a component
   * of NoDataMagnitude (default 1e8) or more. MaskIntensity (default 0) is the fraction of
   * MaskColor there. See vtkLICSettings.
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
   * Set how the LIC is combined with the surface's colours. Blend (the default) mixes them, with
   * LICIntensity (default 0.8) as the fraction of the LIC. Multiply multiplies them, after
   * MapModeBias (default 0) has been added to the LIC; Map is VTK's name for the same mode. The
   * mode is ColorMode of GetLICInterface(). This mapper's SetColorMode(), SetColorModeToDefault()
   * and so on are those of vtkMapper: they set how scalars are mapped to colours.
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
   * Set an image, or an image file, to use as noise. Both are nullptr by default: the noise is
   * generated. See vtkLICSettings.
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
   * Set the noise that vtkLICNoiseSource generates. See vtkLICSettings for ranges and defaults.
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
   * Return how often noise has been convolved since the mapper was created, for all renderers and
   * actors. Each camera counts separately, including the copies that vtkWindowToImageFilter makes.
   */
  vtkGetMacro(NumberOfConvolutions, vtkIdType);

  //@{
  /**
   * Set the controller of the processes that draw an image together, each with a part of the
   * surface. With nullptr (the default) or a controller of one process, this process draws alone.
   * The representation of the ParaView plugin sets it.
   *
   * Streaks continue across processes if all processes call PrepareParallelFrame() before each
   * image, in the same order and with the same settings, camera and viewport size. Processes that
   * draw nothing must call it, too. It composites the vectors by depth and convolves the region
   * that this process needs, unless nothing has changed on any process. If one process has an
   * error, no process draws streaks. A part without the array of vectors is drawn without streaks.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  void PrepareParallelFrame(vtkRenderer* ren, vtkActor* act);
  //@}

  /**
   * Return the number of bytes on the GPU, including images of the viewport's size.
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
