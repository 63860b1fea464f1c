// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightGrid
 * @brief   finite heights and where they are valid, from samples of any type
 *
 * Private to the module's own sources.
 */
#ifndef vtkHeightGrid_h
#define vtkHeightGrid_h

#include <memory>
#include <string>
#include <vector>

namespace relevo
{
/**
 * Takes the rows of a raster one after the other, in any order, and turns them into one float per
 * sample, row 0 at v = 0.
 */
class HeightGrid
{
public:
  /// How samples become heights.
  struct Reading
  {
    std::vector<double> NoData; ///< samples equal to one of these, in their own type, have no data
    bool HasMask = false;       ///< masks come with the rows
    double Scale = 1.0;
    double Offset = 0.0;
    bool FlipColumns = false;
    bool FlipRows = false;
  };

  /// False, and why in `error`, when there is no memory for so many samples.
  bool Allocate(int width, int height, const Reading& reading, std::string& error);

  /**
   * Takes rows [first, first + count) of the source, of one of VTK's numeric types. `stride`
   * samples lie between one and the next; mask may be nullptr.
   */
  void SetRows(
    int first, int count, int type, const void* samples, int stride, const unsigned char* mask);

  /**
   * Fills what has no data. False, and why in `error`, when a sample that counts as valid is not
   * finite, or when none is valid.
   */
  bool Finish(std::string& error);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  const float* GetSamples() const { return this->Samples.get(); }

  /// nullptr when all samples are valid.
  const unsigned char* GetValidity() const { return this->Validity.get(); }

  /// Smallest and largest valid height.
  const double* GetRange() const { return this->Statistics.Range; }

private:
  // Of some rows of the source, in its own row order.
  struct RowStatistics
  {
    double Range[2];
    long long NumberOfInvalid = 0;
    long long NumberOfNonFinite = 0;
    int FirstNonFinite[2] = { -1, -1 }; // column and row
    RowStatistics();
    void Add(const RowStatistics& later);
  };

  template <typename T>
  RowStatistics SetRow(int row, const T* samples, int stride, const unsigned char* mask);

  int Width = 0;
  int Height = 0;
  Reading How;
  std::unique_ptr<float[]> Samples;
  std::unique_ptr<unsigned char[]> Validity;
  RowStatistics Statistics;
};
}

#endif
