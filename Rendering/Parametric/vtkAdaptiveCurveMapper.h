// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveCurveMapper
 * @brief   draws curves of any degree, cut every frame into as many segments as the eye needs
 *
 * The twin of vtkAdaptiveCurveFilter on the graphics card: same cells, same settings, same segments
 * and points, and nothing but control points is stored. Input: a vtkUnstructuredGrid or a
 * vtkPolyData, of which line cells of all kinds are drawn (lines, poly-lines, quadratic edges,
 * cubic lines, Lagrange and Bézier curves of degree 1 to 8, rational ones too), or a composite data
 * set of such. The recipe says how many segments a curve gets: SetDepthTagArrayName(), SetMetric(),
 * SetMaximumLevel(), SetLevelOffset() and SetSegmentPolicy() count.
 *
 * Lights, clipping planes, opacity, depth peeling, line width, representations, render passes and
 * selections of cells work as with vtkPolyDataMapper. Lines are lit by the normal across the curve
 * that the eye sees most of, as VTK lights lines that have normals: vtkProperty::LightingOff() or
 * SetInterpolationToFlat() shows their colour as it is. Arrays of points are evaluated by the
 * curve's own basis and then mapped to colours, at the ends of segments or, with
 * InterpolateScalarsBeforeMapping, between them. Colours of categories and direct colours of points
 * are evaluated by that basis themselves. Hardware selection finds cells, and no points; VTK's
 * pickers intersect the input's cells.
 *
 * Curves that lie outside the view are not drawn. Levels are evaluated again only when the input,
 * the recipe or, for view-dependent metrics, the view has changed. GetBounds() has the control
 * points and the radius in it, and so all that is drawn.
 *
 * Needs OpenGL 3.3. Errors (ErrorEvent of this object; what can be drawn is drawn): no recipe,
 * cells and arrays that vtkAdaptiveCurveFilter calls errors, scalars that cannot be mapped, more
 * control points than OpenGL can hold.
 *
 * @sa vtkAdaptiveCurveFilter vtkAdaptiveRefinement vtkHairSource
 */
#ifndef vtkAdaptiveCurveMapper_h
#define vtkAdaptiveCurveMapper_h

#include "RelevoRenderingParametricModule.h" // for export macro
#include "vtkMapper.h"
#include "vtkSmartPointer.h" // for members

#include <memory> // for Internals
#include <string> // for members

class vtkAdaptiveRefinement;
class vtkPointSet;

class RELEVORENDERINGPARAMETRIC_EXPORT vtkAdaptiveCurveMapper : public vtkMapper
{
public:
  static vtkAdaptiveCurveMapper* New();
  vtkTypeMacro(vtkAdaptiveCurveMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The curves; SetInputDataObject() takes a composite data set, too.
   */
  void SetInputData(vtkPointSet* curves);

  //@{
  /**
   * How many segments curves get. Required.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  enum MethodType
  {
    METHOD_INSTANCING = 0,
    METHOD_HARDWARE_TESSELLATION
  };

  //@{
  /**
   * How segments are made. METHOD_INSTANCING (0, the default): curves of the same number of
   * segments are drawn by one instanced call. METHOD_HARDWARE_TESSELLATION (1): by the tessellator
   * of OpenGL 4.0, of lines as isolines; a curve has at most 64 segments, 60 as a tube. Without
   * OpenGL 4.0 an error says so once, and instances are drawn; they are, too, where tubes and
   * ribbons are shown as wireframes and where curves are shown as points. Another value is an error
   * and changes nothing.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetMethodToInstancing() { this->SetMethod(METHOD_INSTANCING); }
  void SetMethodToHardwareTessellation() { this->SetMethod(METHOD_HARDWARE_TESSELLATION); }
  //@}

  /// The method of the last render; of a composite data set, of its last block.
  int GetMethodInUse();

  enum RepresentationType
  {
    LINES = 0,
    RIBBONS,
    TUBES
  };

  //@{
  /**
   * What curves become, as of vtkAdaptiveCurveFilter: LINES (0, the default), as wide as the
   * actor's vtkProperty has it; RIBBONS (1), flat, whose whole width faces the camera; TUBES (2),
   * closed where no other curve goes on. Another value is an error and changes nothing.
   */
  void SetRepresentation(int representation);
  vtkGetMacro(Representation, int);
  void SetRepresentationToLines() { this->SetRepresentation(LINES); }
  void SetRepresentationToRibbons() { this->SetRepresentation(RIBBONS); }
  void SetRepresentationToTubes() { this->SetRepresentation(TUBES); }
  //@}

  //@{
  /**
   * Half the width of ribbons and tubes, in the input's units; at least 0, default 0.5.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  //@}

  //@{
  /**
   * A point array of one component that has the radii in place of SetRadius(); "", the default, for
   * none.
   */
  void SetRadiusArrayName(const char* name);
  const char* GetRadiusArrayName() { return this->RadiusArrayName.c_str(); }
  //@}

  //@{
  /**
   * Sides of a tube, 3 to 64; default 8.
   */
  void SetNumberOfSides(int sides);
  vtkGetMacro(NumberOfSides, int);
  //@}

  //@{
  /**
   * Whether curves are left out that lie outside the view; on by default. The picture stays the
   * same.
   */
  void SetFrustumCulling(bool culling);
  vtkGetMacro(FrustumCulling, bool);
  vtkBooleanMacro(FrustumCulling, bool);
  //@}

  //@{
  /**
   * Segments of the curves that the last render drew, and of those that it left out because they
   * lie outside the view. Together they are as many as vtkAdaptiveCurveFilter makes for the same
   * recipe and camera. All curves, and those of them that were left out.
   */
  vtkIdType GetNumberOfDrawnSegments();
  vtkIdType GetNumberOfCulledSegments();
  vtkIdType GetNumberOfCurves();
  vtkIdType GetNumberOfCulledCurves();
  //@}

  /// Draw calls of the last render.
  int GetNumberOfDrawCalls();

  //@{
  /**
   * How often levels have been evaluated, something was uploaded, and shaders were written, since
   * the mapper was made. The latter two do not happen because the camera moves.
   */
  vtkIdType GetNumberOfSelections();
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfShaderBuilds();
  //@}

  /// Bytes that the curves take on the graphics card.
  vtkTypeInt64 GetGraphicsMemorySize();

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * Of all that is drawn.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  //@}

  //@{
  /// Of a composite data set, all blocks are translucent where one is.
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  //@}

  bool GetSupportsSelection() override { return true; }
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  /// Includes the times of the recipe with all its parts.
  vtkMTimeType GetMTime() override;

protected:
  vtkAdaptiveCurveMapper();
  ~vtkAdaptiveCurveMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Method = METHOD_INSTANCING;
  int Representation = LINES;
  double Radius = 0.5;
  std::string RadiusArrayName;
  int NumberOfSides = 8;
  bool FrustumCulling = true;
  vtkSmartPointer<vtkAdaptiveRefinement> Refinement;

private:
  vtkAdaptiveCurveMapper(const vtkAdaptiveCurveMapper&) = delete;
  void operator=(const vtkAdaptiveCurveMapper&) = delete;

  /// Reads the input again if it has changed.
  void UpdateCurves();
  void RenderCurves(vtkRenderer* renderer, vtkActor* actor);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
