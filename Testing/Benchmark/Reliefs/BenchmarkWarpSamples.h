// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reliefs to warp, created at run time
 */
#ifndef BenchmarkWarpSamples_h
#define BenchmarkWarpSamples_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkCamera;
class vtkImageData;

struct BenchmarkWarpSample
{
  const char* Name;
  double (*Depth)(double x, double y); // in picture widths, for coordinates from -0.5 to 0.5
  double Published;                    // published speedup of multi-threaded over sequential
};

/// Samples in which under 1, about 5 and about 46 % of the texels have no surface.
const std::vector<BenchmarkWarpSample>& GetWarpSamples();

/// A parallel relief of size x size texels, with normals.
vtkSmartPointer<vtkImageData> MakeRelief(const BenchmarkWarpSample& sample, int size);

/// Looks at its centre from 15 to 20 degrees aside. Steps may be fractions.
void MoveCamera(vtkCamera* camera, int size, double step);

#endif
