// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   continues reliefs beyond their outlines to the sharp edges that others show
 *
 * The surface ends at the centres of its last texels. Where two reliefs show the two faces of a
 * sharp edge, both end up to a texel before the edge, and leave a crack. Private to the module.
 */
#ifndef ReliefRims_h
#define ReliefRims_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;

namespace relevo
{
class Relief;

/// Widths of a texel between neighbours on a face that is seen at 60 degrees.
constexpr double RimStretch = 2.0;

/// A relief and what FindReliefSides() finds of it with at most RimStretch.
struct RimSource
{
  const Relief* Surface;
  std::vector<unsigned char> Sides;
};

/// Texels that the image of the rims has more at each side.
constexpr int RimMargin = 1;

/**
 * A relief of the outermost texels of one of the sources and of their plane continuation by a
 * texel, where it saw nothing or something farther, and another source has a face at an angle near
 * there. The fourth component of the colours is at least a half before that face. Faces that the
 * viewer of the relief saw at more than 60 degrees are left to others, which show them better.
 * nullptr where there is no such edge.
 */
vtkSmartPointer<vtkImageData> MakeReliefRims(const std::vector<RimSource>& sources, size_t index);
}

#endif
