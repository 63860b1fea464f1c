// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceLineIntegralConvolution
 * @brief   shows the directions of vectors on a surface: solid noise, blurred along streamlines
 *
 * Line integral convolution in object space: a streamline is traced from every point of the mesh,
 * downstream and upstream, and the noise along it is averaged. The result does not depend on a
 * camera and can be written to files. After Nellmeldin 2013, "Desarrollo de algoritmos de
 * teselacion adaptativa en GPU", section 9, with noise that fills space, so that there are neither
 * seams nor texture coordinates to be made. The number of threads does not change the result.
 *
 * Settings are those of its vtkLICSettings, which it can share with a mapper and other filters, but
 * for GrainSize and TextureSize, which are its own, and StepSize, which overrides theirs. The other
 * setters here change that object.
 *
 * Input: a vtkPolyData with polygons or triangle strips of any size and a point or cell array of 3
 * components: by SetInputArrayToProcess(0, ...), or the active vectors, of the points if they have
 * some, else of the cells, or the first array of 3 components that is neither normals nor texture
 * coordinates. Points at the same coordinates are one place, so that lines cross the seams of split
 * meshes and the borders of blocks. Between the points of a triangle vectors are interpolated
 * linearly; what counts is their part in the triangle's plane. Lines end where the surface does,
 * where more than two triangles share an edge, at triangles without area or with a corner without
 * data, where the vectors are zero or perpendicular to the surface, and where they meet head-on.
 *
 * Output 0: the input with the float point array "LIC", in [0, 1], as active scalars, and the
 * unsigned char point array "LICMask": 1 where the value is the noise as it is, since there is no
 * LIC, and 0 elsewhere. Masked are points
 *
 * - without data: a component is not finite or at least NoDataMagnitude in absolute value (of cell
 *   vectors: in all triangles at the point);
 * - whose vector (of cell vectors: each of them) is no longer than MaskThreshold, with the default
 *   0 zero vectors;
 * - of no triangle that a line could go into.
 *
 * Output 1: with a TextureSize, an image of that size for vtkTexture, with the unsigned char point
 * scalars "LIC", 255 for 1, for meshes with texture coordinates: every texel whose centre lies in a
 * triangle has the LIC of its place on the surface, which is independent of how fine the mesh is.
 * The others have that of a texel near them, so that borders do not show when it is interpolated.
 * Texture coordinates beyond [0, 1] have no texels. Without a TextureSize it is empty.
 *
 * The points' LIC is as fine as the mesh. What shows most with the fewest triangles is a mesh that
 * is refined where the vectors turn: vtkAdaptiveRefinementFilter before this filter, with a
 * vtkCompositeDepthTagMetric, mode MAXIMUM, of
 *
 * - vtkFieldVariationDepthTagMetric: the vectors' angle and length;
 * - vtkRegionDepthTagMetric: a region of interest, such as where the camera has zoomed in;
 * - vtkScreenEdgeDepthTagMetric, ReferenceLength 10: no side longer than 10 pixels.
 *
 * and GeomorphingOff() in its recipe, so that segments are equally long. A field that is known
 * everywhere, from a formula or by vtkProbeFilter, is best taken anew at the refined points.
 *
 * Set GrainSize explicitly in that case: noise finer than the triangles only flickers from point to
 * point, and the automatic size changes with the mesh. On a mesh that stays coarse, use the
 * texture.
 *
 * Errors, with empty outputs: no polygons; vectors that are not there, not of 3 components or not
 * one for each point or cell; a TextureSize without texture coordinates, or with none in [0, 1];
 * contrast enhancement factors whose sum is not less than 1; not enough memory. A setting out of
 * its range is an error and changes nothing.
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
   * All settings but StepSize, GrainSize and TextureSize. Never nullptr: passing nullptr gives the
   * filter new ones with their defaults.
   */
  void SetLICSettings(vtkLICSettings* settings);
  vtkLICSettings* GetLICSettings() const;
  //@}

  //@{
  /**
   * How many steps a streamline goes each way, 1 to 100000, default 20: the mean of 41 samples of
   * the noise. See vtkLICSettings.
   */
  void SetNumberOfSteps(int steps);
  int GetNumberOfSteps();
  //@}

  //@{
  /**
   * Length of a step, in units of the points' coordinates; without NormalizeVectors, times the
   * length of the vector. 0, the default, is automatic: as many grains as the StepSize of the
   * vtkLICSettings says, by default 1, without NormalizeVectors for the longest vector. This one is
   * not shared: it depends on the mesh.
   */
  void SetStepSize(double size);
  vtkGetMacro(StepSize, double);
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
   * Distance of independent values of the noise, in units of the points' coordinates. 0, the
   * default, is automatic: the mean length of the edges. The noise is anchored at the origin: two
   * meshes that meet have the same noise where they do if their grains are the same.
   */
  void SetGrainSize(double size);
  vtkGetMacro(GrainSize, double);
  //@}

  //@{
  /**
   * Another number gives other noise of the same kind; default 1. See vtkLICSettings.
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
   * ENHANCE_CONTRAST_OFF (0, the default) or ENHANCE_CONTRAST_LIC (1): values are stretched, as
   * (L - m) / (M - m), so that the smallest is 0 and the largest 1, of the points that are not
   * masked; the texture like the points. Of shared settings, only what they say about the LIC
   * counts, not about colours. See vtkLICSettings.
   */
  void SetEnhanceContrast(int mode);
  int GetEnhanceContrast();
  void SetEnhanceContrastToOff() { this->SetEnhanceContrast(ENHANCE_CONTRAST_OFF); }
  void SetEnhanceContrastToLIC() { this->SetEnhanceContrast(ENHANCE_CONTRAST_LIC); }
  //@}

  //@{
  /**
   * How much further the values are stretched: m = min + low * (max - min) and M = max - high *
   * (max - min), clamped to [0, 1]. Both are in [-1, 1], default 0, and their sum is less than 1.
   * See vtkLICSettings.
   */
  void SetLowLICContrastEnhancementFactor(double factor);
  double GetLowLICContrastEnhancementFactor();
  void SetHighLICContrastEnhancementFactor(double factor);
  double GetHighLICContrastEnhancementFactor();
  //@}

  //@{
  /**
   * Points whose vector is no longer, in units of the array, are masked. Default 0; a negative one
   * masks no zero vectors. Streamlines run through them. See vtkLICSettings.
   */
  void SetMaskThreshold(double threshold);
  double GetMaskThreshold();
  //@}

  //@{
  /**
   * A component of at least this absolute value, as -1e9, means "no data"; more than 0, default
   * 1e8. See vtkLICSettings.
   */
  void SetNoDataMagnitude(double magnitude);
  double GetNoDataMagnitude();
  //@}

  //@{
  /**
   * Whether the weights rise upstream, so that lines grow brighter downstream from a bright grain:
   * their heads show which of the two ways the vectors point. Default off. See vtkLICSettings.
   */
  void SetOrientedLIC(bool oriented);
  bool GetOrientedLIC();
  vtkBooleanMacro(OrientedLIC, bool);
  //@}

  //@{
  /**
   * For animations: as it grows by 1, the pattern moves 3 NumberOfSteps + 1 steps downstream and
   * fades into what it was. Whole numbers give the same as the default, 0. See vtkLICSettings.
   */
  void SetPhase(double phase);
  double GetPhase();
  //@}

  //@{
  /**
   * Width and height in texels of output 1, each 1 to 16384; 0 and 0, the default, for none.
   */
  void SetTextureSize(int width, int height);
  void SetTextureSize(const int size[2]) { this->SetTextureSize(size[0], size[1]); }
  vtkGetVector2Macro(TextureSize, int);
  //@}

  /// Includes the modification time of the settings.
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
