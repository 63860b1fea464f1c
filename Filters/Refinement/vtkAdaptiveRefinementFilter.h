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
 * with coordinates that are not finite are dropped; a warning says how many.
 *
 * Output: triangles that wind as their coarse cell does; the input's points come first. Triangles
 * share points as the input's cells do. Where the surface gives the faces around a point different
 * normals (sharp edges), each normal has a point of its own: copies with the same coordinates, to
 * the bit, and the same data. They come last. Normals that differ by up to 0.001, the length of the
 * difference (0.06 degrees), share a point. vtkCleanPolyData with a tolerance of 0 merges copies.
 *
 * Watertight to the bit: an edge's points are the same from both sides, also where points coincide
 * without being shared (creases, split normals, texture seams). Float points stay float; all others
 * become double, with the precision of floats relative to the middle of the mesh.
 *
 * Point data are interpolated linearly and keep their type: integers are rounded; strings, bits and
 * ghost flags are those of the nearest coarse point; global and pedigree ids are left out. See
 * vtkAdaptiveRefinement::SetNoDataMagnitude() for values that stand for no data. "Normals", unit
 * float vectors of the refined surface, replace the input's normals. Cell data are passed on, and
 * the cell array "vtkOriginalCellIds" (vtkIdType) holds the ids of the input's cells. Cell normals
 * are left out where the surface is not linear or is displaced, and global ids become a plain
 * array.
 *
 * Where a displacement leaves holes, triangles over no-data are left out. Then, and where points
 * are not finite, points that no cell uses are left out as well.
 *
 * Cells whose vtkGhostType says that another piece has them (DUPLICATECELL) count as neighbours and
 * are left out, with the points that no other cell uses.
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
#include "vtkSmartPointer.h"               // for members
#include "vtkViewDependentAlgorithm.h"

#include <memory> // for members
#include <string> // for members

class vtkAdaptiveRefinement;
class vtkMultiProcessController;

namespace relevo
{
class PatternSelection;
class RefinementMesh;
class TagSources;
}

class RELEVOFILTERSREFINEMENT_EXPORT vtkAdaptiveRefinementFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkAdaptiveRefinementFilter* New();
  vtkTypeMacro(vtkAdaptiveRefinementFilter, vtkViewDependentAlgorithm);
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
   * The processes that have the other pieces of the surface; none, the default, means that the
   * input is all of it. What depends on the whole is then agreed on, so that the pieces fit: all
   * processes update the filter, for as many blocks, and one may have no cells. Each piece needs
   * two layers of ghost cells (DUPLICATECELL), and points that lie in the same order on all
   * processes: vtkPAdaptiveRefinementFilter of the plugin for ParaView, which sets the controller,
   * sees to both.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  //@}

  /**
   * Latest change of the filter, its recipe or, for metrics that depend on them, Camera and
   * ModelToWorld.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkAdaptiveRefinementFilter();
  ~vtkAdaptiveRefinementFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// RequestData() for one mesh: false after an ErrorEvent.
  bool Refine(vtkPolyData* input, vtkPolyData* output);

  vtkSmartPointer<vtkAdaptiveRefinement> Refinement;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  /// Check everything and select levels; false after an ErrorEvent.
  bool Prepare(
    vtkPolyData* input, relevo::RefinementMesh& mesh, relevo::PatternSelection& selection);

  std::unique_ptr<relevo::TagSources> Sources;
  std::string Warning; // that was warned of

  vtkAdaptiveRefinementFilter(const vtkAdaptiveRefinementFilter&) = delete;
  void operator=(const vtkAdaptiveRefinementFilter&) = delete;
};

#endif
