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

#include "Actors/ShaderVariantKey.h"
#include "Blocks/RefinementBlocks.h"
#include "Buffers/InstanceBuffers.h"
#include "Buffers/RefinementFaceColors.h"
#include "Buffers/RefinementLevelTable.h"
#include "Buffers/RefinementMeshBuffers.h"
#include "Buffers/RefinementPatternBuffer.h"
#include "Buffers/VertexColors.h"
#include "Compute/RefinementComputeState.h"
#include "Methods/RefinementMethod.h"
#include "OpenGL/ContextWatch.h"
#include "OpenGL/RenderClock.h"
#include "Picking/PickedInput.h"
#include "Shaders/RefinementShader.h"
#include "State/LevelBudget.h"
#include "State/RefinementState.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkLinearSurface.h"
#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTimeStamp.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkProperty;

struct vtkAdaptiveRefinementMapper::vtkInternals
{
  vtkInternals()
  {
    this->Faces.PrimitiveType = PrimitiveTris;
    this->Vertices.PrimitiveType = PrimitiveVertices;
  }

  relevo::RefinementState State;

  // GPU side, of one context.
  vtkNew<relevo::ContextWatch> Context;
  vtkOpenGLRenderWindow* GetWindow() const { return this->Context->GetContext(); }
  relevo::RefinementMeshBuffers Buffers;
  relevo::RefinementPatternBuffer Patterns;
  relevo::InstanceBuffers Instances;
  relevo::VertexColors Colors;
  relevo::RefinementLevelTable LevelTable;
  relevo::RefinementFaceColors FaceColors;
  bool FaceColorsValid = true;
  vtkTimeStamp UploadTime;
  relevo::Dependencies UploadDependencies;
  bool UploadValid = false;
  bool ContextChecked = false;
  bool ContextValid = false;
  bool Drawable = false; // in the last render
  int NumberOfDrawCalls = 0;
  vtkIdType NumberOfBufferBuilds = 0;
  vtkIdType NumberOfShaderBuilds = 0;

  // How faces are drawn: the methods that have been in use, and the one of this render.
  std::map<int, std::unique_ptr<relevo::RefinementMethod>> Methods;
  int MethodInUse = METHOD_ARKFPI;
  std::string MethodProblem; // said last
  /// What each method's selections, by view, were made of that did not fit; not tried again.
  std::map<int, std::map<int, relevo::Dependencies>> FailedUploads;
  bool HasLines = false; // a wireframe is drawn
  relevo::RefinementMethod& GetMethod();
  /// Without a recipe there is nothing to upload, only to count.
  relevo::RefinementDrawing GetDrawing(vtkAdaptiveRefinement* recipe);

  vtkDataObject* CheckedInput = nullptr; // only to compare
  std::string TypeProblem;               // said last, as the others
  std::string ColorProblem;
  std::string HeightProblem;
  std::string LevelTableProblem;
  std::string ShaderProblem;
  bool LacksIds = false; // in the pass of a selection that has begun

  // Selections on the GPU.
  relevo::RefinementComputeState Compute;
  bool ComputeValid = false;            // the context can
  relevo::Dependencies FailedSelection; // see GetSelectionSources()
  std::string SelectionProblem;         // said last
  bool OnGPU = false;                   // in the last render
  double ComputeSeconds = 0.0;
  vtkMTimeType ReadTime = 0;    // of what was read back
  int NumberOfUsedPatterns = 0; // of that

  static void BuildBufferObjectsOfPiece(
    vtkAdaptiveRefinementMapper* mapper, vtkRenderer* ren, vtkActor* act);

  //@{
  /// Of what this mapper itself has drawn in the last render, after ReadSelection().
  int CountUsedPatterns() const;
  vtkIdType CountCoarseFaces() const;
  vtkIdType CountCulledFaces() const;
  relevo::FaceSums CountTriangles();
  //@}

  // What draws refined faces, and their vertices when those are shown.
  vtkOpenGLHelper Faces;
  vtkOpenGLHelper Vertices;
  std::vector<std::unique_ptr<vtkOpenGLHelper>> MoreFaces;                   // of subclasses
  std::vector<vtkOpenGLHelper*> Helpers = { &this->Faces, &this->Vertices }; // all
  struct ProgramState
  {
    relevo::RefinementShaderOptions Options; // of this frame
    relevo::Dependencies Key;                // of these
    bool HasNewKey = false;                  // since the last frame
    relevo::Dependencies Times;              // of what else users change of shaders
    bool HasFailed = false;                  // they could not be built
    std::vector<std::string> Attributes;
    int Method = -1;           // whose program it is; -1 for VTK's shader cache
    bool DrawsNothing = false; // for want of anchors
  };
  std::map<const vtkOpenGLHelper*, ProgramState> Programs;
  vtkNew<vtkShaderProgram> NoProgram;

  // What the method's own shaders were made from when they failed, see GetShaderSources().
  relevo::Dependencies Failure;

  // The programs of all helpers, VTK's included, are those of one look; the other looks' wait here.
  struct Look
  {
    std::map<vtkOpenGLHelper*, std::unique_ptr<vtkOpenGLHelper>> Helpers;
    std::map<const vtkOpenGLHelper*, primitiveInfo> Info;
    std::map<const vtkOpenGLHelper*, ProgramState> Programs;
    relevo::Dependencies Failure;
    unsigned long LastUse = 0;
  };
  std::map<relevo::Dependencies, Look> Looks;
  relevo::Dependencies CurrentLook;
  unsigned long LookUse = 0;
  bool HasVertexIndices = false; // VTK's own, of vertices to be seen
  void SwapLook(vtkAdaptiveRefinementMapper* mapper, Look& look);
  void ReleaseLooks(vtkWindow* window);
  /// No program of the method's is used any more.
  void ForgetPrograms(int method);

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

  relevo::RefinementComputeState::Targets GetTargets() const
  {
    return { this->Buffers.GetFaces(), this->Instances.GetInstances(),
      this->Instances.GetMorphTags() };
  }

  /// Whether VTK has not drawn the actor yet in this frame.
  static bool IsFirstPass(vtkActor* act);
  /// In seconds. An actor within an actor, as vtkLODActor has, is allotted no time of its own.
  static double GetAllocatedTime(vtkRenderer* ren, vtkActor* act);

  /// What of a method's shaders is up to the user.
  static relevo::Dependencies GetShaderSources(vtkAdaptiveRefinement* recipe, vtkActor* act);

  /// What a selection on the GPU is made from, but for the view.
  relevo::Dependencies GetSelectionSources(vtkAdaptiveRefinementMapper* mapper) const;

  /// Whether VTK's own mapper would draw the vertices of faces.
  static bool AreVerticesDrawn(vtkProperty* property, vtkHardwareSelector* selector);

  static bool HasWholeNumbers(vtkAdaptiveRefinement* recipe);

  /// Have VTK's pickers get what is drawn.
  static void InitializePicking(vtkAdaptiveRefinementMapper* mapper);

  /// The values that vertices between coarse points are coloured by; nullptr for none.
  static vtkAbstractArray* GetScalarsToInterpolate(vtkAdaptiveRefinementMapper* mapper);

  /// Have the options of a helper's shaders, and their key, as they are now.
  ProgramState& UpdateShaderOptions(
    vtkAdaptiveRefinementMapper* mapper, const vtkOpenGLHelper* cellBO);
  vtkNew<vtkLinearSurface> Linear; // where the recipe has no surface
};

#endif
