// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpedImage
 * @brief   the image that a warp makes, and what it was made from
 *
 * Private to the module's own sources.
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
  /// Makes the picture ready to be warped into. Arrays that others hold are left to them.
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
  /// Whose arrays the picture is drawn into.
  void CopyTo(vtkImageData* image) const;
  /// Forgets what it shows.
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
