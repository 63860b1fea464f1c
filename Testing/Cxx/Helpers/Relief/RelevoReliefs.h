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

/// A texel's depth; NaN if it has none.
using RelevoDepth = std::function<double(int column, int row)>;

/// A relief with these depths. Colours encode columns (red) and rows (green) from 0 to 255.
vtkSmartPointer<vtkImageData> RelevoMakeRelief(int width, int height,
  relevo::ReliefProjection projection, const relevo::dmat4& matrix, const RelevoDepth& depth);

/// An image of this type with the same value in each component.
vtkSmartPointer<vtkImageData> RelevoMakeImage(
  int width, int height, int type, const RelevoDepth& value, int components = 1);

/// The output of a filter, which must be a relief, without an error.
relevo::Relief RelevoReadRelief(RelevoCheck& check, vtkImageAlgorithm* filter);

/// World coordinates of a texel.
relevo::dvec3 RelevoGetPoint(const relevo::Relief& relief, int column, int row);

/// A pinhole camera at the origin that looks along +z. Texels have this size at depth 1, and the
/// image is centred.
relevo::dmat4 RelevoPinhole(int width, int height, double texel);

#endif
