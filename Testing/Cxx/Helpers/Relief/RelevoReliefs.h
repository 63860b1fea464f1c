// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Reliefs for tests.
#ifndef RelevoReliefs_h
#define RelevoReliefs_h

#include "Data/Relief.h"
#include "RelevoCheck.h"
#include "vtkSmartPointer.h"

#include <functional>

class vtkImageAlgorithm;
class vtkImageData;

/// A texel's depth; NaN for none.
using RelevoDepth = std::function<double(int column, int row)>;

/// A relief of these depths; colours tell columns (red) and rows (green) from 0 to 255.
vtkSmartPointer<vtkImageData> RelevoMakeRelief(int width, int height,
  relevo::ReliefProjection projection, const relevo::dmat4& matrix, const RelevoDepth& depth);

/// An image of this type, the same number in each of its components.
vtkSmartPointer<vtkImageData> RelevoMakeImage(
  int width, int height, int type, const RelevoDepth& value, int components = 1);

/// What a filter makes of its input, which must be a relief, and no error.
relevo::Relief RelevoReadRelief(RelevoCheck& check, vtkImageAlgorithm* filter);

/// Of the world, at a texel.
relevo::dvec3 RelevoGetPoint(const relevo::Relief& relief, int column, int row);

/// A camera without lens: texels of this size at depth 1 look along +z from the origin, the middle
/// of the image straight ahead.
relevo::dmat4 RelevoPinhole(int width, int height, double texel);

#endif
