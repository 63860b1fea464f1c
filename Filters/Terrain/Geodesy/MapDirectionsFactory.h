// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   creation of MapDirections for a coordinate system
 *
 * Private to the module.
 */
#ifndef MapDirectionsFactory_h
#define MapDirectionsFactory_h

#include "Geodesy/MapDirections.h"

#include <memory>
#include <string>

namespace relevo
{
/**
 * The coordinates `origin` of the system correspond to x = y = 0. Returns nullptr with an empty
 * `error` if the system is local or unknown, or nullptr with an error.
 */
std::unique_ptr<MapDirections> NewMapDirections(
  const std::string& system, const MapPlace& origin, std::string& error);
}

#endif
