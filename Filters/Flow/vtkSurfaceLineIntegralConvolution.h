// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceLineIntegralConvolution
 * @brief   line integral convolution on a surface, in object space
 *
 * The filter traces a streamline from each point of the mesh, downstream and upstream, and averages
 * a solid noise along it. The result does not depend on a camera and can be written to files. The
 * method follows Nellmeldin 2013, "Desarrollo de algoritmos de teselacion adaptativa en GPU",
 * section 9, but uses solid noise, which needs no texture coordinates and has no seams. The number
 * of threads does not change the result.
 *
 * Settings are those of a vtkLICSettings, which the filter can share with a mapper and other
 * filters. The setters of this class change that object, except for GrainSize and TextureSize,
 * which belong to the filter, and StepSize, which overrides the shared value.
 *
 * Input: a vtkPolyData with polygons or triangle strips and a point or cell array of 3 components.
 * To choose the array, call SetInputArrayToProcess(). The default is the active point vectors, then
 * the active cell vectors, then the first array of 3 components that is neither normals nor texture
 * coordinates. Coincident points are merged, so that streamlines cross seams of split meshes and
 * borders of blocks. Vectors are interpolated linearly in each triangle and projected to its plane.
 * Streamlines end at the border of the surface, at edges of more than two triangles, at triangles
 * without area or with missing data at a corner, where vectors are zero or perpendicular to the
 * surface, and where the vectors on both sides of an edge are opposite.
 *
 * Output 0 is the input with two point arrays: "LIC" (float, in [0, 1]), the active scalars, and
 * "LICMask" (unsigned char), which is 1 where "LIC" is unfiltered noise and 0 elsewhere. A point is
 * masked if
 *
 * - data is missing: a component is not finite or at least NoDataMagnitude in absolute value (for
 *   cell vectors, in all triangles at the point);
 * - the length of the vector (of all cell vectors at the point) is not greater than MaskThreshold,
 *   which by default masks zero vectors;
 * - no triangle at the point can be entered.
 *
 * Output 1 is an image of size TextureSize for vtkTexture, with unsigned char point scalars "LIC"
 * (255 for 1). It requires texture coordinates, and is empty if TextureSize is not set. Each texel
 * whose centre is inside of a triangle has the LIC at that position of the surface, at a resolution
 * that does not depend on the mesh. Other texels copy a nearby texel, so that interpolation shows
 * no borders. Texture coordinates beyond [0, 1] are ignored.
 *
 * The resolution of output 0 is that of the mesh. To get most detail from few triangles, refine the
 * mesh first with vtkAdaptiveRefinementFilter, with GeomorphingOff() in its recipe to get segments
 * of equal length, and a vtkCompositeDepthTagMetric in mode MAXIMUM of
 *
 * - vtkFieldVariationDepthTagMetric, for the angle and length of the vectors;
 * - vtkRegionDepthTagMetric, for a region of interest, such as the region in view;
 * - vtkScreenEdgeDepthTagMetric with ReferenceLength 10, for edges of at most 10 pixels.
 *
 * If the field is available everywhere, from a formula or with vtkProbeFilter, evaluate it again at
 * the refined points. Set GrainSize explicitly for refined meshes: noise finer than the triangles
 * aliases, and the automatic size changes with the mesh. For a coarse mesh, use the texture.
 *
 * The filter reports an error and produces empty outputs if there are no polygons; the vectors are
 * missing, or have a wrong number of components or tuples; TextureSize is set and there are no
 * texture coordinates in [0, 1]; the contrast enhancement factors add up to 1 or more; or memory is
 * insufficient. A setting out of range is an error and changes nothing.
 *
 * @sa vtkLICSettings vtkLineIntegralConvolution vtkAdaptiveRefinementFilter
 * vtkFieldVariationDepthTagMetric
 */
#ifndef vtkSurfaceLineIntegralConvolution_h
#define vtkSurfaceLineIntegralConvolution_h

#include "RelevoFiltersFlowModule.h" // for export macro
#include "vtkLICSettings.h"          // for enumerators
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <functional> // for loops
#include <string>     // for messages

class vtkImageData;
class vtkUnsignedCharArray;

#ifndef __VTK_WRAP__
namespace relevo
{
class SurfaceConvolution;
class SurfaceTexels;
class SurfaceVectors;
struct SurfaceField;
}
#endif

class RELEVOFILTERSFLOW_EXPORT vtkSurfaceLineIntegralConvolution : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceLineIntegralConvolution* New();
  vtkTypeMacro(vtkSurfaceLineIntegralConvolution, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the object with all settings except StepSize, GrainSize and TextureSize. nullptr creates
   * new default settings. The getter never returns nullptr.
   */
  void SetLICSettings(vtkLICSettings* settings);
  vtkLICSettings* GetLICSettings() const;
  //@}

  //@{
  /**
   * Set the number of steps of a streamline in each direction, 1 to 100000, default 20, which
   * averages 41 samples of noise. See vtkLICSettings.
   */
  void SetNumberOfSteps(int steps);
  int GetNumberOfSteps();
  //@}

  //@{
  /**
   * Set the length of a step in units of the point coordinates. Without NormalizeVectors, it is
   * multiplied by the length of the vector. 0 (default) is automatic: the StepSize of the
   * vtkLICSettings, by default 1, times the grain size; without NormalizeVectors, this is the step
   * for the longest vector. The value is not shared, because it depends on the mesh.
   */
  void SetStepSize(double size);
  vtkGetMacro(StepSize, double);
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
   * Set the distance of independent noise values, in units of the point coordinates. 0 (default) is
   * automatic: the mean edge length. The noise is anchored at the origin, so that adjacent meshes
   * with the same grain size match.
   */
  void SetGrainSize(double size);
  vtkGetMacro(GrainSize, double);
  //@}

  //@{
  /**
   * Set the seed of the random numbers; default 1. See vtkLICSettings.
   */
  void SetNoiseGeneratorSeed(int seed);
  int GetNoiseGeneratorSeed();
  //@}

  enum
  {
    ENHANCE_CONTRAST_OFF = vtkLICSettings::ENHANCE_CONTRAST_OFF,
    ENHANCE_CONTRAST_LIC = vtkLICSettings::ENHANCE_CONTRAST_LIC
  };

  //@{
  /**
   * Set the contrast enhancement: ENHANCE_CONTRAST_OFF (0, default), or ENHANCE_CONTRAST_LIC (1),
   * which maps values with (L - m) / (M - m) so that the smallest value of the points that are not
   * masked becomes 0 and the largest 1. The texture uses the same mapping. The colour contrast of
   * shared settings is ignored. See vtkLICSettings.
   */
  void SetEnhanceContrast(int mode);
  int GetEnhanceContrast();
  void SetEnhanceContrastToOff() { this->SetEnhanceContrast(ENHANCE_CONTRAST_OFF); }
  void SetEnhanceContrastToLIC() { this->SetEnhanceContrast(ENHANCE_CONTRAST_LIC); }
  //@}

  //@{
  /**
   * Set how much further the contrast is enhanced: m = min + low * (max - min) and M = max - high *
   * (max
   * - min), with the result clamped to [0, 1]. Each factor is in [-1, 1], default 0, and their sum
   *   must be less than 1. See vtkLICSettings.
   */
  void SetLowLICContrastEnhancementFactor(double factor);
  double GetLowLICContrastEnhancementFactor();
  void SetHighLICContrastEnhancementFactor(double factor);
  double GetHighLICContrastEnhancementFactor();
  //@}

  //@{
  /**
   * Set the vector length, in units of the array, up to which points are masked; default 0. A
   * negative value does not mask zero vectors. Streamlines continue through masked points. See
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
   * upstream, so that the streak of a bright grain gets brighter downstream. See vtkLICSettings.
   */
  void SetOrientedLIC(bool oriented);
  bool GetOrientedLIC();
  vtkBooleanMacro(OrientedLIC, bool);
  //@}

  //@{
  /**
   * Set the phase of an animation; default 0. While the phase grows by 1, the pattern moves 3 *
   * NumberOfSteps + 1 steps downstream and fades into its initial state. All integers give the same
   * result. See vtkLICSettings.
   */
  void SetPhase(double phase);
  double GetPhase();
  //@}

  //@{
  /**
   * Set width and height in texels of output 1, each 1 to 16384. 0 and 0 (default) disable it.
   */
  void SetTextureSize(int width, int height);
  void SetTextureSize(const int size[2]) { this->SetTextureSize(size[0], size[1]); }
  vtkGetVector2Macro(TextureSize, int);
  //@}

  /// Include the modification time of the settings.
  vtkMTimeType GetMTime() override;

protected:
  vtkSurfaceLineIntegralConvolution();
  ~vtkSurfaceLineIntegralConvolution() override;

  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double StepSize = 0.0;
  double GrainSize = 0.0;
  int TextureSize[2] = { 0, 0 };

private:
  vtkSurfaceLineIntegralConvolution(const vtkSurfaceLineIntegralConvolution&) = delete;
  void operator=(const vtkSurfaceLineIntegralConvolution&) = delete;

#ifndef __VTK_WRAP__
  bool Run(vtkPolyData* input, const relevo::SurfaceField& field, vtkPolyData* output,
    vtkImageData* texture);
  void MaskPoints(vtkPolyData* input, const relevo::SurfaceField& field,
    const relevo::SurfaceVectors& vectors, vtkUnsignedCharArray* mask);
  bool ConvolveTexels(const relevo::SurfaceTexels& texels, const relevo::SurfaceVectors& vectors,
    const relevo::SurfaceConvolution& convolution, const std::function<float(float)>& contrast,
    vtkImageData* texture);
  bool ForParts(vtkIdType size, double shareFrom, double shareTo,
    const std::function<void(vtkIdType, vtkIdType)>& work);
#endif

  vtkSmartPointer<vtkLICSettings> LICSettings;
};

#endif
