// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a vtkAdaptiveRefinementMapper keeps
 *
 * Private to the mapper's own sources.
 */
#ifndef vtkAdaptiveRefinementMapperInternals_h
#define vtkAdaptiveRefinementMapperInternals_h

#include "Blocks/RefinementBlocks.h"
#include "Compute/RefinementComputeState.h"
#include "OpenGL/ContextWatch.h"
#include "OpenGL/RenderClock.h"
#include "Picking/PickedInput.h"
#include "Stages/FaceColorStage.h"
#include "Stages/MethodStage.h"
#include "Stages/RefinementPrograms.h"
#include "Stages/UploadStage.h"
#include "State/LevelBudget.h"
#include "State/RefinementState.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

struct vtkAdaptiveRefinementMapper::vtkInternals
{
  relevo::RefinementState State;

  // GPU side, of one context.
  vtkNew<relevo::ContextWatch> Context;
  vtkOpenGLRenderWindow* GetWindow() const { return this->Context->GetContext(); }
  relevo::UploadStage Upload;
  relevo::MethodStage Methods;
  relevo::FaceColorStage FaceColors;
  relevo::RefinementPrograms Programs{ PrimitiveTris, PrimitiveVertices };
  bool ContextChecked = false;
  bool ContextValid = false;
  bool Drawable = false; // in the last render
  int NumberOfDrawCalls = 0;
  vtkIdType NumberOfBufferBuilds = 0; // of blocks that are gone
  vtkIdType NumberOfShaderBuilds = 0; // the same

  bool HasLines = false; // a wireframe is drawn
  /// Without a recipe there is nothing to upload, only to count.
  relevo::RefinementDrawing GetDrawing(vtkAdaptiveRefinement* recipe);

  vtkDataObject* CheckedInput = nullptr; // only to compare
  std::string TypeProblem;               // said last, as the others
  std::string ColorProblem;

  // Selections on the GPU.
  relevo::RefinementComputeState Compute;
  bool ComputeValid = false;            // the context can
  relevo::Dependencies FailedSelection; // see GetSelectionSources()
  std::string SelectionProblem;         // said last
  bool OnGPU = false;                   // in the last render
  double ComputeSeconds = 0.0;
  vtkMTimeType ReadTime = 0;    // of what was read back
  int NumberOfUsedPatterns = 0; // of that

  //@{
  /// Of what this mapper itself has drawn in the last render, after ReadSelection().
  int CountUsedPatterns() const;
  vtkIdType CountCoarseFaces() const;
  vtkIdType CountCulledFaces() const;
  relevo::FaceSums CountTriangles();
  //@}

  bool HasVertexIndices = false; // VTK's own, of vertices to be seen
  relevo::RefinementBlocks Blocks;
  vtkMTimeType BlockSettingsTime = 0; // of the settings that they have copied
  bool DrawsBlocks = false;           // in the last render
  /// Count on where a block that is removed ends.
  void AddCounts(vtkAdaptiveRefinementMapper* block);
  relevo::PickedInput Picking;

  // The blocks of a composite input use their parent's.
  relevo::LevelBudget Budget;
  bool AgreesWithProcesses = false; // before each frame
  relevo::Dependencies WholeDependencies;
  /// This mapper or those of its blocks, by flat index.
  static std::map<unsigned int, vtkAdaptiveRefinementMapper*> FindParts(
    vtkAdaptiveRefinementMapper* mapper);
  static void AgreeOnWhole(vtkAdaptiveRefinement* recipe, vtkAdaptiveRefinementMapper* part,
    const relevo::RefinementView& view, const relevo::PieceReduction& pieces);
  relevo::RenderClock Clock;
  bool IsBlock = false;

  /// Whether VTK has not drawn the actor yet in this frame.
  static bool IsFirstPass(vtkActor* act);
  /// In seconds. An actor within an actor, as vtkLODActor has, is allotted no time of its own.
  static double GetAllocatedTime(vtkRenderer* ren, vtkActor* act);

  /// What a selection on the GPU is made from, but for the view.
  relevo::Dependencies GetSelectionSources(vtkAdaptiveRefinementMapper* mapper) const;

  /// Have VTK's pickers get what is drawn.
  static void InitializePicking(vtkAdaptiveRefinementMapper* mapper);
};

#endif
