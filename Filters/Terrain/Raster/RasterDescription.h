// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::RasterDescription
 * @brief   size, sample type, no-data value, units and location of a raster
 *
 * See vtkHeightMap::Describe().
 */
#ifndef RasterDescription_h
#define RasterDescription_h

#include "Geodesy/Georeference.h" // for members

#include <optional> // for members
#include <string>   // for members

namespace relevo
{
/// The description of the first band of a file.
struct RasterDescription
{
  int Width = 0;
  int Height = 0;
  int RowsPerBlock = 1;    ///< reading multiples of this number of rows is efficient
  int SamplesPerTexel = 1; ///< samples that are read per texel, including unused channels
  int Type = 0;            ///< VTK's type of the samples that are read
  bool HasMask = false;    ///< whether a mask defines validity too
  bool IsPicture = false;  ///< whether there are three or more bands of bytes, as in photos
  bool IsJPEG = false;     ///< whether the file is a JPEG file
  std::optional<double> NoData;
  double Scale = 1.0; ///< height = Scale * sample + Offset
  double Offset = 0.0;
  double VerticalUnit = 1.0; ///< metres per unit of height
  std::string UnitName;      ///< of heights, as the file declares it, or ""
  Georeference Location;
};
}

#endif
