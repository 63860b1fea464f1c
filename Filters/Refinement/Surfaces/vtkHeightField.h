// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightField
 * @brief   heights over the unit square that a vtkDisplacement moves a surface by
 *
 * The interface between a source of heights (vtkHeightMap in Relevo::FiltersTerrain) and the two
 * evaluators of a recipe, which sample it with the same shared function (glsl/relevoHeight.glsl).
 *
 * Samples form a grid of GetDimensions() texels, x fastest, row 0 at v = 0 (VTK's texture
 * convention: the southern row of a north-up raster). Texel centres lie at ((i + 0.5) / n);
 * between them heights are bilinear, outside the outermost centres they are clamped.
 *
 * Samples are finite everywhere: where the source has no data they hold a fill interpolated from
 * the valid neighbours, and GetValidity() says so.
 *
 * @sa vtkHeightMap vtkDisplacement
 */
#ifndef vtkHeightField_h
#define vtkHeightField_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for ShareValidity

class RELEVOFILTERSREFINEMENT_EXPORT vtkHeightField : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkHeightField, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Bring the samples up to date. Returns false, after an ErrorEvent of this object, when there
   * are none. Cheap when nothing changed.
   */
  virtual bool Update() = 0;

  /**
   * Why the last Update() failed, as its ErrorEvent said it; "" where it did not fail. Unless
   * overridden always "".
   */
  virtual const char* GetErrorMessage() { return ""; }

  /**
   * Number of texels in x and y; (0, 0) before a successful Update().
   */
  virtual void GetDimensions(int dimensions[2]) = 0;

  /**
   * Smallest and largest valid sample, in the source's own units.
   */
  virtual void GetRange(double range[2]) = 0;

  /**
   * Whether some samples have no data.
   */
  virtual bool HasNoData() = 0;

  /**
   * Time of the last change of the samples themselves (not of the object's settings).
   */
  virtual vtkMTimeType GetSamplesMTime() = 0;

  /**
   * Height at (u, v) in [0, 1]^2 (clamped), bilinear; the fill over no-data; 0 at NaN.
   */
  double GetHeight(double u, double v);

  /**
   * Whether every sample that GetHeight(u, v) draws upon has data; false at NaN.
   */
  bool IsValid(double u, double v);

  /**
   * All samples, dimensions[0] * dimensions[1] floats, never NaN; nullptr before Update().
   */
  virtual const float* GetSamples() VTK_SIZEHINT(1) = 0;

  /**
   * One byte per sample, 0 where there is no data; nullptr when all samples are valid.
   */
  virtual const unsigned char* GetValidity() VTK_SIZEHINT(1) = 0;

#ifndef __VTK_WRAP__
  /**
   * The same bytes, which stay as they are for as long as the pointer is kept, whatever becomes of
   * this object. Unless overridden, a copy.
   */
  virtual std::shared_ptr<const unsigned char> ShareValidity();
#endif

protected:
  vtkHeightField();
  ~vtkHeightField() override;

private:
  vtkHeightField(const vtkHeightField&) = delete;
  void operator=(const vtkHeightField&) = delete;
};

#endif
