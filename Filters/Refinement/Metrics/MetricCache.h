// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MetricCache
 * @brief   caches a mesh's shape and a metric's evaluator for it
 *
 * A mapper's block or a filter owns the cache, so that nothing is recomputed from frame to frame.
 * Not thread-safe.
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
  /// The whole surface that meshes are pieces of, see MetricMesh::SetWhole().
  void SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole);
  const GlobalSurfaceInfo* GetWhole() const { return this->Whole.get(); }
  //@}

  /// Update and return the shape of a mesh.
  MetricMesh& GetMesh(vtkPolyData* mesh);

  /// Update and return the metric's evaluator for a mesh.
  MetricEvaluator& GetEvaluator(vtkDepthTagMetric* metric, vtkPolyData* mesh);

  /// Clear the cache, when no metric is used any more.
  void Clear();

private:
  std::shared_ptr<const GlobalSurfaceInfo> Whole;
  std::shared_ptr<MetricMesh> Mesh;
  std::unique_ptr<MetricEvaluator> Evaluator;
};

/**
 * The caches of the meshes of a filter, which processes the blocks of a composite input one by one.
 * A cache is removed when its mesh is deleted or was not used in the last update.
 */
class RELEVOFILTERSREFINEMENT_EXPORT TagSources
{
public:
  TagSources();
  ~TagSources();
  TagSources(const TagSources&) = delete;
  void operator=(const TagSources&) = delete;

  /// Return the cache of a mesh. Call this only while the filter executes.
  const std::shared_ptr<MetricCache>& Find(vtkAlgorithm* filter, vtkPolyData* mesh);

  void Clear() { this->Sources.clear(); }

private:
  struct Entry
  {
    std::shared_ptr<MetricCache> Source;
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkMTimeType Update = 0; // the last update that used it
  };
  void DropUnused();

  std::map<vtkPolyData*, Entry> Sources;
  vtkMTimeType Update = 0; // the time of the pipeline's current update
  vtkMTimeType LastUpdate = 0;
};
}

#endif
