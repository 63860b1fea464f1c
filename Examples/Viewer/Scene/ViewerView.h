// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   where camera and lights stand
 *
 * Directions are given as on maps: an azimuth in degrees, clockwise from north, and an elevation
 * above the horizon. East, north and up are x, y, z where z points up, x, -z, y where y does, and
 * y, z, x where x does.
 */
#ifndef ViewerView_h
#define ViewerView_h

#include <array>

class vtkPoints;
class vtkPolyData;
class vtkRenderer;

struct ViewerDirection
{
  double Azimuth;
  double Elevation;
  int UpAxis; // 0 for x, 1 for y, 2 for z

  /// The unit vector to there.
  std::array<double, 3> GetVector() const;
};

/// Sunlight from there.
struct ViewerLamp
{
  ViewerDirection From;
  double Intensity;
};

void AddLight(vtkRenderer* renderer, const ViewerLamp& lamp);

/// Sizes in pixels.
struct ViewerPicture
{
  std::array<int, 2> Size;
  std::array<int, 2> Corner = { { 0, 0 } }; // upper left, where something else is
};

/**
 * The nearest place in that direction from which all points are in the picture, with a margin, and
 * none of a surface through them is in the picture's corner.
 */
void FitCamera(vtkRenderer* renderer, vtkPoints* points, const ViewerDirection& from,
  const ViewerPicture& picture);

/// Brings a place into the middle of the picture: the camera moves, and does not turn.
void MoveFocus(vtkRenderer* renderer, const std::array<double, 3>& place);

/// The camera's focal point is where its middle line first meets the surface, if it does.
void FocusOnSurface(vtkRenderer* renderer, vtkPolyData* surface);

#endif
