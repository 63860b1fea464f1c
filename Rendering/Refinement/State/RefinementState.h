// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementState
 * @brief   the mesh, bounds and levels that a mapper computes from its input and recipe
 *
 * Each result is computed again only when one of its dependencies has changed. An error is reported
 * once, when the result is computed. It runs on the CPU. Private to the module.
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

  /// Set the information on the whole surface that the mesh is a piece of. nullptr, the default,
  /// means that the mesh is the whole surface.
  void SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole);
  const std::shared_ptr<const GlobalSurfaceInfo>& GetWhole() const { return this->Whole; }

  /// Return the cached evaluator of the metric for the mesh.
  MetricCache& GetMetricCache() { return *this->Cache; }

  /**
   * Prepare the mesh. Return false if the recipe cannot be applied to the input, its parameters
   * are too large, or its pattern table lacks patterns.
   */
  bool UpdateMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
  {
    return this->BuildMesh(input, recipe) && this->Check(recipe);
  }

  /**
   * Evaluate the tags for a view and a valid mesh. Return false if they cannot be used.
   */
  bool UpdateTags(
    vtkPolyData* input, vtkAdaptiveRefinement* recipe, const RefinementView& view, bool onGPU);

  /// Whether a budget changes the levels, and the offset that it adds to the recipe's offset.
  bool IsBudgeted = false;
  double LevelOffset = 0.0;

  /**
   * Find the culled faces for valid tags: faces outside `culling` and, with `hideBackFaces`, back
   * faces of closed surfaces. With nullptr, no face is culled.
   */
  void UpdateSight(vtkAdaptiveRefinement* recipe, const CullingView* culling, bool hideBackFaces);

  /**
   * Evaluate the levels of a valid mesh and group its faces. Return false if depth-tags cannot be
   * used. The results of the latest views are cached (passes with separate cameras, several
   * renderers or actors). For `culling` and `hideBackFaces` see UpdateSight(). With `onGPU` only
   * tags are evaluated, and the GPU does the rest.
   */
  bool UpdateSelection(vtkPolyData* input, vtkAdaptiveRefinement* recipe,
    const RefinementView& view, const CullingView* culling, bool hideBackFaces, bool onGPU);

  /// Return the data for culling, and their modification time.
  const FaceCulling& GetCulling(vtkAdaptiveRefinement* recipe);
  vtkMTimeType GetCullingTime() const { return this->CullingTime; }

  /// Make the levels out of date.
  void ForgetLevels();

  /// See ViewSelection::Assign().
  void AssignSelection(const PatternFamily& family, std::vector<unsigned int> entries,
    std::vector<float> morphTags, std::vector<unsigned char> hidden)
  {
    this->Current->Assign(family, std::move(entries), std::move(morphTags), std::move(hidden));
  }

  /**
   * Compute the bounds of everything that is drawn for a valid mesh: refined faces, vertices and
   * lines.
   */
  void GetBounds(vtkAdaptiveRefinement* recipe, double bounds[6]);

  //@{
  /**
   * Return the error or warning of the last update, once; empty for none.
   */
  std::string TakeError();
  std::string TakeWarning();
  //@}

  /// Remove the mesh and its views. GetNumberOfSelections() is not reset.
  void Clear();
  /// Return whether there has been an input since the last Clear().
  bool HasMesh() const { return !this->MeshDependencies.IsEmpty(); }

  const RefinementMesh& GetMesh() const { return *this->Mesh; }
  bool IsMeshValid() const { return this->MeshValid; }
  vtkMTimeType GetMeshTime() const { return this->MeshTime; }

  /// Return the input without cells that VTK cannot use; before a mesh is prepared it has only
  /// points. Missing normals have been computed and ghost cells emptied, see EmptyGhosts().
  vtkPolyData* GetPreparedInput() { return this->PreparedInput; }

  /// Return the selection of the last view.
  const ViewSelection& GetSelection() const { return *this->Current; }
  /// Return the slot of that view, in [0, MaximumViews).
  int GetSelectionSlot() const { return static_cast<int>(this->Current - this->Views.data()); }
  static constexpr int MaximumViews = 4;

  /// Return the number of triangles of the selection, without those over no data, at the time of
  /// the selection.
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
  // Shared with the views that were drawn with this mesh.
  std::shared_ptr<const RefinementMesh> Mesh = std::make_shared<RefinementMesh>();
  Dependencies MeshDependencies;
  bool MeshValid = false;
  bool NeedsUnitNormals = false; // whether the input needs unit normals
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
    // For comparison; they are not dereferenced.
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
  // The errors that were reported last.
  std::string ArrayError;
  std::string RecipeError;
  std::string PatternError;
};
}

#endif
