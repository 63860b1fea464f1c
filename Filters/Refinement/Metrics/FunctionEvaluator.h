// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FunctionEvaluator
 * @brief   evaluates the functions of a metric's MetricShader in C++
 *
 * Functions is a class derived from MetricParameters that includes the same files as the shader.
 * Subclasses implement GetShader().
 */
#ifndef FunctionEvaluator_h
#define FunctionEvaluator_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/MetricShader.h"
#include "Metrics/SurfaceShape.h"
#include "Points/LocalPoints.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <cstring> // for std::memcpy
#include <vector>  // for members

/// Marks functions that some metrics do not use, as the shared files do.
#define RELEVO_UNUSED [[maybe_unused]]

namespace relevo
{
/// The parameters that relevoMetricView.glsl requires.
struct MetricParameters
{
  vec4 metricParameters[10];

  explicit MetricParameters(const MetricShader& shader)
  {
    static_assert(sizeof(shader.Parameters) == sizeof(this->metricParameters), "ten vectors");
    std::memcpy(this->metricParameters, shader.Parameters.data(), sizeof(this->metricParameters));
  }
};

template <typename Functions>
class FunctionEvaluator : public MetricEvaluator
{
public:
  bool ComputeEdgeTags(const RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    if (!this->Describe(view, maximumLevel))
    {
      return false;
    }
    this->MeasureEdges(*this->GetMesh().GetEdges(), tags);
    this->TurnIntoTags(tags);
    return true;
  }

protected:
  using MetricEvaluator::MetricEvaluator;

  /// Implements ComputeTags() of a metric that tags points.
  bool TagPoints(const RefinementView& view, int maximumLevel, vtkFloatArray* tags)
  {
    if (!this->Describe(view, maximumLevel))
    {
      return false;
    }
    tags->SetNumberOfComponents(1);
    tags->SetNumberOfTuples(this->GetPoints().GetNumberOfPoints());
    float* values = tags->GetPointer(0);
    this->ForEachPoint([values](Functions& functions, vtkIdType point, const vec4& value)
      { values[point] = functions.metricTag(functions.metricPointMeasure(value)); });
    tags->Modified();
    return true;
  }

  /// Implements ComputeTags() of a metric that tags only edges: the largest tag at a point.
  bool TagPointsByEdges(const RefinementView& view, int maximumLevel, vtkFloatArray* tags)
  {
    if (!this->Describe(view, maximumLevel))
    {
      return false;
    }
    const SurfaceEdges& edges = *this->GetMesh().GetEdges();
    this->MeasureEdges(edges, this->EdgeMeasures);
    edges.TagPoints(this->EdgeMeasures->GetPointer(0), tags);
    this->TurnIntoTags(tags);
    return true;
  }

private:
  const LocalPoints& GetPoints() const { return GetShape(this->GetMesh()).GetPoints(); }

  bool Describe(const RefinementView& view, int maximumLevel)
  {
    return this->GetShader(view, maximumLevel, this->GetPoints().Origin, this->Shader);
  }

  void MeasureEdges(const SurfaceEdges& edges, vtkFloatArray* measures)
  {
    this->Values.resize(static_cast<std::size_t>(this->GetPoints().GetNumberOfPoints()));
    vec4* values = this->Values.data();
    this->ForEachPoint(
      [values](Functions&, vtkIdType point, const vec4& value) { values[point] = value; });
    if (this->Shader.Data)
    {
      for (vtkIdType point : edges.GetTriangles().GetCoincidentPoints())
      {
        vec4& value = values[edges.GetTriangles().GetMergedPoint(point)];
        value = max(value, values[point]);
      }
    }
    const SurfaceEdges::Edge* ends = edges.GetEdges().data();
    relevo::TagEdges(edges, measures,
      [=, functions = Functions(this->Shader)](int edge) mutable
      {
        return functions.metricEdgeMeasure(
          values[ends[edge].MergedPoints[0]], values[ends[edge].MergedPoints[1]]);
      });
  }

  // A separate step, so that several measures are converted at once.
  void TurnIntoTags(vtkFloatArray* measures) const
  {
    float* values = measures->GetPointer(0);
    vtkSMPTools::For(0, measures->GetNumberOfValues(),
      [&, values](vtkIdType begin, vtkIdType end)
      {
        Functions functions(this->Shader);
        for (vtkIdType i = begin; i < end; ++i)
        {
          values[i] = functions.metricTag(values[i]);
        }
      });
  }

  // Calls f(functions, point, its value) in parallel.
  template <typename Function>
  void ForEachPoint(Function&& f) const
  {
    const LocalPoints& points = this->GetPoints();
    const float* x = points.Coordinates.data();
    const float* data = this->Shader.Data ? this->Shader.Data->data() : nullptr;
    vtkSMPTools::For(0, points.GetNumberOfPoints(),
      [&, x, data](vtkIdType begin, vtkIdType end)
      {
        // A local copy cannot alias the output, so the compiler can keep it in registers.
        Functions functions(this->Shader);
        for (vtkIdType point = begin; point < end; ++point)
        {
          const float* p = x + 3 * point;
          const vec4 datum = data
            ? vec4(data[4 * point], data[4 * point + 1], data[4 * point + 2], data[4 * point + 3])
            : vec4(0.0f);
          f(functions, point, functions.metricValue(vec3(p[0], p[1], p[2]), datum));
        }
      });
  }

  MetricShader Shader;      // of the last view
  std::vector<vec4> Values; // of points
  vtkNew<vtkFloatArray> EdgeMeasures;
};
}

#endif
