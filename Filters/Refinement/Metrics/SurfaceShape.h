// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceShape
 * @brief   what metrics need to know of the points and cells of a mesh
 *
 * Each part is computed when it is first asked for. To be used by one thread at a time. A
 * MetricMesh hands out the parts that authors of metrics need, and GetShape() all of them to the
 * module's own metrics.
 */
#ifndef SurfaceShape_h
#define SurfaceShape_h

#include "Mesh/SurfaceEdges.h"
#include "Mesh/SurfaceNormals.h"
#include "Mesh/SurfaceTriangles.h"
#include "Metrics/DiscreteCurvature.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Points/LocalPoints.h"
#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkNew.h"                        // for members
#include "vtkPolyData.h"                   // for members

#include <memory> // for members

namespace relevo
{
class MetricMesh;

class RELEVOFILTERSREFINEMENT_EXPORT SurfaceShape
{
public:
  /// The mesh's points and cells are referred to, and kept: they must stay as they are.
  explicit SurfaceShape(vtkPolyData* mesh);

  /// What the mesh is a piece of; nullptr where it is the whole.
  void SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole);

  const std::shared_ptr<const SurfaceTriangles>& GetTriangles();
  const std::shared_ptr<const SurfaceEdges>& GetEdges();
  const LocalPoints& GetPoints();
  const SurfaceNormals& GetNormals();
  const DiscreteCurvature& GetCurvature();
  //@{
  /// Of the whole.
  const FiniteBox& GetPointBox() { return this->GetBoxes().PointBox; }
  const FiniteBox& GetCornerBox() { return this->GetBoxes().CornerBox; }
  //@}
  /// Of the mesh itself.
  const GlobalSurfaceInfo& GetOwnBoxes();

private:
  const GlobalSurfaceInfo& GetBoxes() { return this->Whole ? *this->Whole : this->GetOwnBoxes(); }

  vtkNew<vtkPolyData> Mesh;
  std::shared_ptr<const SurfaceTriangles> Triangles;
  std::shared_ptr<const SurfaceEdges> Edges;
  std::unique_ptr<LocalPoints> Points;
  std::unique_ptr<SurfaceNormals> Normals;
  std::unique_ptr<GlobalSurfaceInfo> Boxes;
  std::shared_ptr<const GlobalSurfaceInfo> Whole;
  std::unique_ptr<DiscreteCurvature> Curvature;
};

/// The shape of a mesh as it was when it was last updated.
RELEVOFILTERSREFINEMENT_EXPORT SurfaceShape& GetShape(MetricMesh& mesh);
}

#endif
