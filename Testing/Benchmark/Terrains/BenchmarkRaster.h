// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkRaster
 * @brief   heights in memory, as files store them, and the bilinear surface between them
 */
#ifndef BenchmarkRaster_h
#define BenchmarkRaster_h

#include <array>
#include <string>
#include <vector>

class BenchmarkRaster
{
public:
  /// Mount Rainier, 1201 x 1201, from RELEVO_TEST_DATA, with filled voids. Without that folder, and
  /// with another size, a fractal.
  static BenchmarkRaster MakeMountain(int size);
  /// A fractal, 30 m between the samples.
  static BenchmarkRaster MakeFractal(int size);

  bool IsReal() const { return this->Real; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  float GetSample(int column, int row) const
  {
    return this->Samples[static_cast<std::size_t>(row) * this->Width + column];
  }
  /// The bilinear surface; whole numbers are the centers of samples.
  double Interpolate(double column, double row) const;

  /// The first columns and rows.
  BenchmarkRaster Crop(int width, int height) const;

  /// Write a TIFF of int16.
  bool Write(const std::string& fileName) const;

private:
  bool Read(const std::string& fileName);

  int Width = 0;
  int Height = 0;
  bool Real = false;
  std::vector<float> Samples;
  std::array<double, 6> Transform{ { 500000.0, 30.0, 0.0, 5000000.0, 0.0, -30.0 } };
  std::string CoordinateSystem;
};

#endif
