// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TagSource
 * @brief   what tags are computed from: a mesh's shape and a metric's evaluator for it
 *
 * Owned by what refines the mesh, a mapper's block or a filter, so that nothing is computed twice
 * from frame to frame. To be used by one thread at a time.
 */
#ifndef TagSource_h
#define TagSource_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkSmartPointer.h"               // for members
#include "vtkWeakPointer.h"                // for members

#include <memory>  // for members
#include <utility> // for members
#include <vector>  // for members

class vtkDepthTagMetric;
class vtkPolyData;

namespace relevo
{
class MetricEvaluator;
class MetricMesh;

class RELEVOFILTERSREFINEMENT_EXPORT TagSource
{
public:
  TagSource();
  ~TagSource();
  TagSource(const TagSource&) = delete;
  void operator=(const TagSource&) = delete;

  /// The shape of a mesh, as it is.
  MetricMesh& GetMesh(vtkPolyData* mesh);

  /// The metric's evaluator for a mesh, as it is.
  MetricEvaluator& GetEvaluator(vtkDepthTagMetric* metric, vtkPolyData* mesh);

private:
  std::shared_ptr<MetricMesh> Mesh;
  vtkSmartPointer<vtkDepthTagMetric> Metric; // of the evaluator
  std::unique_ptr<MetricEvaluator> Evaluator;
};

/**
 * Those of all meshes that a filter has met and that still exist: it is run for one block of a
 * composite input after the other.
 */
class RELEVOFILTERSREFINEMENT_EXPORT TagSources
{
public:
  TagSources();
  ~TagSources();
  TagSources(const TagSources&) = delete;
  void operator=(const TagSources&) = delete;

  const std::shared_ptr<TagSource>& Find(vtkPolyData* mesh);

private:
  std::vector<std::pair<vtkWeakPointer<vtkPolyData>, std::shared_ptr<TagSource>>> Sources;
};
}

#endif
