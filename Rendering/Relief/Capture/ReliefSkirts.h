// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   extends a relief behind its silhouettes
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
 * Return a relief of the far sides of openings and their planar extension behind the near sides, in
 * the colour of the silhouette, for as many texels as bridge the opening. Return nullptr if there
 * are no openings. The sides are those of FindReliefSides().
 */
vtkSmartPointer<vtkImageData> MakeReliefSkirts(
  const Relief& relief, const std::vector<unsigned char>& sides);
}

#endif
