// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefPatterns
 * @brief   the patterns that draw halves of a relief's tiles, with matching edges
 *
 * Each edge is as fine as both its sides need. Private to the module.
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
  /// Select the patterns. Triangles deviate from the surface by at most a quarter of a texel, or of
  /// a pixel if that is larger. Return false if OpenGL lacks memory.
  bool Select(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles, const ReliefView& view);

  /// Return the number of triangles for all tiles if texels are at least as large as pixels,
  /// without the transitions between levels.
  static double CountTriangles(const ReliefTiles& tiles);

  /// Draw with the program for which SetUniforms() was called.
  void Draw(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }
  vtkTypeInt64 GetMemorySize() const;

private:
  using Levels = std::array<int, 3>;

  void MakePatterns();
  void AddHalf(unsigned int half, const Levels& levels);

  PatternRanges<Levels, unsigned int> Patterns; // by levels in descending order
  std::map<Levels, std::vector<unsigned int>> InstancesOfPatterns;
  std::vector<float> VertexValues;
  BufferTexture Vertices;
  BufferTexture Instances;
  vtkIdType NumberOfTriangles = 0;
};
}

#endif
