// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Helpers for the tests of vtkSurfaceLineIntegralConvolution.
#ifndef RelevoSurfaceLIC_h
#define RelevoSurfaceLIC_h

#include "RelevoTestMeshes.h"
#include "RelevoVector.h"

#include "vtkSurfaceLineIntegralConvolution.h"

#include <functional>
#include <vector>

// Adds the point array "Velocity" as active vectors.
void AddVelocity(vtkPolyData* mesh,
  const std::function<RelevoVectors::Vector(const RelevoVectors::Vector&)>& function);

// Arrays of the output; empty if there is none.
struct RelevoSurfaceLIC
{
  explicit RelevoSurfaceLIC(vtkPolyData* output);
  RelevoSurfaceLIC(vtkSurfaceLineIntegralConvolution* filter, vtkPolyData* mesh);

  // Whether all values are finite and in [0, 1].
  bool IsValid() const;

  std::vector<float> Values;
  std::vector<int> Mask;
};

#endif
