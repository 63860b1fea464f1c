// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::FaceErrorEvaluator
 * @brief   searches levels with which refined faces deviate by no more than a limit
 *
 * A derived class provides the faces, which measure themselves with each pattern. See LevelSearch
 * for the search.
 */
#ifndef FaceErrorEvaluator_h
#define FaceErrorEvaluator_h

#include "Metrics/DisplacedFaces.h"        // for results
#include "Metrics/MetricEvaluator.h"       // for superclass
#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkSmartPointer.h"               // for members

#include <memory> // for members
#include <string> // for errors

class vtkFaceErrorDepthTagMetric;

namespace relevo
{
class Dependencies;
class PatternFamily;

class RELEVOFILTERSREFINEMENT_EXPORT FaceErrorEvaluator : public MetricEvaluator
{
public:
  ~FaceErrorEvaluator() override;

  bool ComputeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;
  bool ComputeEdgeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;

protected:
  FaceErrorEvaluator(vtkFaceErrorDepthTagMetric* metric, std::shared_ptr<MetricMesh> mesh);

  /// Why the faces of a view cannot be measured, without a full stop, or "".
  virtual std::string FindError(const RefinementView&) const { return ""; }
  /// Add what MakeFaces() depends on, without the mesh, its points and the patterns.
  virtual void AddTo(const RefinementView&, Dependencies&) const {}
  /// The highest level of an edge.
  virtual int GetHighestLevel(const RefinementView& view, int maximumLevel) const = 0;
  /// Return nullptr if there is nothing to measure, or also an error.
  virtual std::unique_ptr<DisplacedFaces> MakeFaces(const RefinementView& view,
    const std::shared_ptr<const PatternFamily>& patterns, int maximumLevel, std::string& error) = 0;

private:
  bool Search(const RefinementView& view, int maximumLevel, bool isPerEdge);
  bool Update(const RefinementView& view, int maximumLevel, bool isPerEdge);
  bool FindLimits(const RefinementView& view);
  bool Fail(const std::string& error);

  struct State;

  const vtkSmartPointer<vtkFaceErrorDepthTagMetric> Metric;
  const std::unique_ptr<State> Kept; // of the last search
};
}

#endif
