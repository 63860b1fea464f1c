// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightGrid
 * @brief   heights as float with validity, converted from samples of any type
 *
 * Private to the module.
 */
#ifndef HeightGrid_h
#define HeightGrid_h

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace relevo
{
class HeightReduction;

/**
 * Takes the rows of a raster in order and converts them to one float per sample, with row 0 at v =
 * 0. Optionally it reduces them to a smaller grid of means.
 */
class HeightGrid
{
public:
  HeightGrid();
  ~HeightGrid();

  /// The conversion of samples to heights.
  struct SampleEncoding
  {
    std::vector<double> NoData; ///< samples equal to one of these, in their type, have no data
    bool HasMask = false;       ///< rows come with masks
    double Scale = 1.0;
    double Offset = 0.0;
    bool FlipColumns = false;
    bool FlipRows = false;
  };

  /**
   * Prepares for a raster of `source` columns and rows that is stored as `size` columns and rows.
   * `size` must not exceed `source`. Returns false with an `error` if memory is insufficient.
   */
  bool Allocate(
    const int source[2], const int size[2], const SampleEncoding& encoding, std::string& error);

  /**
   * Takes the next rows, [first, first + count), of a numeric VTK type. `stride` is the distance of
   * consecutive samples. `mask` may be nullptr.
   */
  void SetRows(
    int first, int count, int type, const void* samples, int stride, const unsigned char* mask);

  /**
   * Fills missing heights. Returns false with an `error` if a valid sample is not finite, or no
   * sample is valid.
   */
  bool Finish(std::string& error);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  const float* GetSamples() const { return this->Samples.get(); }

  /// Returns nullptr if all samples are valid.
  const unsigned char* GetValidity() const { return this->Validity.get(); }

  /// Returns the smallest and largest valid height.
  const double* GetRange() const { return this->Statistics.Range; }

private:
  // Statistics of a number of rows.
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
  RowStatistics Decode(int row, const T* samples, int stride, const unsigned char* mask,
    float* heights, unsigned char* validity) const;
  RowStatistics Decode(int row, int type, const void* samples, std::size_t start, int stride,
    const unsigned char* mask, float* heights, unsigned char* validity) const;
  void SetReducedRows(
    int first, int count, int type, const void* samples, int stride, const unsigned char* mask);
  void SetMeans(int row, const double* sums, const double* areas);
  std::size_t RowStart(int row) const;

  int Source[2] = { 0, 0 };
  int Width = 0;
  int Height = 0;
  SampleEncoding Encoding;
  std::unique_ptr<HeightReduction> Reduction; // null if not reduced
  std::unique_ptr<float[]> Samples;
  std::unique_ptr<unsigned char[]> Validity;
  std::vector<char> HasMissing; // rows of Validity that are written; the others are valid
  RowStatistics Statistics;
};
}

#endif
