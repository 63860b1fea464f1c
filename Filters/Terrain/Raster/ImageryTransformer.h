// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ImageryTransformer
 * @brief   converts between the pixels of an image and those of a target
 *
 * The columns of an image of longitude and latitude repeat after 360 degrees. Of the columns with
 * the same longitude, the transformer returns the one that is nearest to SetMiddle().
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
 */
#ifndef ImageryTransformer_h
#define ImageryTransformer_h

#include <gdal_alg.h>

#include <array>
#include <memory>

namespace relevo
{
class ImageryTransformer
{
public:
  ImageryTransformer(GDALDatasetH image, GDALDatasetH target);
  ImageryTransformer(const ImageryTransformer&) = delete;
  void operator=(const ImageryTransformer&) = delete;

  /// Whether the coordinate systems can be converted.
  bool IsValid() const { return this->Exact != nullptr; }

  /// The number of columns after which the image repeats; 0 if it does not.
  double GetPeriod() const { return this->Period; }
  /// The default is the middle of the image.
  void SetMiddle(double column) { this->Middle = column; }
  /// A column with the same longitude that is nearest to another one.
  double GetNearest(double column, double other) const;

  /// Whether a row is within one of a pole, where small steps change the longitude by any angle.
  bool IsAtPole(double row) const;

  struct Point
  {
    std::array<double, 2> Position{};
    bool IsKnown = false;
  };
  Point ToImage(const std::array<double, 2>& position) const;
  Point ToTarget(const std::array<double, 2>& position) const;

  /// A GDALTransformerFunc. Its argument is a transformer.
  static int Transform(
    void* self, int toImage, int number, double* x, double* y, double* z, int* success);

private:
  struct Freer
  {
    void operator()(void* transformer) const { GDALDestroyTransformer(transformer); }
  };

  std::unique_ptr<void, Freer> Exact;
  std::array<double, 2> Poles = { { 0.0, 0.0 } }; // rows
  double Period = 0.0;
  double Middle = 0.0;
};
}

#endif
