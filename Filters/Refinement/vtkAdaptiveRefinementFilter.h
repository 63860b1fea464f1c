// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinementFilter
 * @brief   a recipe evaluated on the CPU: coarse surface in, refined surface out
 *
 * The twin of vtkAdaptiveRefinementMapper: same recipe, same triangles, same points to float
 * accuracy, as a vtkPolyData that can be saved, measured and filtered further.
 *
 * Input: a vtkPolyData with polygons of any size and triangle strips; polygons are cut into fans as
 * VTK's mappers do. Vertices and lines pass through and stay where they are: where the displacement
 * moves a face's points, they get points of their own. Triangles with two corners at one place or
 * with non-finite coordinates are dropped, with their count in a warning.
 *
 * Output: triangles that wind as their coarse cell does and share points as the input's cells do,
 * unless the surface has a crease there; the input's points come first. Watertight to the bit: an
 * edge's points are the same from both sides, also where points coincide without being shared
 * (creases, split normals, texture seams). Float points stay float; all others become double,
 * accurate to a float's digits about the middle of the mesh.
 *
 * Point data are interpolated linearly and keep their type: integers are rounded; strings, bits and
 * ghost flags are the nearest coarse point's; global and pedigree ids are left out. What stands for
 * no data spreads as no data, see vtkAdaptiveRefinement::SetNoDataMagnitude(). "Normals", unit
 * float vectors of the refined surface, take the place of the input's normals. Cell data are passed
 * on, and the cell array "vtkOriginalCellIds" (vtkIdType) names the input's cell; cell normals end
 * where the surface is not linear or is displaced, and global ids become a plain array.
 *
 * Where a displacement leaves holes, triangles over no-data are left out. Then, and where points
 * are not finite, points that no cell uses are left out as well.
 *
 * Cells whose vtkGhostType says that another piece has them (DUPLICATECELL) count as neighbours and
 * are left out.
 *
 * Errors: no recipe, no cells, cells that refer to missing points, depth-tags or texture
 * coordinates that cannot be used, a metric or height map that fails, not enough memory. The output
 * is then empty.
 *
 * @sa vtkAdaptiveRefinement vtkAdaptiveRefinementMapper
 */
#ifndef vtkAdaptiveRefinementFilter_h
#define vtkAdaptiveRefinementFilter_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

class vtkAdaptiveRefinement;
class vtkCamera;
class vtkMatrix4x4;

#ifndef __VTK_WRAP__
namespace relevo
{
class PatternSelection;
class RefinementMesh;
}
#endif

class RELEVOFILTERSREFINEMENT_EXPORT vtkAdaptiveRefinementFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkAdaptiveRefinementFilter* New();
  vtkTypeMacro(vtkAdaptiveRefinementFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * What to refine to. Required.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  //@{
  /**
   * The camera of view-dependent metrics, in world coordinates.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Width and height in pixels of the viewport of view-dependent metrics, default 300 x 300.
   * Sizes below 1 are an error and change nothing.
   */
  void SetViewportSize(int width, int height);
  void SetViewportSize(const int size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, int);
  //@}

  //@{
  /**
   * From the input's coordinates to the camera's world (an actor's matrix); none means identity.
   */
  void SetModelToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetModelToWorld();
  //@}

  /**
   * Latest change of the filter, its recipe or its camera.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkAdaptiveRefinementFilter();
  ~vtkAdaptiveRefinementFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkAdaptiveRefinement> Refinement;
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkMatrix4x4> ModelToWorld;
  int ViewportSize[2] = { 300, 300 };

private:
#ifndef __VTK_WRAP__
  /// Check everything and select levels; false after an ErrorEvent.
  bool Prepare(
    vtkPolyData* input, relevo::RefinementMesh& mesh, relevo::PatternSelection& selection);
#endif

  vtkAdaptiveRefinementFilter(const vtkAdaptiveRefinementFilter&) = delete;
  void operator=(const vtkAdaptiveRefinementFilter&) = delete;
};

#endif
