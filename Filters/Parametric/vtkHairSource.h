// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHairSource
 * @brief   generate hair on a surface, as cubic Bézier curves
 *
 * Input: a vtkPolyData with polygons or triangle strips. The number of hairs is Density * area,
 * rounded. They are distributed with uniform density (one hair at a random position in each equal
 * share of the area). A hair starts along the surface normal: the active point normals, or else the
 * normal of the triangle. Gravity bends it, and it winds in a helix that is widest at the tip. Each
 * hair is up to a fifth shorter than Length. The result depends on the settings only, not on the
 * number of threads. Cells that vtkGhostType marks as DUPLICATECELL are skipped.
 *
 * Output: a vtkUnstructuredGrid of VTK_BEZIER_CURVE cells of degree 3. Each hair has two cells per
 * turn of Curl, and at least one, in order from the root. They share end points and are C1
 * continuous. Points are double. The point array "HairRadius" (float) is Length / 100 at the root
 * and a tenth of that at the tip; pass it to vtkAdaptiveCurveFilter::SetRadiusArrayName(). The cell
 * arrays are "HigherOrderDegrees" (int, 3 components) and "vtkOriginalCellIds" (vtkIdType), the
 * input cell of the hair.
 *
 * The source reports an error and produces an empty output if there are no polygons, no polygon has
 * an area, or memory is insufficient for the number of hairs. It issues a warning with the number
 * of triangles without area, or with points that do not exist or are not finite.
 *
 * @sa vtkAdaptiveCurveFilter
 */
#ifndef vtkHairSource_h
#define vtkHairSource_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class vtkPolyData;

namespace relevo
{
class HairGrowth;
}

class RELEVOFILTERSPARAMETRIC_EXPORT vtkHairSource : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkHairSource* New();
  vtkTypeMacro(vtkHairSource, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the number of hairs per unit of area, 1e-12 to 1e12, default 100. Another value is an error
   * and changes nothing.
   */
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  double GetDensityMinValue() const { return 1e-12; }
  double GetDensityMaxValue() const { return 1e12; }
  //@}

  //@{
  /**
   * Set the arc length of the longest hairs, in units of the input, 1e-12 to 1e12, default 1.
   * Another value is an error and changes nothing.
   */
  void SetLength(double length);
  vtkGetMacro(Length, double);
  double GetLengthMinValue() const { return 1e-12; }
  double GetLengthMaxValue() const { return 1e12; }
  //@}

  //@{
  /**
   * Set the number of turns of the helix of a hair, 0 to 16, default 0.5. With 0 and without
   * gravity, hairs are straight. The radius of the helix is 0.15 * Curl / (Curl + 0.25) of the
   * length of the hair. With one turn and without gravity, the distance from root to tip is 0.93 of
   * that length. Another value is an error and changes nothing.
   */
  void SetCurl(double turns);
  vtkGetMacro(Curl, double);
  double GetCurlMinValue() const { return 0.0; }
  double GetCurlMaxValue() const { return 16.0; }
  //@}

  //@{
  /**
   * Set the displacement of the tip of a hair of length 1. Each component is in [-1000, 1000],
   * default (0, 0, -0.25). Another value is an error and changes nothing.
   */
  void SetGravity(double x, double y, double z);
  void SetGravity(const double gravity[3]) { this->SetGravity(gravity[0], gravity[1], gravity[2]); }
  vtkGetVector3Macro(Gravity, double);
  //@}

  //@{
  /**
   * Set the seed of the random numbers; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  //@}

protected:
  vtkHairSource();
  ~vtkHairSource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Density = 100.0;
  double Length = 1.0;
  double Curl = 0.5;
  double Gravity[3] = { 0.0, 0.0, -0.25 };
  int Seed = 1;

private:
  bool Grow(vtkPolyData* input, vtkUnstructuredGrid* output);

  vtkHairSource(const vtkHairSource&) = delete;
  void operator=(const vtkHairSource&) = delete;
};

#endif
