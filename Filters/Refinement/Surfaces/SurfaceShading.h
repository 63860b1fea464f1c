// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceShading
 * @brief   a surface as GLSL: the functions that shaders call, and their uniforms
 *
 * A part of vtkRefinementSurface.
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
   * The GLSL functions surfacePosition(vec3) and surfaceNormal(vec3), in terms of cornerPoint(i),
   * cornerNormal(i), cornerDirection(i), cornerValues(i), edgeVector(edge, k) and faceVector(k),
   * and with HasTables() of tableEntry(), cornerOrder(), vec4 tablePoint(i) and ivec4
   * tableRecord(i); with HasDirections() surfaceDirection(vec3) too.
   * Positions are those of VTK's vertex buffer: surfaceScale() is the factor from the mesh's
   * lengths to theirs, and modelPosition(p) a position in the mesh's own coordinates.
   */
  virtual std::string GetShaderSource() = 0;

  /**
   * The uniforms that GetShaderSource() declares, set with every frame.
   */
  virtual std::vector<SurfaceUniform> GetUniforms() { return {}; }

protected:
  SurfaceShading() = default;
  ~SurfaceShading() = default;
};
}

#endif
