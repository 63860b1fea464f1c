// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefMapper
 * @brief   draws reliefs: pictures with depth, from every near view
 *
 * A relief is a vtkImageData with the point arrays "Color" (unsigned char, 3 or 4 components: the
 * fourth is the opacity) and "Depth" (float, NaN where nothing was seen), if wanted "Normals"
 * (float, 3 components), and the field arrays "ReliefProjection" (0 parallel, 1 perspective) and
 * "ReliefMatrix" (16 doubles, by rows). The input is one, or a composite data set of many. Between
 * four texels the surface is bilinear; it is open where one of them is not valid or neighbours are
 * farther apart than MaximumStretch.
 *
 * The cost of a frame depends on how many pixels and texels are seen, not on the scene that the
 * relief is of. Each pixel's ray is followed to the surface; depths are true, so that reliefs and
 * other actors hide one another, and silhouettes are cut out.
 *
 * Opacity, clipping planes, depth peeling, selections and render passes work as with
 * vtkPolyDataMapper. In a translucent surface four layers of each piece of 16 x 16 texels are seen.
 * In a vtkHardwareSelector's selection the ids of points and cells are those of the image. The
 * representation is always surface; scalars, textures and edges have no effect.
 *
 * Input that is no relief is an error that names its block; the other blocks are drawn. An image
 * of one row or column has no surface, which is no error.
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
   * A relief; SetInputDataObject() takes a composite data set of reliefs, too.
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
   * How the surface is drawn. WARP (0): vtkReliefWarper's picture on the relief's plane, with true
   * depths; warped when the eye has moved. Where the eye is in the plane or behind it, rays are
   * followed. RAY_MARCH (1): each pixel's ray is followed through the relief, see SetSearch().
   * REFINEMENT (2): by Relevo's patterns, displaced by the depths, as fine
   * as the surface and the screen need: triangles are within a quarter of a texel of the surface,
   * or of a pixel where that is more; fragments where the surface is open are cut out.
   * AUTOMATIC (3, default): REFINEMENT if the surface is nowhere open, as that of a height map, and
   * has at most two triangles to a pixel of the renderer; else RAY_MARCH. The reliefs and the size
   * of the renderer decide: frames of an unchanged scene are equal to the bit.
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
   * How RAY_MARCH finds where a ray meets the surface. LINEAR_BINARY (0): steps of a texel, then
   * bisection (F. Policarpo, M. Oliveira, J. Comba, 2005); LINEAR_SECANT (1): the secant in place
   * of bisection. Both miss what is thinner than a step. RELAXED_CONES (2): steps to the border of
   * cones that a ray meets the surface in at most once (F. Policarpo, M. Oliveira, 2007), then
   * bisection; the cones are computed once, some seconds for a million texels, and rays from
   * behind take even steps. MAXIMUM_MIPMAP (3, default): by least and largest heights (A. Tevs, I.
   * Ihrke, H.-P. Seidel, 2008), then exactly in each quad; misses nothing.
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
   * How colours are shown. CAPTURED (0, default): as they are in the relief; light that was on the
   * scene when it was captured stays. LIT (1): in the light of the renderer's lamps and the actor's
   * vtkProperty, as the colours of a surface; with the relief's Normals, and where it has none with
   * those of the surface.
   */
  void SetShading(int shading);
  vtkGetMacro(Shading, int);
  void SetShadingToCaptured() { this->SetShading(CAPTURED); }
  void SetShadingToLit() { this->SetShading(LIT); }
  //@}

  //@{
  /**
   * Whether a relief's surface throws shadows on itself where it is LIT, from the first lamp of the
   * renderer that is on; off by default. Other actors and other reliefs throw none on it.
   */
  void SetSelfShadow(bool on);
  vtkGetMacro(SelfShadow, bool);
  vtkBooleanMacro(SelfShadow, bool);
  //@}

  //@{
  /**
   * The surface is open between neighbours that are farther apart than so many times the width of a
   * texel there; at least 0, default 8.
   */
  void SetMaximumStretch(double stretch);
  vtkGetMacro(MaximumStretch, double);
  //@}

  //@{
  /**
   * Whether each of several reliefs is continued beyond its outlines, by a texel and far enough
   * behind its surface that other reliefs hide it; on by default. Without it cracks show along
   * sharp edges: a relief ends at the centres of its last texels. One relief alone, translucent
   * actors and faces that a relief's viewer saw at more than 60 degrees are not continued.
   */
  vtkSetMacro(FillCracks, bool);
  vtkGetMacro(FillCracks, bool);
  vtkBooleanMacro(FillCracks, bool);
  //@}

  /**
   * The method that drew the last frame, not AUTOMATIC; of several reliefs the last one's. Before
   * the first frame RAY_MARCH.
   */
  int GetMethodInUse();

  /**
   * How often METHOD_WARP has warped a relief.
   */
  vtkIdType GetNumberOfWarps();

  /**
   * Bytes that the reliefs take on the graphics card.
   */
  vtkTypeInt64 GetGraphicsMemorySize();

  //@{
  /**
   * How often something was uploaded, and shaders were written, since the mapper was made. Neither
   * happens because the camera moves.
   */
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfShaderBuilds();
  //@}

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * Of the surface.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override;
  //@}

  /**
   * The input. VTK's pickers are given the surface in its place, with the ids of the image.
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

  /// Reads the input again if it has changed.
  void UpdateReliefs(vtkDataObject* input);
  void RenderReliefs(vtkRenderer* renderer, vtkActor* actor);
  vtkDataObject* ReplaceInput(vtkDataObject* input);
  int ChooseMethod(vtkRenderer* renderer);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
