// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinementFilter
 * @brief   refine a coarse surface on the CPU according to a recipe
 *
 * This filter creates the same triangles as vtkAdaptiveRefinementMapper for the same recipe. Points
 * agree to float accuracy. The output is a vtkPolyData that you can save, measure and filter
 * further.
 *
 * The input is a vtkPolyData with polygons of any size and triangle strips. Polygons are split into
 * triangle fans, as VTK's mappers do. Vertices and lines are passed through unchanged. Where a
 * displacement moves a face's points, vertices and lines get separate points. Polygons with fewer
 * than three points and triangles with coincident corners or non-finite coordinates are skipped,
 * and a warning gives their number.
 *
 * The output triangles keep the winding of their coarse cells. Input points come first. Triangles
 * share points where the input's cells do. If the surface has several normals at a point (sharp
 * edges), the output has one copy of the point per normal, with identical coordinates and data.
 * These copies come last. Normals that differ by a vector of length 0.001 or less (0.06 degrees)
 * share a point. To merge the copies, use vtkCleanPolyData with a tolerance of 0.
 *
 * The output is watertight: both sides of an edge have bitwise equal points, also where coincident
 * points are not shared (creases, split normals, texture seams). Float points remain float. All
 * other types become double, with the precision of floats relative to the middle of the mesh.
 *
 * Point data are interpolated linearly and keep their type. Integers are rounded. Strings, bits and
 * ghost flags are copied from the nearest coarse point. Global and pedigree ids are removed. See
 * vtkAdaptiveRefinement::SetNoDataMagnitude() for missing values. The array "Normals" has the unit
 * normals of the refined surface as floats and replaces the input's normals. Cell data are passed
 * on, and the cell array "vtkOriginalCellIds" (vtkIdType) has the ids of the input's cells. Cell
 * normals are removed if the surface is curved or displaced. Global cell ids become an ordinary
 * array.
 *
 * If a displacement has holes, triangles over missing data are removed. In that case, and if some
 * points are not finite, unused points are removed too.
 *
 * Ghost cells that duplicate cells of another piece (DUPLICATECELL) are used as neighbours. They
 * are not part of the output, nor are points that only they use.
 *
 * The filter reports an error, and its output is empty, if there is no recipe or no cell, if cells
 * refer to missing points, if depth-tags or texture coordinates cannot be used, if a metric or
 * height map fails, or if memory runs out.
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
   * Set the recipe. Required.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  //@{
  /**
   * Set the controller of the processes that have the other pieces of the surface. By default there
   * is none, and the input is the whole surface. With a controller, the processes exchange values
   * of the whole surface so that the pieces match. All processes must update the filter for the
   * same number of blocks; a piece may be empty. Each piece needs two layers of ghost cells
   * (DUPLICATECELL) and the same order of points on all processes. vtkPAdaptiveRefinementFilter in
   * the ParaView plugin sets the controller and prepares the pieces.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  //@}

  /**
   * Return the time of the latest change of the filter or its recipe. If the metric depends on
   * Camera or ModelToWorld, their times count too.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkAdaptiveRefinementFilter();
  ~vtkAdaptiveRefinementFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// Process one mesh. Returns false after reporting an error.
  bool Refine(vtkPolyData* input, vtkPolyData* output);

  vtkSmartPointer<vtkAdaptiveRefinement> Refinement;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  /// Check the input and select the levels. Returns false after reporting an error.
  bool Prepare(
    vtkPolyData* input, relevo::RefinementMesh& mesh, relevo::PatternSelection& selection);

  std::unique_ptr<relevo::TagSources> Sources;
  std::string Warning; // the last warning, to report each one once

  vtkAdaptiveRefinementFilter(const vtkAdaptiveRefinementFilter&) = delete;
  void operator=(const vtkAdaptiveRefinementFilter&) = delete;
};

#endif
