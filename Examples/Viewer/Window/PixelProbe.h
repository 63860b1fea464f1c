// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the visible point and the values in a pixel
 *
 * Pixels are counted from the lower left corner of the window.
 */
#ifndef PixelProbe_h
#define PixelProbe_h

#include <array>
#include <optional>
#include <string>

class ViewerScene;

/// The visible point of a surface or of a volume; nothing for the background.
std::optional<std::array<double, 3>> FindVisiblePoint(ViewerScene& scene, const int pixel[2]);

/// Position and values on a surface, as lines of text. Empty if there is none.
std::string DescribeSurface(ViewerScene& scene, const int pixel[2]);

/// The same on a surface or in a volume.
std::string DescribeVisible(ViewerScene& scene, const int pixel[2]);

#endif
