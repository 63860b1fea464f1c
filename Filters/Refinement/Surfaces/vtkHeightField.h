// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightField
 * @brief   heights over the unit square, used by vtkDisplacement
 *
 * This is the interface between a source of heights (vtkHeightMap in Relevo::FiltersTerrain) and
 * the CPU and GPU evaluators of a recipe. Both sample it with the function in
 * glsl/relevoHeight.glsl.
 *
 * Samples form a grid of GetDimensions() texels. x varies fastest, and row 0 is at v = 0, as in VTK
 * textures: it is the southern row of a north-up raster. Texel i has its centre at (i + 0.5) / n.
 * Heights are bilinear between centres and clamped outside the outermost centres.
 *
 * All samples are finite. Missing samples have values interpolated from valid neighbours, and
 * GetValidity() marks them.
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
   * Update the samples. Returns false after reporting an error of this object if there are none.
   * This is cheap if nothing has changed.
   */
  virtual bool Update() = 0;

  /**
   * Return the message of the error that the last Update() reported, or "" if it succeeded. The
   * default implementation returns "".
   */
  virtual const char* GetErrorMessage() { return ""; }

  /**
   * Get the number of texels in x and y. It is (0, 0) before a successful Update().
   */
  virtual void GetDimensions(int dimensions[2]) = 0;

  /**
   * Get the smallest and largest valid sample, in the units of the source.
   */
  virtual void GetRange(double range[2]) = 0;

  /**
   * Return whether some samples are missing.
   */
  virtual bool HasNoData() = 0;

  /**
   * Return the time of the last change of the samples. Settings of the object do not count.
   */
  virtual vtkMTimeType GetSamplesMTime() = 0;

  /**
   * Return the height at (u, v), clamped to [0, 1]^2, with bilinear interpolation. Missing samples
   * have their interpolated values. Returns 0 if u or v is NaN.
   */
  double GetHeight(double u, double v);

  /**
   * Return whether all samples that GetHeight(u, v) uses are valid. Returns false if u or v is NaN.
   */
  bool IsValid(double u, double v);

  /**
   * Return all samples, dimensions[0] * dimensions[1] floats without NaN, or nullptr before
   * Update().
   */
  virtual const float* GetSamples() VTK_SIZEHINT(1) = 0;

  /**
   * Return one byte per sample, 0 for missing samples, or nullptr if all samples are valid.
   */
  virtual const unsigned char* GetValidity() VTK_SIZEHINT(1) = 0;

#ifndef __VTK_WRAP__
  /**
   * Return a shared copy of GetValidity() that does not change when this object does. The default
   * implementation copies the bytes.
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
