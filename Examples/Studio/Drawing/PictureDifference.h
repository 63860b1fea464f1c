// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PictureDifference
 * @brief   compares two pictures of the same rectangle of a window
 */
#ifndef PictureDifference_h
#define PictureDifference_h

#include <array>
#include <vector>

class vtkImageData;
class vtkRenderWindow;

class PictureDifference
{
public:
  /// Reads a picture, 0 or 1, from the lower left corner of the window. Sizes are in pixels.
  void Read(int picture, vtkRenderWindow* window, const std::array<int, 2>& size);
  /// Compares both pictures, which must have the same size.
  void Compare();

  /// The structural similarity of grey values, 1 for equal pictures.
  double GetSimilarity() const { return this->Similarity; }
  /// The number of pixels that differ.
  long long GetNumberOfDifferentPixels() const { return this->NumberOfDifferentPixels; }

  /// Writes differences of colours, times a gain, into an RGB image. Equal pixels are white.
  void Draw(double gain, vtkImageData* image) const;

private:
  std::array<int, 2> Size = { { 0, 0 } };
  std::array<std::vector<unsigned char>, 2> Pixels; // RGB
  double Similarity = 1.0;
  long long NumberOfDifferentPixels = 0;
};

#endif
