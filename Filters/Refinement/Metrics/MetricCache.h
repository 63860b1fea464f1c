// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MetricCache
 * @brief   what tags are computed from: a mesh's shape and a metric's evaluator for it
 *
 * Owned by what refines the mesh, a mapper's block or a filter, so that nothing is computed twice
 * from frame to frame. To be used by one thread at a time.
 */
#ifndef MetricCache_h
#define MetricCache_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkMTimeType
#include "vtkWeakPointer.h"                // for members

#include <map>    // for members
#include <memory> // for members

class vtkAlgorithm;
class vtkDepthTagMetric;
class vtkPolyData;

namespace relevo
{
class MetricEvaluator;
class MetricMesh;
struct GlobalSurfaceInfo;

class RELEVOFILTERSREFINEMENT_EXPORT MetricCache
{
public:
  MetricCache();
  ~MetricCache();
  MetricCache(const MetricCache&) = delete;
  void operator=(const MetricCache&) = delete;

  //@{
  /// What meshes are pieces of, see MetricMesh::SetWhole().
  void SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole);
  const GlobalSurfaceInfo* GetWhole() const { return this->Whole.get(); }
  //@}

  /// The shape of a mesh, as it is.
  MetricMesh& GetMesh(vtkPolyData* mesh);

  /// The metric's evaluator for a mesh, as it is.
  MetricEvaluator& GetEvaluator(vtkDepthTagMetric* metric, vtkPolyData* mesh);

  /// Forget all that is known, where no metric is asked any more.
  void Clear();

private:
  std::shared_ptr<const GlobalSurfaceInfo> Whole;
  std::shared_ptr<MetricMesh> Mesh;
  std::unique_ptr<MetricEvaluator> Evaluator;
};

/**
 * Those of the meshes that a filter meets: it is run for one block of a composite input after the
 * other. A source is dropped when its mesh is gone, or when the last update has not asked for it.
 */
class RELEVOFILTERSREFINEMENT_EXPORT TagSources
{
public:
  TagSources();
  ~TagSources();
  TagSources(const TagSources&) = delete;
  void operator=(const TagSources&) = delete;

  /// The source of a mesh, to be asked for while the filter runs.
  const std::shared_ptr<MetricCache>& Find(vtkAlgorithm* filter, vtkPolyData* mesh);

  void Clear() { this->Sources.clear(); }

private:
  struct Entry
  {
    std::shared_ptr<MetricCache> Source;
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkMTimeType Update = 0; // that asked for it last
  };
  void DropUnused();

  std::map<vtkPolyData*, Entry> Sources;
  vtkMTimeType Update = 0; // the pipeline's time of it
  vtkMTimeType LastUpdate = 0;
};
}

#endif
