// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::MetricMesh
 * @brief   a mesh with its triangles and edges, as metrics need them
 *
 * Triangles and edges are computed on first use and cached until the points or cells of the mesh
 * change. All metrics of one mesh share them. Not thread-safe.
 */
#ifndef MetricMesh_h
#define MetricMesh_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkTimeStamp.h"                  // for members
#include "vtkType.h"                       // for vtkMTimeType

#include <memory> // for members

class vtkPolyData;

namespace relevo
{
class Dependencies;
class SurfaceEdges;
class SurfaceShape;
class SurfaceTriangles;
struct GlobalSurfaceInfo;

class RELEVOFILTERSREFINEMENT_EXPORT MetricMesh
{
public:
  /// Create an empty object; call Update() to set the mesh.
  MetricMesh();
  explicit MetricMesh(vtkPolyData* mesh);
  MetricMesh(const MetricMesh&) = delete;
  void operator=(const MetricMesh&) = delete;
  ~MetricMesh();

  /// Set the mesh, which must live until the next call. Cached data are reused if its points and
  /// cells are the same objects and have not changed.
  void Update(vtkPolyData* mesh);

  //@{
  /// Set the whole surface that the mesh is a piece of. nullptr, the default, means that the mesh
  /// is the whole surface.
  void SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole);
  const GlobalSurfaceInfo* GetWhole() const { return this->Whole.get(); }
  //@}

  vtkPolyData* GetPolyData() const { return this->Mesh; }
  /// Return the time of the latest change of the points, the cells or the whole surface.
  vtkMTimeType GetTime() const { return this->ShapeTime; }

  const std::shared_ptr<const SurfaceTriangles>& GetTriangles();
  const std::shared_ptr<const SurfaceEdges>& GetEdges();

private:
  friend SurfaceShape& GetShape(MetricMesh& mesh);

  vtkPolyData* Mesh = nullptr;
  std::shared_ptr<const GlobalSurfaceInfo> Whole;
  std::unique_ptr<SurfaceShape> Shape;
  std::unique_ptr<Dependencies> ShapeDependencies;
  vtkTimeStamp ShapeTime;
};
}

#endif
