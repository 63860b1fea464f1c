// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementState
 * @brief   what a mapper has computed of its input and recipe: mesh, bounds, levels
 *
 * Each is made anew only when something it depends on has changed; what went wrong is said once,
 * when it is made. CPU side only. Private to the module.
 */
#ifndef vtkRefinementState_h
#define vtkRefinementState_h

#include "vtkNew.h"              // for members
#include "vtkPatternSelection.h" // for members
#include "vtkRefinementMesh.h"   // for members
#include "vtkTimeStamp.h"        // for members

#include <string> // for messages
#include <vector> // for members

class vtkAdaptiveRefinement;
class vtkPolyData;
struct vtkRefinementView;

namespace relevo
{
class RefinementState
{
public:
  RefinementState();
  ~RefinementState();

  /**
   * Prepare the mesh. False when the recipe cannot be applied to the input.
   */
  bool UpdateMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe);

  /**
   * Evaluate levels and group faces, for a valid mesh. False when depth-tags cannot be used.
   */
  bool UpdateSelection(
    vtkPolyData* input, vtkAdaptiveRefinement* recipe, const vtkRefinementView& view);

  /**
   * Bounds of all that is drawn, for a valid mesh: refined faces, vertices and lines.
   */
  void GetBounds(vtkPolyData* input, vtkAdaptiveRefinement* recipe, double bounds[6]);

  //@{
  /**
   * What the last update had to say, once; empty for nothing.
   */
  std::string TakeError();
  std::string TakeWarning();
  //@}

  const RefinementMesh& GetMesh() const { return this->Mesh; }
  bool IsMeshValid() const { return this->MeshValid; }
  vtkMTimeType GetMeshTime() const { return this->MeshTime; }

  /// The input, with normals where they had to be computed.
  vtkPolyData* GetPreparedInput() { return this->PreparedInput; }

  const PatternSelection& GetSelection() const { return this->Selection; }
  vtkMTimeType GetSelectionTime() const { return this->SelectionTime; }

  /// Triangles of the selection, less those over no-data.
  vtkIdType GetNumberOfTriangles(vtkAdaptiveRefinement* recipe);

  vtkIdType GetNumberOfSelections() const { return this->NumberOfSelections; }

  /// Seconds the last selection took.
  double GetSelectionSeconds() const { return this->SelectionSeconds; }

private:
  // Values that decide whether something must be made anew.
  using Dependencies = std::vector<vtkMTimeType>;

  RefinementMesh Mesh;
  Dependencies MeshDependencies;
  bool MeshValid = false;
  vtkTimeStamp MeshTime;
  vtkNew<vtkPolyData> PreparedInput;

  double Bounds[6];
  Dependencies BoundsDependencies;

  PatternSelection Selection;
  Dependencies SelectionDependencies;
  bool SelectionValid = false;
  vtkTimeStamp SelectionTime;
  vtkIdType NumberOfSelections = 0;
  double SelectionSeconds = 0.0;
  vtkIdType NumberOfTriangles = -1; // not counted yet

  std::string Error;
  std::string Warning;
};
}

#endif
