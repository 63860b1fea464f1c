// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what goes on behind the outlines of a relief
 *
 * The surface ends at the centres of the last texels on both sides of an opening, which leaves a
 * texel between them that shows neither. Private to the module.
 */
#ifndef ReliefSkirts_h
#define ReliefSkirts_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;

namespace relevo
{
class Relief;

/**
 * A relief of what is on the far sides of openings, and of its continuation behind the near sides:
 * plane, in the colour of the outline, for as many texels as bridge the opening. nullptr where
 * there are no openings. The sides are those that FindReliefSides() finds.
 */
vtkSmartPointer<vtkImageData> MakeReliefSkirts(
  const Relief& relief, const std::vector<unsigned char>& sides);
}

#endif
