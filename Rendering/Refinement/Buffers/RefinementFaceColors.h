// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementFaceColors
 * @brief   colours of faces by level, by pattern or by tag, on the GPU
 *
 * Level and pattern are the same all over a face: vertices know the number of their pattern or of
 * their face, and a table has a colour for each. Tags are interpolated and looked up per fragment.
 * Nothing here depends on which faces are drawn. Private to the module.
 */
#ifndef RefinementFaceColors_h
#define RefinementFaceColors_h

#include "Buffers/BufferTexture.h" // for members
#include "Buffers/ColorTable.h"    // for members
#include "Changes/Dependencies.h"  // for members

#include <vector> // for colours

class vtkScalarsToColors;

namespace relevo
{
class RefinementMesh;
class RefinementPatternBuffer;
class ViewSelection;

class RefinementFaceColors
{
public:
  /**
   * Have the colours of these patterns; by level, or by pattern (of whole numbers of segments, or
   * powers of two).
   */
  bool UploadPatterns(vtkOpenGLRenderWindow* window, int mode, bool wholeNumbers,
    const RefinementPatternBuffer& patterns, vtkScalarsToColors* table);

  /**
   * The same face by face, for vertices that belong to no pattern on the GPU: of the pattern that
   * each face's levels ask for.
   */
  bool UploadFaces(vtkOpenGLRenderWindow* window, int mode, bool wholeNumbers,
    const ViewSelection& selection, vtkScalarsToColors* table);

  /**
   * Have the tags of a selection; `offset` is added to them, and they end at `highest`.
   */
  bool UploadTags(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
    const ViewSelection& selection, double offset, int highest, vtkScalarsToColors* table);

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool UploadColors(vtkOpenGLRenderWindow* window, const std::vector<float>& colors,
    const Dependencies& dependencies);

  BufferTexture Colors; // of patterns or faces
  BufferTexture Tags;
  ColorTable Table;
  bool PerEdge = false;
  float Offset = 0.0f;
  float Highest = 0.0f;

  // What the buffers were made of.
  Dependencies ColorDependencies;
  Dependencies TagDependencies;
  Dependencies TableDependencies;
};
}

#endif
