// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementState
 * @brief   what a mapper has computed of its input and recipe: mesh, bounds, levels
 *
 * Each is made anew only when something it depends on has changed; an error is reported once,
 * when it is made. CPU side only. Private to the module.
 */
#ifndef RefinementState_h
#define RefinementState_h

#include "Evaluation/FaceCulling.h" // for members
#include "Mesh/RefinementMesh.h"    // for members
#include "State/ViewSelection.h"    // for members
#include "vtkNew.h"                 // for members
#include "vtkTimeStamp.h"           // for members

#include <array>   // for members
#include <memory>  // for members
#include <string>  // for messages
#include <utility> // for std::move
#include <vector>  // for members

class vtkAdaptiveRefinement;
class vtkCamera;
class vtkMatrix4x4;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
struct GlobalSurfaceInfo;
class MetricCache;

class RefinementState
{
public:
  RefinementState();
  ~RefinementState();

  /// What the mesh is a piece of; nullptr, the default, where it is the whole.
  void SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole);
  const std::shared_ptr<const GlobalSurfaceInfo>& GetWhole() const { return this->Whole; }

  /// The metric's evaluator for the mesh.
  MetricCache& GetMetricCache() { return *this->Cache; }

  /**
   * Prepare the mesh. False when the recipe cannot be applied to the input, its numbers are too
   * large, or its pattern table lacks the patterns.
   */
  bool UpdateMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
  {
    return this->BuildMesh(input, recipe) && this->Check(recipe);
  }

  /**
   * Evaluate the tags for a view, for a valid mesh. False when they cannot be used.
   */
  bool UpdateTags(
    vtkPolyData* input, vtkAdaptiveRefinement* recipe, const RefinementView& view, bool onGPU);

  /// Whether a budget moves levels, and what it adds to the tags of all edges beside the recipe's
  /// own offset.
  bool IsBudgeted = false;
  double LevelOffset = 0.0;

  /**
   * Find the faces that are culled, for valid tags: those that `culling` does not see and, with
   * `hideBackFaces`, back faces of closed surfaces; none for nullptr.
   */
  void UpdateSight(vtkAdaptiveRefinement* recipe, const CullingView* culling, bool hideBackFaces);

  /**
   * Evaluate levels and group faces, for a valid mesh. False when depth-tags cannot be used. Of
   * several views (passes with cameras of their own, several renderers or actors) the latest are
   * kept. For `culling` and `hideBackFaces` see UpdateSight(). With `onGPU` only tags are
   * evaluated: the GPU does the rest.
   */
  bool UpdateSelection(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
    const RefinementView& view, const CullingView* culling, bool hideBackFaces, bool onGPU);

  /// What of the mesh is out of sight, and when it was made.
  const FaceCulling& GetCulling(vtkAdaptiveRefinement* recipe);
  vtkMTimeType GetCullingTime() const { return this->CullingTime; }

  /// Evaluate levels anew, with the next update.
  void ForgetLevels();

  /// See ViewSelection::Assign().
  void AssignSelection(const PatternFamily& family, std::vector<unsigned int> entries,
    std::vector<float> morphTags, std::vector<unsigned char> hidden)
  {
    this->Current->Assign(family, std::move(entries), std::move(morphTags), std::move(hidden));
  }

  /**
   * Bounds of all that is drawn, for a valid mesh: refined faces, vertices and lines.
   */
  void GetBounds(vtkAdaptiveRefinement* recipe, double bounds[6]);

  //@{
  /**
   * What the last update had to say, once; empty for nothing.
   */
  std::string TakeError();
  std::string TakeWarning();
  //@}

  /// Forget the mesh and its views; GetNumberOfSelections() counts on.
  void Clear();
  /// Whether there has been an input since then.
  bool HasMesh() const { return !this->MeshDependencies.IsEmpty(); }

  const RefinementMesh& GetMesh() const { return *this->Mesh; }
  bool IsMeshValid() const { return this->MeshValid; }
  vtkMTimeType GetMeshTime() const { return this->MeshTime; }

  /// What VTK can take of the input: nothing but points until a mesh is prepared. With normals
  /// where they had to be computed and ghosts emptied: see EmptyGhosts().
  vtkPolyData* GetPreparedInput() { return this->PreparedInput; }

  /// The selection of the last view.
  const ViewSelection& GetSelection() const { return *this->Current; }
  /// Where that view is kept, in [0, MaximumViews).
  int GetSelectionSlot() const { return static_cast<int>(this->Current - this->Views.data()); }
  static constexpr int MaximumViews = 4;

  /// Triangles of the selection, less those over no-data, as they were when it was made.
  FaceSums CountTriangles() { return this->Current->CountTriangles(); }

  vtkIdType GetNumberOfSelections() const { return this->NumberOfSelections; }
  void AddSelections(vtkIdType selections) { this->NumberOfSelections += selections; }

private:
  ViewSelection& FindView(
    vtkPolyData* input, vtkAdaptiveRefinement* recipe, const RefinementView& view);
  bool BuildMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe);
  bool Check(vtkAdaptiveRefinement* recipe);
  void Warn(const std::string& warning);
  CullingInput GetCullingInput(
    vtkAdaptiveRefinement* recipe, const CullingView* culling, bool hideBackFaces);
  SelectionInput GetSelectionInput(vtkPolyData* input, vtkAdaptiveRefinement* recipe) const;
  void UpdateHoles(vtkAdaptiveRefinement* recipe);

  std::shared_ptr<const GlobalSurfaceInfo> Whole;
  vtkTimeStamp WholeTime;
  std::shared_ptr<MetricCache> Cache;
  // Shared with the views that it was drawn in.
  std::shared_ptr<const RefinementMesh> Mesh = std::make_shared<RefinementMesh>();
  Dependencies MeshDependencies;
  bool MeshValid = false;
  bool NeedsUnitNormals = false; // of the input
  vtkTimeStamp MeshTime;
  vtkNew<vtkPolyData> PreparedInput;

  double Bounds[6];
  Dependencies BoundsDependencies;
  FaceCulling Culling;
  Dependencies CullingDependencies;
  vtkTimeStamp CullingTime;
  HeightValidity Holes;
  Dependencies HolesDependencies;
  vtkTimeStamp HolesTime;

  struct View
  {
    // To compare, never read.
    const vtkCamera* Camera = nullptr;
    const vtkMatrix4x4* ModelToWorld = nullptr;
    vtkTypeUInt64 LastUse = 0;
  };
  std::vector<ViewSelection> Views; // MaximumViews of them
  std::array<View, MaximumViews> ViewUses;
  ViewSelection* Current = nullptr;
  vtkTypeUInt64 NumberOfUses = 0;
  vtkIdType NumberOfSelections = 0;

  std::string Error;
  std::string Warning;
  // That were reported last.
  std::string ArrayError;
  std::string RecipeError;
  std::string PatternError;
};
}

#endif
