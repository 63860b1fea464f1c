// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MetricMesh
 * @brief   a mesh and what metrics need to know of its shape
 *
 * Its triangles, edges, normals and so on. Each is computed when it is first asked for and kept
 * until the mesh's points or cells change, so that all metrics that look at one mesh share it. To
 * be used by one thread at a time.
 */
#ifndef MetricMesh_h
#define MetricMesh_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkMTimeType

#include <memory> // for members

class vtkPolyData;

namespace relevo
{
class LocalPoints;
class SurfaceDiagonal;
class SurfaceEdges;
class SurfaceNormals;
class SurfaceTriangles;
struct DiscreteCurvature;

class RELEVOFILTERSREFINEMENT_EXPORT MetricMesh
{
public:
  MetricMesh();
  explicit MetricMesh(vtkPolyData* mesh);
  MetricMesh(const MetricMesh&) = delete;
  void operator=(const MetricMesh&) = delete;
  ~MetricMesh();

  /// Look at a mesh, which must live until the next call. What is known stays known if its points
  /// and cells are the same objects and have not changed.
  void Update(vtkPolyData* mesh);

  vtkPolyData* GetPolyData() const { return this->Mesh; }
  /// Another one whenever the points or cells are.
  vtkMTimeType GetTime() const;

  const std::shared_ptr<const SurfaceTriangles>& GetTriangles();
  const std::shared_ptr<const SurfaceEdges>& GetEdges();

  //@{
  /// For the module's own metrics.
  const LocalPoints& GetPoints();
  const SurfaceNormals& GetNormals();
  const SurfaceDiagonal& GetDiagonal();
  const DiscreteCurvature& GetCurvature();
  //@}

private:
  struct Shape;

  vtkPolyData* Mesh = nullptr;
  std::unique_ptr<Shape> Known;
};
}

#endif
