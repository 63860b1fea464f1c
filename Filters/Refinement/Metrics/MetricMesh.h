// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::MetricMesh
 * @brief   a mesh and what metrics need to know of its shape
 *
 * Triangles and edges are computed when they are first asked for and kept until the mesh's points
 * or cells change, so that all metrics that look at one mesh share them. To be used by one thread
 * at a time.
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
  /// No mesh, until Update().
  MetricMesh();
  explicit MetricMesh(vtkPolyData* mesh);
  MetricMesh(const MetricMesh&) = delete;
  void operator=(const MetricMesh&) = delete;
  ~MetricMesh();

  /// Look at a mesh, which must live until the next call. What is known stays known if its points
  /// and cells are the same objects and have not changed.
  void Update(vtkPolyData* mesh);

  //@{
  /// What the mesh is a piece of; nullptr, the default, where it is the whole.
  void SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole);
  const GlobalSurfaceInfo* GetWhole() const { return this->Whole.get(); }
  //@}

  vtkPolyData* GetPolyData() const { return this->Mesh; }
  /// Another one whenever the points, the cells or the whole are.
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
