// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefPatterns
 * @brief   the patterns that halves of a relief's tiles are drawn by, each edge as finely as both
 *          its sides need it
 *
 * Private to the module.
 */
#ifndef ReliefPatterns_h
#define ReliefPatterns_h

#include "Buffers/BufferTexture.h"
#include "Buffers/PatternRanges.h"
#include "Patterns/PatternLibrary.h"

#include <array>
#include <map>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class ReliefTiles;
class ReliefView;

class ReliefPatterns
{
public:
  /// Which patterns are drawn: triangles stay within a quarter of a texel of the surface, or of a
  /// pixel where that is more. false where OpenGL has no room for them.
  bool Select(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles, const ReliefView& view);

  /// That are drawn of all tiles where texels are no smaller than pixels, but for levels' borders.
  static double CountTriangles(const ReliefTiles& tiles);

  /// With the program that SetUniforms() was called for.
  void Draw(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }
  vtkTypeInt64 GetMemorySize() const;

private:
  using Levels = std::array<int, 3>;

  void MakePatterns();
  void AddHalf(unsigned int half, const Levels& levels);

  PatternRanges<Levels, unsigned int> Patterns; // by levels that do not rise
  std::map<Levels, std::vector<unsigned int>> InstancesOfPatterns;
  std::vector<float> VertexValues;
  BufferTexture Vertices;
  BufferTexture Instances;
  vtkIdType NumberOfTriangles = 0;
};
}

#endif
