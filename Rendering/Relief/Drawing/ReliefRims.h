// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   extends reliefs beyond their boundaries to sharp edges that other reliefs show
 *
 * The surface ends at the centres of its last texels. If two reliefs show the two faces of a sharp
 * edge, both end up to a texel before the edge, which leaves a crack. Private to the module.
 */
#ifndef ReliefRims_h
#define ReliefRims_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;

namespace relevo
{
class Relief;

/// The distance of neighbours, in texel widths, on a face that is seen at 60 degrees.
constexpr double RimStretch = 2.0;

/// A relief, and its sides from FindReliefSides() with at most RimStretch.
struct RimSource
{
  const Relief* Surface;
  std::vector<unsigned char> Sides;
};

/// The number of texels that the image of the rims has in addition at each side.
constexpr int RimMargin = 1;

/**
 * Return a relief of the outermost texels of one of the sources and of their planar extension by
 * one texel. Texels are extended where the relief saw nothing or something farther, and another
 * source has a face at an angle nearby. The fourth component of the colours is at least a half in
 * front of that face. Faces that the capture saw at more than 60 degrees are not extended, because
 * other reliefs show them better. Return nullptr if there is no such edge.
 */
vtkSmartPointer<vtkImageData> MakeReliefRims(const std::vector<RimSource>& sources, size_t index);
}

#endif
