// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   surfaces with vectors, and their projections along -z
 */
#ifndef BenchmarkFlow_h
#define BenchmarkFlow_h

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkCamera;
class vtkPolyData;

struct FlowScene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh; // with the point vectors VectorsName
  /// For an analytic field: the projected vector at (x, y), seen along -z. It is zero outside the
  /// surface, close to its silhouette and close to singular points.
  std::function<std::array<double, 2>(double x, double y)> GetDirection;

  static constexpr const char* VectorsName = "Vectors";

  /// Looks along -z at y from -1 to 1.
  static void LookAlongZ(vtkCamera* camera);
};

namespace BenchmarkFlow
{
/// A uniform field, a vortex, a saddle and a dipole on the square from -1 to 1, with `resolution`
/// squares per side and two triangles per square; the rotation of a sphere; and a spiral around a
/// torus.
FlowScene MakeUniform(int resolution);
FlowScene MakeVortex(int resolution);
FlowScene MakeSaddle(int resolution);
FlowScene MakeDipole(int resolution);
FlowScene MakeSphere(int resolution);
FlowScene MakeTorus(int resolution);

/// SurfaceVectors.vtk and disk_out_ref_surface.vtp, if they are in RELEVO_TEST_DATA.
std::vector<FlowScene> ReadScenes();

/// Path of a file in RELEVO_TEST_DATA/flow; empty if it is missing.
std::string FindFile(const std::string& name);
}

#endif
