// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveCurveFilter
 * @brief   tessellate curves adaptively into lines, ribbons or tubes
 *
 * This is the CPU version of vtkAdaptiveCurveMapper. With the same recipe it produces the same
 * segments, and the same points to float accuracy.
 *
 * Input: a vtkUnstructuredGrid or a vtkPolyData with VTK_LINE, VTK_POLY_LINE, VTK_QUADRATIC_EDGE,
 * VTK_CUBIC_LINE, VTK_LAGRANGE_CURVE or VTK_BEZIER_CURVE cells. Lagrange and Bézier curves have
 * degrees 1 to 8. Bézier curves are rational if the points have the attribute RationalWeights.
 * Cells of other dimensions, and cells that vtkGhostType marks as blanked or duplicate, are
 * ignored.
 *
 * The level of a curve comes from the recipe. If the points have the depth-tag array of the recipe,
 * it is the mean of the tags at both ends. Otherwise it is the largest tag that the metric assigns
 * to the Bézier control points; with vtkDistanceDepthTagMetric, this is the tag of the nearest one.
 * Without a metric it is MaximumLevel. Metrics of triangles, such as vtkScreenEdgeDepthTagMetric,
 * give level 0. A curve of level l has 2^l segments, or the integer that SegmentPolicy determines.
 * Each segment of a poly-line is refined as a separate curve.
 *
 * Output: points on the curves, of type float if the points of the input are float, and double
 * otherwise. End points are exactly those of the input. Lines are one poly-line per cell; cells
 * continue to share points. Ribbons and tubes are triangles with unit normals "Normals" (float).
 * Each curve has separate points; their coordinates match where one curve begins at the point that
 * exactly one other curve ends at. Tubes are closed. Curves that meet at an angle of less than 29
 * degrees are not joined.
 *
 * Point data are evaluated as in VTK's cells, from Lagrange nodes or Bézier coefficients, and keep
 * their type; integers are rounded. Strings, bits and ghost flags are copied from the nearest node.
 * Global and pedigree ids are dropped. For missing data, see
 * vtkAdaptiveRefinement::SetNoDataMagnitude(). Cell data are copied. The cell array
 * "vtkOriginalCellIds" (vtkIdType) has the ids of the input cells.
 *
 * The filter reports an error and produces an empty output if there is no recipe or no curve,
 * depth-tags or radii are invalid, the metric fails, or ribbons have no camera. It reports the
 * first invalid cell and skips it and any others: cells with a wrong number of points, a degree
 * above 8, points that do not exist or are not finite, weights that are not positive, or an unknown
 * curve type. It issues a warning with the number of skipped curves whose control points all
 * coincide.
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
   * Set the recipe. Required. Its surface, displacement and geomorphing are not used.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  /**
   * The shapes that represent curves.
   */
  enum Representations
  {
    LINES = 0,
    RIBBONS = 1,
    TUBES = 2
  };

  //@{
  /**
   * Set the shape of the output: LINES (0, default), RIBBONS (1), which are flat strips that face
   * the camera, or TUBES (2). Another value is an error and changes nothing.
   */
  void SetRepresentation(int representation);
  vtkGetMacro(Representation, int);
  void SetRepresentationToLines() { this->SetRepresentation(LINES); }
  void SetRepresentationToRibbons() { this->SetRepresentation(RIBBONS); }
  void SetRepresentationToTubes() { this->SetRepresentation(TUBES); }
  //@}

  //@{
  /**
   * Set the radius of tubes, half the width of ribbons, in input coordinates; at least 0, default
   * 0.5. Another value is an error and changes nothing.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  double GetRadiusMinValue() const { return 0.0; }
  double GetRadiusMaxValue() const { return VTK_DOUBLE_MAX; }
  //@}

  //@{
  /**
   * Set the name of a point array with a radius, at least 0, for each point. It is evaluated along
   * the curve like other point data, and replaces Radius. Empty (default) for none.
   */
  void SetRadiusArrayName(const char* name);
  const char* GetRadiusArrayName();
  //@}

  //@{
  /**
   * Set the number of sides of tubes, 3 to 64, default 8. Another value is an error and changes
   * nothing.
   */
  void SetNumberOfSides(int sides);
  vtkGetMacro(NumberOfSides, int);
  int GetNumberOfSidesMinValue() const { return 3; }
  int GetNumberOfSidesMaxValue() const { return 64; }
  //@}

  /**
   * Return the latest modification time of the filter, the recipe and, if they are used, Camera and
   * ModelToWorld.
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
