// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   directions of cameras and lights
 *
 * Directions are an azimuth in degrees, clockwise from north, and an elevation above the horizon.
 * East, north and up are x, y, z if z points up; x, -z, y if y does; and y, z, x if x does.
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

  /// The unit vector in this direction.
  std::array<double, 3> GetVector() const;
};

/// The direction of a unit vector, with an azimuth from 0 to 360 degrees.
ViewerDirection FindViewerDirection(const std::array<double, 3>& vector, int upAxis);

/// Sunlight from a direction.
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
  std::array<int, 2> Corner = { { 0, 0 } }; // upper left corner that is occupied
};

/**
 * Moves the camera to the nearest position in this direction from which all points are visible,
 * with a margin, and outside the occupied corner.
 */
void FitCamera(vtkRenderer* renderer, vtkPoints* points, const ViewerDirection& from,
  const ViewerPicture& picture);

/// Moves the camera without turning it so that a point is in the centre of the picture.
void MoveFocus(vtkRenderer* renderer, const std::array<double, 3>& place);

/// Sets the focal point to the first intersection of the view direction with the surface, if there
/// is one.
void FocusOnSurface(vtkRenderer* renderer, vtkPolyData* surface);

#endif
