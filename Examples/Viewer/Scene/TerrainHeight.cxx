// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainHeight.h"

#include "Text/ViewerMessages.h"

#include "vtkNew.h"
#include "vtkTerrainPyramid.h"

#include <cmath>
#include <sstream>

namespace
{
std::string ToText(const std::array<double, 2>& degrees)
{
  std::ostringstream text;
  text.precision(10);
  text << "longitude " << degrees[0] << ", latitude " << degrees[1];
  return text.str();
}
}

//------------------------------------------------------------------------------
double FindTerrainHeight(const std::string& fileName, const std::array<double, 2>& degrees)
{
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->GlobalWarningDisplayOff();
  pyramid->SetFileName(fileName.c_str());
  if (!pyramid->Update())
  {
    throw ViewerError(pyramid->GetErrorMessage());
  }
  double point[2];
  if (!pyramid->GeographicToRaster(degrees.data(), point))
  {
    throw ViewerError(fileName +
      (std::string(pyramid->GetCoordinateSystem()).empty()
          ? " has no coordinate system; --height-at needs one"
          : ": " + ToText(degrees) + " has no coordinates in its coordinate system"));
  }
  const double height = pyramid->GetElevation(point[0], point[1]);
  if (std::isnan(height))
  {
    const std::string error = pyramid->GetErrorMessage();
    throw ViewerError(error.empty() ? fileName + " has no height at " + ToText(degrees) +
          ": the point is outside of the raster, or there is no data. "
          "The order is longitude, latitude"
                                    : error);
  }
  return height;
}
