// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpedImage
 * @brief   the image that a warp produces, with its inputs
 *
 * Private to the module.
 */
#ifndef WarpedImage_h
#define WarpedImage_h

#include "Warp/WarpCoefficients.h"
#include "Warp/WarpPicture.h"

#include "vtkFloatArray.h" // for members
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h" // for members

#include <memory>

class vtkImageData;

namespace relevo
{
class WarpSource;

class WarpedImage
{
public:
  /// Prepares the image for a warp. Arrays that others reference are replaced, not overwritten.
  void Prepare(
    const std::shared_ptr<const WarpSource>& source, const WarpCoefficients& coefficients);

  bool Shows(
    const std::shared_ptr<const WarpSource>& source, const WarpCoefficients& coefficients) const
  {
    return this->Source == source && this->Coefficients == coefficients;
  }
  bool IsEmpty() const { return !this->Source; }
  bool HasSizeOf(const WarpSource& source) const;
  WarpPicture& GetPicture() { return this->Picture; }
  const WarpSource& GetSource() const { return *this->Source; }
  const WarpCoefficients& GetCoefficients() const { return this->Coefficients; }
  /// Copies the result, sharing the arrays.
  void CopyTo(vtkImageData* image) const;
  /// Marks the image as empty.
  void Reset() { this->Source = nullptr; }

private:
  std::shared_ptr<const WarpSource> Source;
  WarpCoefficients Coefficients;
  WarpPicture Picture;
  vtkSmartPointer<vtkFloatArray> Depths;
  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  vtkSmartPointer<vtkFloatArray> Normals;
};
}

#endif
