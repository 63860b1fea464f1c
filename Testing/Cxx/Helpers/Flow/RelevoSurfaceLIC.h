// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What the tests of vtkSurfaceLineIntegralConvolution share.
#ifndef RelevoSurfaceLIC_h
#define RelevoSurfaceLIC_h

#include "RelevoTestMeshes.h"
#include "RelevoVector.h"

#include "vtkSurfaceLineIntegralConvolution.h"

#include <functional>
#include <vector>

// A point array "Velocity", the active vectors.
void AddVelocity(vtkPolyData* mesh,
  const std::function<RelevoVectors::Vector(const RelevoVectors::Vector&)>& function);

// The output's arrays; empty when there is none.
struct RelevoSurfaceLIC
{
  explicit RelevoSurfaceLIC(vtkPolyData* output);
  RelevoSurfaceLIC(vtkSurfaceLineIntegralConvolution* filter, vtkPolyData* mesh);

  // Finite, and in [0, 1].
  bool IsValid() const;

  std::vector<float> Values;
  std::vector<int> Mask;
};

#endif
