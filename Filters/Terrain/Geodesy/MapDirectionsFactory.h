// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the directions of a coordinate system, by its kind
 *
 * Private to the module's own sources.
 */
#ifndef MapDirectionsFactory_h
#define MapDirectionsFactory_h

#include "Geodesy/MapDirections.h"

#include <memory>
#include <string>

namespace relevo
{
/**
 * For a coordinate system whose coordinates are `origin` where x = y = 0. nullptr where the
 * system does not say how it lies on the earth (error stays empty), or for an error.
 */
std::unique_ptr<MapDirections> NewMapDirections(
  const std::string& system, const MapPlace& origin, std::string& error);
}

#endif
