// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SelectionStage
 * @brief   prepares a mesh, evaluates its levels and selects the faces to draw, on the CPU or GPU
 *
 * RefinementState has what the CPU computes, RefinementComputeState what the GPU does. Where
 * selection on the GPU fails, the CPU does it until the mesh, the patterns or the metric change.
 * Private to the module.
 */
#ifndef SelectionStage_h
#define SelectionStage_h

#include "Compute/RefinementComputeState.h" // for members
#include "Stages/ContextCheck.h"            // for SelectionDevice
#include "Stages/StageResult.h"
#include "State/LevelBudget.h"     // for parts
#include "State/RefinementState.h" // for members
#include "View/RefinementView.h"   // for Input

#include <string> // for members
#include <vector> // for parts

class vtkAdaptiveRefinement;
class vtkOpenGLRenderWindow;
class vtkPolyData;

namespace relevo
{
class InstanceBuffers;
class UploadStage;

class SelectionStage
{
public:
  RefinementState& GetState() { return this->State; }
  const RefinementState& GetState() const { return this->State; }

  /// The messages of the last update of the state.
  StageResult TakeResult(bool isValid);
  /// Prepare the mesh of an input.
  StageResult UpdateMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe);

  /// A mesh in a view.
  struct ViewInput
  {
    vtkPolyData* Mesh;
    vtkAdaptiveRefinement* Recipe;
    RefinementView View;
    /// nullptr to draw all faces.
    const CullingView* Culling;
    /// Whether back faces of closed surfaces are culled, too.
    bool HidesBackFaces;
  };
  struct Input : ViewInput
  {
    vtkOpenGLRenderWindow* Window;
    /// Whether a wireframe is drawn.
    bool HasLines;
    /// A SelectionDevice; failures of SELECTION_DEVICE_GPU are errors.
    int Device;
    /// Whether context, method and colours can do with a selection on the GPU.
    bool CanCompute;
  };

  /// Add a prepared mesh to those that share a budget, if its tags can be used.
  void AddBudgetPart(const ViewInput& input, std::vector<LevelBudget::Part>& parts);

  /**
   * Choose the device, and update the selection of a view as far as the CPU does it.
   */
  StageResult Update(const Input& input);

  /**
   * Have the GPU do the rest, or the CPU if that fails. Does nothing if the CPU has done it all.
   */
  StageResult UpdateOnGPU(const Input& input, UploadStage& upload);

  /// Whether the GPU has selected what is drawn.
  bool IsOnGPU() const { return this->OnGPU; }
  void SetOnCPU() { this->OnGPU = false; }
  /// What the GPU has selected; nullptr where the CPU has.
  RefinementComputeView* GetComputeView();

  /// Copy what the GPU has selected to the state, if it has changed. `window` may be nullptr.
  void ReadBack(vtkOpenGLRenderWindow* window, const InstanceBuffers& instances);

  /// Base patterns of the faces that are drawn, after ReadBack().
  int CountUsedPatterns() const;

  /// Seconds that the last selection took.
  double GetSeconds() const;

  vtkTypeInt64 GetMemorySize() const { return this->Compute.GetMemorySize(); }
  void ReleaseGraphicsResources();

private:
  StageResult UpdateState(const Input& input);
  bool Select(const Input& input, UploadStage& upload, std::string& error);
  /// What a selection on the GPU is made from, besides the view.
  Dependencies GetSources(const Input& input) const;

  RefinementState State;
  RefinementComputeState Compute;
  bool OnGPU = false;
  Dependencies FailedSources;
  std::string Error; // that was reported last
  double ComputeSeconds = 0.0;
  vtkMTimeType ReadTime = 0;    // of what was read back
  int NumberOfUsedPatterns = 0; // of that
};
}

#endif
