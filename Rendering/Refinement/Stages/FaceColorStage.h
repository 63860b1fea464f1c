// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceColorStage
 * @brief   the colours of levels, patterns or tags on the GPU
 *
 * Private to the module.
 */
#ifndef FaceColorStage_h
#define FaceColorStage_h

#include "Buffers/RefinementFaceColors.h" // for members
#include "Buffers/RefinementLevelTable.h" // for members
#include "Stages/StageResult.h"

#include <string> // for members

class vtkAdaptiveRefinement;

namespace relevo
{
class FaceColorStage
{
public:
  struct Input
  {
    vtkOpenGLRenderWindow* Window;
    /// A RefinementColorMode. With COLOR_BY_SCALARS nothing is uploaded.
    int Mode;
    vtkAdaptiveRefinement* Recipe;
    /// The offset that is added to the recipe's offset.
    double LevelOffset;
    const RefinementMesh* Mesh;
    const ViewSelection* Selection;
    /// The patterns that vertices belong to; nullptr if colours are per face.
    const RefinementPatternBuffer* Patterns;
    /// The user's table, or GetDefaultTable(), which the user can change, too.
    vtkScalarsToColors* Table;
  };
  StageResult Update(const Input& input);

  /// Return the default table of a mode; `recipe` may be nullptr.
  vtkScalarsToColors* GetDefaultTable(int mode, vtkAdaptiveRefinement* recipe);

  void Activate(vtkShaderProgram* program) { this->Colors.Activate(program); }
  void Deactivate() { this->Colors.Deactivate(); }
  vtkTypeInt64 GetMemorySize() const { return this->Colors.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Upload(const Input& input, vtkScalarsToColors* table);

  RefinementFaceColors Colors;
  RefinementLevelTable DefaultTable;
  std::string TableError; // error that was reported last, like the next
  std::string SizeError;
};
}

#endif
