// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reads the positions of a flight over a terrain
 *
 * A flight is a table of comma-separated values with the header
 * `longitude,latitude,height,heading,pitch`. Each of the other lines is the camera of a frame.
 */
#ifndef FlightFile_h
#define FlightFile_h

#include <string>
#include <vector>

struct FlightPosition
{
  double Longitude; // degrees
  double Latitude;  // degrees
  double Height;    // metres, as the raster's
  double Heading;   // degrees, clockwise from north
  double Pitch;     // degrees, up is positive
  int Line;         // of the file, from 1
};

/// Throws ViewerError, which names the line and the column of invalid values.
std::vector<FlightPosition> ReadFlightFile(const std::string& fileName);

#endif
