// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   isosurfaces of blocks of an image
 *
 * Neighbouring blocks share a plane of points. Points of their isosurfaces in this plane have the
 * same coordinates to the bit, because blocks on both sides have the same extent along the plane.
 */
#ifndef ImageBlocks_h
#define ImageBlocks_h

#include "Blocks/ContourSettings.h"
#include "vtkSmartPointer.h" // for return values

#include <array>  // for extents
#include <string> // for errors
#include <vector> // for return values

class vtkImageData;
class vtkPolyData;

namespace relevo
{
using ImageExtent = std::array<int, 6>; // of points

/// Divide an image into blocks with at most `size` cells per side.
std::vector<ImageExtent> DivideExtent(const ImageExtent& whole, int size);

/// Return the points that a block needs: those of its cells, and their neighbours for gradients.
ImageExtent GrowExtent(const ImageExtent& block, const ImageExtent& whole, int layers);

/**
 * Return the isosurface of a block of an image, which can have more points than the block. The
 * point array FixedPointsName has a value other than 0 at planes that other blocks share. Returns
 * nullptr and an error for the user if the scalars are missing or invalid.
 */
vtkSmartPointer<vtkPolyData> ContourImageBlock(vtkImageData* image, const ImageExtent& block,
  const ImageExtent& whole, const ContourSettings& settings, std::string& error);
}

#endif
