// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceShape
 * @brief   the data that metrics need of the points and cells of a mesh
 *
 * Each part is computed on first use. Not thread-safe. MetricMesh provides the parts for authors of
 * metrics, and GetShape() all parts for the module's metrics.
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
  /// Holds references to the mesh's points and cells, which must not change.
  explicit SurfaceShape(vtkPolyData* mesh);

  /// The whole surface that the mesh is a piece of; nullptr if it is the whole.
  void SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole);

  const std::shared_ptr<const SurfaceTriangles>& GetTriangles();
  const std::shared_ptr<const SurfaceEdges>& GetEdges();
  const LocalPoints& GetPoints();
  const SurfaceNormals& GetNormals();
  const DiscreteCurvature& GetCurvature();
  //@{
  /// Boxes of the whole surface.
  const FiniteBox& GetPointBox() { return this->GetBoxes().PointBox; }
  const FiniteBox& GetCornerBox() { return this->GetBoxes().CornerBox; }
  //@}
  /// Boxes of this mesh.
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

/// The shape of a mesh at its last update.
RELEVOFILTERSREFINEMENT_EXPORT SurfaceShape& GetShape(MetricMesh& mesh);
}

#endif
