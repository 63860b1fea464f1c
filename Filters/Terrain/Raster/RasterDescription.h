// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::RasterDescription
 * @brief   a raster's size, samples, no-data value, units and location; see
 *          vtkHeightMap::Describe()
 */
#ifndef RasterDescription_h
#define RasterDescription_h

#include "Geodesy/Georeference.h" // for members

#include <optional> // for members

namespace relevo
{
/// The description of a file's first band.
struct RasterDescription
{
  int Width = 0;
  int Height = 0;
  int RowsPerBlock = 1;    ///< reading whole multiples of these rows is efficient
  int SamplesPerTexel = 1; ///< that are read, not only kept
  int Type = 0;            ///< VTK's type of the samples as read
  bool HasMask = false;    ///< validity comes from a mask as well
  std::optional<double> NoData;
  double Scale = 1.0; ///< height = Scale * sample + Offset
  double Offset = 0.0;
  double VerticalUnit = 1.0; ///< metres in one unit of the heights
  Georeference Location;
};
}

#endif
