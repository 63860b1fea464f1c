// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the numbers in the values of controls
 */
#ifndef ControlNumbers_h
#define ControlNumbers_h

#include <array>
#include <string>
#include <vector>

/// The numbers of a value such as "1,2.5". Empty if it has none.
std::vector<double> ParseNumbers(const std::string& text);
/// "1,2.5", with as many digits as the numbers need.
std::string WriteNumbers(const std::vector<double>& numbers);

/// The directions of cut planes along the axes.
inline constexpr std::array<const char*, 7> PlaneDirections{ { "none", "+x", "-x", "+y", "-y", "+z",
  "-z" } };

/// The index of a plane's direction: 0 without a plane, -1 if it is not along an axis.
int FindPlaneDirection(const std::vector<double>& plane);

/// A plane with the direction of an index from 1. It keeps its point, which is the middle of the
/// bounds without a plane.
std::vector<double> TurnPlane(
  const std::vector<double>& plane, const std::array<double, 6>& bounds, int direction);

#endif
