// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementFaceColors
 * @brief   colours of faces by level, by pattern or by tag, on the GPU
 *
 * Level and pattern are constant on a face: vertices have the index of their pattern or of their
 * face, and a table has a colour for each. Tags are interpolated and mapped per fragment. The
 * buffers do not depend on which faces are drawn. Private to the module.
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
   * Upload the colours of these patterns by level, or by pattern (for whole numbers of segments, or
   * powers of two).
   */
  bool UploadPatterns(vtkOpenGLRenderWindow* window, int mode, bool wholeNumbers,
    const RefinementPatternBuffer& patterns, vtkScalarsToColors* table);

  /**
   * Upload the same per face, for vertices without patterns on the GPU: the colour of the pattern
   * that the face's levels request.
   */
  bool UploadFaces(vtkOpenGLRenderWindow* window, int mode, bool wholeNumbers,
    const ViewSelection& selection, vtkScalarsToColors* table);

  /**
   * Upload the tags of a selection; `offset` is added to them, and they are clamped to `highest`.
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

  // The dependencies of the buffers.
  Dependencies ColorDependencies;
  Dependencies TagDependencies;
  Dependencies TableDependencies;
};
}

#endif
