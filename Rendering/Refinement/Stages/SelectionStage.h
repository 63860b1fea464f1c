// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SelectionStage
 * @brief   prepares a mesh, evaluates its levels and selects the faces to draw, on the CPU or GPU
 *
 * RefinementState has the results of the CPU, RefinementComputeState those of the GPU. If selection
 * on the GPU fails, the CPU selects until the mesh, the patterns or the metric change. Private to
 * the module.
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

  /// Return the messages of the last update of the state.
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
    /// Whether the context, the method and the colours support selection on the GPU.
    bool CanCompute;
  };

  /// Add a prepared mesh to the parts that share a budget, if its tags can be used.
  void AddBudgetPart(const ViewInput& input, std::vector<LevelBudget::Part>& parts);

  /**
   * Choose the processor, and run the CPU's part of the selection of a view.
   */
  StageResult Update(const Input& input);

  /**
   * Run the rest on the GPU, or on the CPU if the GPU fails. If the CPU has done everything,
   * nothing happens.
   */
  StageResult UpdateOnGPU(const Input& input, UploadStage& upload);

  /// Return whether the GPU has selected the drawn faces.
  bool IsOnGPU() const { return this->OnGPU; }
  void SetOnCPU() { this->OnGPU = false; }
  /// Return the selection of the GPU; nullptr if the CPU has selected.
  RefinementComputeView* GetComputeView();

  /// Copy the selection of the GPU to the state, if it has changed. `window` may be nullptr.
  void ReadBack(vtkOpenGLRenderWindow* window, const InstanceBuffers& instances);

  /// Return the number of base patterns of the drawn faces, after ReadBack().
  int CountUsedPatterns() const;

  /// Return the seconds of the last selection.
  double GetSeconds() const;

  vtkTypeInt64 GetMemorySize() const { return this->Compute.GetMemorySize(); }
  void ReleaseGraphicsResources();

private:
  StageResult UpdateState(const Input& input);
  bool Select(const Input& input, UploadStage& upload, std::string& error);
  /// Return the dependencies of a selection on the GPU, without the view.
  Dependencies GetSources(const Input& input) const;

  RefinementState State;
  RefinementComputeState Compute;
  bool OnGPU = false;
  Dependencies FailedSources;
  std::string Error; // error that was reported last
  double ComputeSeconds = 0.0;
  vtkMTimeType ReadTime = 0;    // time of the selection that was read back
  int NumberOfUsedPatterns = 0; // in that selection
};
}

#endif
