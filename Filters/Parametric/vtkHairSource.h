// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHairSource
 * @brief   hair on a surface, as cubic Bézier curves
 *
 * Input: a vtkPolyData with polygons of any size or triangle strips. Hairs stand as densely
 * everywhere, one at a random place of each share of the area; there are Density times area,
 * rounded. They leave along the surface's normal (the active point normals, where there are none
 * that of the triangle), sink under gravity and wind in a helix that is widest at the tip. Each
 * is up to a fifth shorter than Length. The same settings give the same hairs, whatever the number
 * of threads. Cells whose vtkGhostType has DUPLICATECELL have none.
 *
 * Output: a vtkUnstructuredGrid of VTK_BEZIER_CURVE cells of degree 3, those of a hair following
 * one another from the root: two for each turn of Curl, at least one; they share their ends and
 * are joined in C1. Points in double; the point array "HairRadius" (float), a hundredth of Length
 * at the root and a tenth of that at the tip, for vtkAdaptiveCurveFilter::SetRadiusArrayName(); the
 * cell arrays "HigherOrderDegrees" (int, 3 components) and "vtkOriginalCellIds" (vtkIdType), the
 * input's cell that the hair grows on.
 *
 * Errors, with an empty output: no polygons, none of them with an area, more hairs than memory. A
 * warning says how many triangles have no area or points that are not there or not finite.
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
   * Hairs for each unit of area, 1e-12 to 1e12, default 100. Another value is an error and changes
   * nothing.
   */
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  double GetDensityMinValue() const { return 1e-12; }
  double GetDensityMaxValue() const { return 1e12; }
  //@}

  //@{
  /**
   * That of the longest hairs, were they straight, in the input's units; 1e-12 to 1e12, default 1.
   * Another value is an error and changes nothing.
   */
  void SetLength(double length);
  vtkGetMacro(Length, double);
  double GetLengthMinValue() const { return 1e-12; }
  double GetLengthMaxValue() const { return 1e12; }
  //@}

  //@{
  /**
   * Number of turns that the helix of a hair makes, 0 to 16; default 0.5. With 0 and without
   * gravity a hair is straight. The radius of the helix is 0.15 Curl / (Curl + 0.25) of the hair's
   * length: with one turn and without gravity, root and tip are 0.93 of the hair's length apart.
   * Another value is an error and changes nothing.
   */
  void SetCurl(double turns);
  vtkGetMacro(Curl, double);
  double GetCurlMinValue() const { return 0.0; }
  double GetCurlMaxValue() const { return 16.0; }
  //@}

  //@{
  /**
   * How far the tip of a hair of length 1 sinks, and where to; each component
   * -1000 to 1000, default (0, 0, -0.25).
   * Another value is an error and changes nothing.
   */
  void SetGravity(double x, double y, double z);
  void SetGravity(const double gravity[3]) { this->SetGravity(gravity[0], gravity[1], gravity[2]); }
  vtkGetVector3Macro(Gravity, double);
  //@}

  //@{
  /**
   * Another one for other hairs; default 1.
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
