// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   surfaces with vectors, and how they look along -z
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
  /// Of a field that is known everywhere: the vector on the screen at a place (x, y), seen along
  /// -z; zero beside the surface, close to its outline and close to where the field has no
  /// direction.
  std::function<std::array<double, 2>(double x, double y)> GetDirection;

  static constexpr const char* VectorsName = "Vectors";

  /// Look along -z, from y = -1 to 1.
  static void LookAlongZ(vtkCamera* camera);
};

namespace BenchmarkFlow
{
/// A uniform field, a vortex, a saddle and a dipole on the square from -1 to 1, of `resolution`
/// quadrangles a side, in two triangles each; rotation of a sphere, a spiral around a torus.
FlowScene MakeUniform(int resolution);
FlowScene MakeVortex(int resolution);
FlowScene MakeSaddle(int resolution);
FlowScene MakeDipole(int resolution);
FlowScene MakeSphere(int resolution);
FlowScene MakeTorus(int resolution);

/// SurfaceVectors.vtk and disk_out_ref_surface.vtp, those that are in RELEVO_TEST_DATA.
std::vector<FlowScene> ReadScenes();

/// The file's path in RELEVO_TEST_DATA/flow; empty where it is not there.
std::string FindFile(const std::string& name);
}

#endif
