// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightGrid
 * @brief   finite heights and where they are valid, from samples of any type
 *
 * Private to the module's own sources.
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
 * Takes the rows of a raster, one after the other, and turns them into one float per sample, or the
 * means of a smaller grid, row 0 at v = 0.
 */
class HeightGrid
{
public:
  HeightGrid();
  ~HeightGrid();

  /// How samples become heights.
  struct SampleEncoding
  {
    std::vector<double> NoData; ///< samples equal to one of these, in their own type, have no data
    bool HasMask = false;       ///< masks come with the rows
    double Scale = 1.0;
    double Offset = 0.0;
    bool FlipColumns = false;
    bool FlipRows = false;
  };

  /**
   * For a raster of `source` columns and rows, kept as `size` columns and rows, at most as many.
   * False, and why in `error`, when there is no memory for so many samples.
   */
  bool Allocate(
    const int source[2], const int size[2], const SampleEncoding& encoding, std::string& error);

  /**
   * Takes the next rows, [first, first + count), of one of VTK's numeric types. `stride` samples
   * lie between one and the next; mask may be nullptr.
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
  // What is counted over some rows.
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
  std::unique_ptr<HeightReduction> Reduction; // null where every sample is kept
  std::unique_ptr<float[]> Samples;
  std::unique_ptr<unsigned char[]> Validity;
  RowStatistics Statistics;
};
}

#endif
