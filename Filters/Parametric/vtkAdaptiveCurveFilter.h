// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveCurveFilter
 * @brief   curves of any degree cut into as many segments as a recipe asks for: lines, ribbons or
 *          tubes
 *
 * The twin of vtkAdaptiveCurveMapper on the CPU: same recipe, same segments, same points to float
 * accuracy.
 *
 * Input: a vtkUnstructuredGrid or a vtkPolyData with VTK_LINE, VTK_POLY_LINE, VTK_QUADRATIC_EDGE,
 * VTK_CUBIC_LINE, VTK_LAGRANGE_CURVE or VTK_BEZIER_CURVE cells of degrees 1 to 8, the latter
 * rational if the points have the attribute RationalWeights. Cells of other dimensions and those
 * whose vtkGhostType says that they are blanked or that another piece has them are left out.
 *
 * The recipe's levels: where the points have its array of depth-tags, the mean of a curve's two
 * ends; else the largest tag that the metric gives the control points of the curve as Bézier curve,
 * as with vtkDistanceDepthTagMetric the nearest one; without either MaximumLevel. Metrics that look
 * at triangles, as vtkScreenEdgeDepthTagMetric, find none and give level 0. A curve of level l has
 * 2^l segments, or the whole number that the recipe's SegmentPolicy says; each segment of a
 * poly-line is a curve of its own.
 *
 * Output: points on the curves, exactly the input's at their ends, in floats if the input's are,
 * else in double. As lines: one poly-line for each cell; cells that share a point share it still.
 * As ribbons and tubes: triangles, their points apart for each curve but, where one curve begins at
 * the point that one other ends at, with the same coordinates; "Normals", unit float vectors. Tubes
 * are closed. At a corner of less than 29 degrees curves end apart.
 *
 * Point data are evaluated in the cell's own basis, at Lagrange's nodes and from Bézier's
 * coefficients as VTK does, and keep their type: integers are rounded; strings, bits and ghost
 * flags are those of the nearest node; global and pedigree ids are left out. See
 * vtkAdaptiveRefinement::SetNoDataMagnitude() for values that stand for no data. Cell data are
 * passed on, and the cell array "vtkOriginalCellIds" (vtkIdType) holds the ids of the input's
 * cells.
 *
 * Errors, with an empty output: no recipe, no curves, depth-tags or radii that cannot be used, a
 * metric that fails, no camera for ribbons. Errors that name the first cell, with the rest drawn:
 * a wrong number of points, a degree above 8, points that are not there or not finite, weights of 0
 * or less, curves of unknown types. Curves whose control points are all at one place are left out;
 * a warning says how many.
 *
 * @sa vtkAdaptiveRefinement vtkHairSource vtkNURBSSource
 */
#ifndef vtkAdaptiveCurveFilter_h
#define vtkAdaptiveCurveFilter_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkSmartPointer.h"               // for members
#include "vtkViewDependentAlgorithm.h"

#include <string> // for members

class vtkAdaptiveRefinement;
class vtkPointSet;

namespace relevo
{
struct CurveStyle;
class CurveMesh;
class CurveTags;
}

class RELEVOFILTERSPARAMETRIC_EXPORT vtkAdaptiveCurveFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkAdaptiveCurveFilter* New();
  vtkTypeMacro(vtkAdaptiveCurveFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * What to refine to. Required. Its surface and displacement are not used, and nothing morphs.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  /**
   * What curves are drawn as.
   */
  enum Representations
  {
    LINES = 0,
    RIBBONS = 1,
    TUBES = 2
  };

  //@{
  /**
   * LINES (0, the default), RIBBONS (1), flat strips that face the camera, or TUBES (2). Another
   * value is an error and changes nothing.
   */
  void SetRepresentation(int representation);
  vtkGetMacro(Representation, int);
  void SetRepresentationToLines() { this->SetRepresentation(LINES); }
  void SetRepresentationToRibbons() { this->SetRepresentation(RIBBONS); }
  void SetRepresentationToTubes() { this->SetRepresentation(TUBES); }
  //@}

  //@{
  /**
   * Of tubes, and half the width of ribbons, in the input's coordinates; at least 0, default 0.5.
   * Another value is an error and changes nothing.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  double GetRadiusMinValue() const { return 0.0; }
  double GetRadiusMaxValue() const { return VTK_DOUBLE_MAX; }
  //@}

  //@{
  /**
   * Name of a point array with a radius for each point, at least 0, used in place of Radius and
   * evaluated along the curve as other point data are; empty, the default, for none.
   */
  void SetRadiusArrayName(const char* name);
  const char* GetRadiusArrayName();
  //@}

  //@{
  /**
   * How many sides tubes have, 3 to 64, default 8. Another value is an error and changes nothing.
   */
  void SetNumberOfSides(int sides);
  vtkGetMacro(NumberOfSides, int);
  int GetNumberOfSidesMinValue() const { return 3; }
  int GetNumberOfSidesMaxValue() const { return 64; }
  //@}

  /**
   * Latest change of the filter, its recipe or, where they matter, Camera and ModelToWorld.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkAdaptiveCurveFilter();
  ~vtkAdaptiveCurveFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkAdaptiveRefinement> Refinement;
  int Representation = LINES;
  double Radius = 0.5;
  std::string RadiusArrayName;
  int NumberOfSides = 8;

private:
  bool MakeStyle(vtkPointSet* input, relevo::CurveStyle& style);
  int Cut(vtkPointSet* input, vtkPolyData* output);
  bool Check(vtkPointSet* input, const relevo::CurveMesh& mesh);
  bool Build(vtkPointSet* input, const relevo::CurveMesh& mesh, const relevo::CurveTags& tags,
    const relevo::CurveStyle& style, vtkPolyData* output);

  vtkAdaptiveCurveFilter(const vtkAdaptiveCurveFilter&) = delete;
  void operator=(const vtkAdaptiveCurveFilter&) = delete;
};

#endif
