// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefMapper
 * @brief   draws reliefs, which are images with depth, from nearby views
 *
 * A relief is a vtkImageData with the point arrays "Color" (unsigned char, 3 or 4 components; the
 * fourth is the opacity) and "Depth" (float, NaN where the texel is empty), optionally "Normals"
 * (float, 3 components), and the field arrays "ReliefProjection" (0 parallel, 1 perspective) and
 * "ReliefMatrix" (16 doubles, by rows). The input is a relief or a composite data set of reliefs.
 * The surface is bilinear between four texels. It is open where one of them is not valid or where
 * neighbours are farther apart than MaximumStretch.
 *
 * The time per frame depends on the number of visible pixels and texels, not on the captured scene.
 * A ray per pixel is traced to the surface. The depths are correct, so reliefs and other actors
 * occlude one another, and silhouettes are cut out.
 *
 * Opacity, clipping planes, depth peeling, selections and render passes work as with
 * vtkPolyDataMapper. A translucent surface shows up to four layers of each tile of 16 x 16 texels.
 * A vtkHardwareSelector returns the point and cell ids of the image. The representation is always
 * surface; scalars, textures and edges have no effect.
 *
 * An input that is not a relief is an error that names its block; the other blocks are drawn. An
 * image of one row or column has no surface, which is not an error.
 *
 * @sa vtkReliefWarper
 */
#ifndef vtkReliefMapper_h
#define vtkReliefMapper_h

#include "RelevoRenderingReliefModule.h" // for export macro
#include "vtkMapper.h"

#include <memory> // for Internals

class vtkImageData;

class RELEVORENDERINGRELIEF_EXPORT vtkReliefMapper : public vtkMapper
{
public:
  static vtkReliefMapper* New();
  vtkTypeMacro(vtkReliefMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set a relief. To set a composite data set of reliefs, use SetInputDataObject().
   */
  void SetInputData(vtkImageData* relief);
  //@}

  enum MethodType
  {
    METHOD_WARP = 0,
    METHOD_RAY_MARCH,
    METHOD_REFINEMENT,
    METHOD_AUTOMATIC
  };

  //@{
  /**
   * Set how the surface is drawn. A value out of range is an error and changes nothing.
   *
   * WARP (0): vtkReliefWarper's image, drawn on the relief's plane with correct depths. It is
   * warped again when the camera has moved. If the camera is in the plane or behind it, rays are
   * traced. RAY_MARCH (1): a ray per pixel is traced through the relief, see SetSearch().
   * REFINEMENT (2): Relevo's patterns, displaced by the depths and refined to the surface and the
   * screen: triangles deviate from the surface by at most a quarter of a texel, or of a pixel if
   * that is larger. Fragments where the surface is open are discarded. AUTOMATIC (3, the default):
   * REFINEMENT if the surface is nowhere open, for example a height map, and has at most two
   * triangles per pixel of the renderer; otherwise RAY_MARCH. The choice depends on the reliefs and
   * the renderer's size only, so frames of an unchanged scene are bit-identical.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetMethodToWarp() { this->SetMethod(METHOD_WARP); }
  void SetMethodToRayMarch() { this->SetMethod(METHOD_RAY_MARCH); }
  void SetMethodToRefinement() { this->SetMethod(METHOD_REFINEMENT); }
  void SetMethodToAutomatic() { this->SetMethod(METHOD_AUTOMATIC); }
  //@}

  enum SearchType
  {
    SEARCH_LINEAR_BINARY = 0,
    SEARCH_LINEAR_SECANT,
    SEARCH_RELAXED_CONES,
    SEARCH_MAXIMUM_MIPMAP
  };

  //@{
  /**
   * Set how RAY_MARCH finds the intersection of a ray and the surface. A value out of range is an
   * error and changes nothing.
   *
   * LINEAR_BINARY (0): steps of one texel, then bisection (F. Policarpo, M. Oliveira, J. Comba,
   * 2005). LINEAR_SECANT (1): the same with the secant method instead of bisection. Both miss
   * features thinner than a step. RELAXED_CONES (2): steps to the border of cones in which a ray
   * intersects the surface at most once (F. Policarpo, M. Oliveira, 2007), then bisection. The
   * cones are computed once, in some seconds for a million texels. Rays from behind use uniform
   * steps. MAXIMUM_MIPMAP (3, the default): a traversal of minimum and maximum heights (A. Tevs, I.
   * Ihrke, H.-P. Seidel, 2008), then an exact intersection with each quad. It misses nothing.
   */
  void SetSearch(int search);
  vtkGetMacro(Search, int);
  void SetSearchToLinearBinary() { this->SetSearch(SEARCH_LINEAR_BINARY); }
  void SetSearchToLinearSecant() { this->SetSearch(SEARCH_LINEAR_SECANT); }
  void SetSearchToRelaxedCones() { this->SetSearch(SEARCH_RELAXED_CONES); }
  void SetSearchToMaximumMipmap() { this->SetSearch(SEARCH_MAXIMUM_MIPMAP); }
  //@}

  enum ShadingType
  {
    CAPTURED = 0,
    LIT
  };

  //@{
  /**
   * Set how the surface is shaded. CAPTURED (0, the default) shows the relief's colours, including
   * the light at the time of the capture. LIT (1) lights these colours with the renderer's lights
   * and the actor's vtkProperty. It uses the relief's Normals if there are any, otherwise those of
   * the surface. A value out of range is an error and changes nothing.
   */
  void SetShading(int shading);
  vtkGetMacro(Shading, int);
  void SetShadingToCaptured() { this->SetShading(CAPTURED); }
  void SetShadingToLit() { this->SetShading(LIT); }
  //@}

  //@{
  /**
   * Set whether the surface of a LIT relief casts shadows on itself, from the first light of the
   * renderer that is on. Off by default. Other actors and other reliefs cast no shadow on it.
   */
  void SetSelfShadow(bool on);
  vtkGetMacro(SelfShadow, bool);
  vtkBooleanMacro(SelfShadow, bool);
  //@}

  //@{
  /**
   * Set the distance between neighbours above which the surface is open, as a multiple of the local
   * texel width; at least 0, default 8. A value out of range is an error and changes nothing.
   */
  void SetMaximumStretch(double stretch);
  vtkGetMacro(MaximumStretch, double);
  //@}

  //@{
  /**
   * Set whether each of several reliefs is extended beyond its boundary by a texel, far enough
   * behind its surface that other reliefs hide the extension. On by default. Off, cracks appear
   * along sharp edges, because a relief ends at the centres of its last texels. A single relief,
   * translucent actors and faces that the capture saw at more than 60 degrees are not extended.
   */
  vtkSetMacro(FillCracks, bool);
  vtkGetMacro(FillCracks, bool);
  vtkBooleanMacro(FillCracks, bool);
  //@}

  /**
   * Return the method that drew the last frame, not AUTOMATIC; for several reliefs, the method of
   * the last one. Before the first frame, it is RAY_MARCH.
   */
  int GetMethodInUse();

  /**
   * Return how often METHOD_WARP has warped a relief.
   */
  vtkIdType GetNumberOfWarps();

  /**
   * Return the number of bytes that the reliefs take on the GPU.
   */
  vtkTypeInt64 GetGraphicsMemorySize();

  //@{
  /**
   * Return how often data have been uploaded and shaders built since the mapper was created. A
   * moving camera increases neither.
   */
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfShaderBuilds();
  //@}

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * Return the bounds of the surface.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override;
  //@}

  /**
   * Return the input. VTK's pickers get the surface instead, with the ids of the image.
   */
  vtkDataObject* GetInputDataObject(int port, int connection);

  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  bool GetSupportsSelection() override { return true; }
  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkReliefMapper();
  ~vtkReliefMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Method = METHOD_AUTOMATIC;
  int Search = SEARCH_MAXIMUM_MIPMAP;
  int Shading = CAPTURED;
  bool SelfShadow = false;
  double MaximumStretch = 8.0;
  bool FillCracks = true;

private:
  vtkReliefMapper(const vtkReliefMapper&) = delete;
  void operator=(const vtkReliefMapper&) = delete;

  /// Update the reliefs if the input has changed.
  void UpdateReliefs(vtkDataObject* input);
  void RenderReliefs(vtkRenderer* renderer, vtkActor* actor);
  vtkDataObject* ReplaceInput(vtkDataObject* input);
  int ChooseMethod(vtkRenderer* renderer);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
