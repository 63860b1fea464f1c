// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the choices that a file offers, and the figures of a frame
 */
#ifndef SceneContent_h
#define SceneContent_h

#include "Files/TransferFile.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct SceneArray
{
  std::string Name;
  bool IsOfPoints;
  int NumberOfComponents;
  bool HasIntegrationPoints = false; // an average of values at these points, or a value for each
};

struct SceneContent
{
  int Version = 0; // changes when the studio's scene shows other options
  std::vector<SceneArray> Arrays;
  std::string Array; // that colours the scene, or an empty string
  std::vector<double> Times;
  int Step = 0;
  std::optional<std::array<double, 2>> Range;  // of the colours in use
  std::optional<std::array<double, 6>> Bounds; // of a mesh
  // Azimuth and elevation in degrees; nothing on a globe.
  std::optional<std::array<double, 2>> Light;
  std::optional<std::array<double, 2>> View; // of the camera
  bool IsViewMoved = false;                  // away from the view of the options
  bool HasSolidCells = false;
  std::vector<TransferNode> Transfer; // of a volume
  double UnitDistance = 0.0;          // of a volume
  std::vector<double> Counts;         // histogram of the values over the range, of a volume
};

/// The faces of a frame with one pattern.
struct PatternCount
{
  std::array<int, 3> Segments; // of the edges, in descending order
  long long Faces;
  long long Triangles;
};

/// Names and values, for example "triangles".
using SceneFigures = std::vector<std::pair<std::string, double>>;

#endif
