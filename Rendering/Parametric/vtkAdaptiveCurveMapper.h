// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveCurveMapper
 * @brief   draws curves of any degree, split in each frame into as many segments as the view needs
 *
 * This mapper generates on the GPU the segments and points that vtkAdaptiveCurveFilter generates on
 * the CPU, from the same cells and settings. It stores only control points. The input is a
 * vtkUnstructuredGrid, a vtkPolyData, or a composite data set of them. Line cells of all types are
 * drawn: lines, poly-lines, quadratic edges, cubic lines, and Lagrange and Bézier curves of degree
 * 1 to 8, including rational ones. The recipe sets the number of segments of a curve with
 * SetDepthTagArrayName(), SetMetric(), SetMaximumLevel(), SetLevelOffset() and SetSegmentPolicy().
 *
 * Lights, clipping planes, opacity, depth peeling, line width, representations, render passes and
 * selection of cells work as with vtkPolyDataMapper. Lines are lit with the normal across the curve
 * that faces the camera most, as VTK lights lines with normals. vtkProperty::LightingOff() or
 * SetInterpolationToFlat() shows their unlit colour. Point arrays are evaluated with the curve's
 * basis and then mapped to colours, at the ends of segments or, with
 * InterpolateScalarsBeforeMapping, between them. For categories and direct colours, the basis is
 * applied to the colours of the points. Hardware selection returns cells, but no points. VTK's
 * pickers intersect the input's cells.
 *
 * Curves outside the view are culled. Levels are evaluated again only when the input, the recipe
 * or, for view-dependent metrics, the view has changed. GetBounds() contains the control points and
 * the radius, and therefore everything that is drawn.
 *
 * Requires OpenGL 3.3. These are errors (ErrorEvent of this object): no recipe, cells and arrays
 * that are errors for vtkAdaptiveCurveFilter, scalars that cannot be mapped, and more control
 * points than OpenGL can hold. Curves that can be drawn are still drawn.
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
   * Set the curves. To set a composite data set, use SetInputDataObject().
   */
  void SetInputData(vtkPointSet* curves);

  //@{
  /**
   * Set the recipe, which gives the number of segments of each curve. Required.
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
   * Set how segments are generated. METHOD_INSTANCING (0, the default): one instanced call draws
   * all curves with the same number of segments. METHOD_HARDWARE_TESSELLATION (1): the tessellator
   * of OpenGL 4.0, with isolines for lines. A curve then has at most 64 segments, 60 as a tube.
   * Without OpenGL 4.0, one error is reported and instancing draws. Instancing also draws
   * wireframes of tubes and ribbons, and points. A value out of range is an error and changes
   * nothing.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetMethodToInstancing() { this->SetMethod(METHOD_INSTANCING); }
  void SetMethodToHardwareTessellation() { this->SetMethod(METHOD_HARDWARE_TESSELLATION); }
  //@}

  /// Return the method of the last render; for a composite data set, the method of its last block.
  int GetMethodInUse();

  enum RepresentationType
  {
    LINES = 0,
    RIBBONS,
    TUBES
  };

  //@{
  /**
   * Set the shape of the curves, as in vtkAdaptiveCurveFilter. LINES (0, the default) have the
   * width of the actor's vtkProperty. RIBBONS (1) are flat and always face the camera with their
   * whole width. TUBES (2) are closed at ends where no other curve continues. A value out of range
   * is an error and changes nothing.
   */
  void SetRepresentation(int representation);
  vtkGetMacro(Representation, int);
  void SetRepresentationToLines() { this->SetRepresentation(LINES); }
  void SetRepresentationToRibbons() { this->SetRepresentation(RIBBONS); }
  void SetRepresentationToTubes() { this->SetRepresentation(TUBES); }
  //@}

  //@{
  /**
   * Set half the width of ribbons and tubes, in units of the input; at least 0, default 0.5. A
   * value out of range is an error and changes nothing.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  //@}

  //@{
  /**
   * Set the name of a point array with one component that contains radii, which replace
   * SetRadius(). The default, "", uses no array.
   */
  void SetRadiusArrayName(const char* name);
  const char* GetRadiusArrayName() { return this->RadiusArrayName.c_str(); }
  //@}

  //@{
  /**
   * Set the number of sides of a tube, 3 to 64; default 8. A value out of range is an error and
   * changes nothing.
   */
  void SetNumberOfSides(int sides);
  vtkGetMacro(NumberOfSides, int);
  //@}

  //@{
  /**
   * Set whether curves outside the view are culled. On by default. The image does not change.
   */
  void SetFrustumCulling(bool culling);
  vtkGetMacro(FrustumCulling, bool);
  vtkBooleanMacro(FrustumCulling, bool);
  //@}

  //@{
  /**
   * Return the number of segments that the last render drew and culled, and the number of all
   * curves and of culled curves. The drawn and culled segments together are as many as
   * vtkAdaptiveCurveFilter generates for the same recipe and camera.
   */
  vtkIdType GetNumberOfDrawnSegments();
  vtkIdType GetNumberOfCulledSegments();
  vtkIdType GetNumberOfCurves();
  vtkIdType GetNumberOfCulledCurves();
  //@}

  /// Return the number of draw calls of the last render.
  int GetNumberOfDrawCalls();

  //@{
  /**
   * Return how often levels have been evaluated, data uploaded and shaders built since the mapper
   * was created. A moving camera increases neither the number of uploads nor that of shaders.
   */
  vtkIdType GetNumberOfSelections();
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfShaderBuilds();
  //@}

  /// Return the number of bytes that the curves take on the GPU.
  vtkTypeInt64 GetGraphicsMemorySize();

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * Return bounds that contain everything that is drawn.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  //@}

  //@{
  /// Return whether there is opaque or translucent geometry. If one block of a composite data set
  /// is translucent, all blocks are drawn as translucent.
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  //@}

  bool GetSupportsSelection() override { return true; }
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  /// Includes the modification times of the recipe and of all its parts.
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

  /// Update the curves if the input has changed.
  void UpdateCurves();
  void RenderCurves(vtkRenderer* renderer, vtkActor* actor);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
