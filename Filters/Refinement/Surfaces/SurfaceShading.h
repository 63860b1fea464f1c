// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceShading
 * @brief   a surface in GLSL: the functions that shaders call, and their uniforms
 *
 * Part of vtkRefinementSurface.
 */
#ifndef SurfaceShading_h
#define SurfaceShading_h

#include <string> // for shader text
#include <vector> // for uniforms

namespace relevo
{
/// A uniform of the shader, of 1 to 4 floats.
struct SurfaceUniform
{
  std::string Name;
  std::vector<float> Values;
};

class SurfaceShading
{
public:
  /**
   * Return GLSL that defines surfacePosition(vec3) and surfaceNormal(vec3), and with
   * HasDirections() also surfaceDirection(vec3). The source can use cornerPoint(i),
   * cornerNormal(i), cornerDirection(i), cornerValues(i), edgeVector(edge, k) and faceVector(k).
   * With HasTables() it can also use tableEntry(), cornerOrder(), vec4 tablePoint(i) and ivec4
   * tableRecord(i). Positions are in the coordinates of VTK's vertex buffer. surfaceScale() is the
   * factor from the mesh's lengths to these coordinates, and modelPosition(p) converts a position
   * to the coordinates of the mesh.
   */
  virtual std::string GetShaderSource() = 0;

  /**
   * Return the uniforms that GetShaderSource() declares. They are set in each frame.
   */
  virtual std::vector<SurfaceUniform> GetUniforms() { return {}; }

protected:
  SurfaceShading() = default;
  ~SurfaceShading() = default;
};
}

#endif
