// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds positions of a flight that are outside of the height map
 */
#ifndef FlightCheck_h
#define FlightCheck_h

#include "Files/FlightFile.h"

#include <string>
#include <vector>

class ViewerMessages;
class vtkTerrainPyramid;

/**
 * Warns if positions are outside of a raster, which has a coordinate system. Throws ViewerError if
 * all of them are farther away from it than it is large.
 */
void CheckFlightPositions(const std::string& fileName, const std::vector<FlightPosition>& positions,
  const std::string& input, vtkTerrainPyramid* pyramid, ViewerMessages& messages);

#endif
