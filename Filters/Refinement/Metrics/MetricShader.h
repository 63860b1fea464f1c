// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::MetricShader
 * @brief   a view-dependent metric as functions for a shader or C++
 *
 * A compute shader (GLSL 4.30) includes Source after
 *
 *     #define RELEVO_FUNCTION
 *     uniform vec4 metricParameters[10];
 *
 * Source defines these functions:
 *
 * - vec4 metricValue(vec3 x, vec4 datum): the value of a point. x is relative to the origin given
 *   to vtkDepthTagMetric::GetShader(). datum is the point's four floats in Data, or 0 without Data.
 * - float metricPointMeasure(vec4 value): the measure of a point, only if TagsPoints.
 * - float metricEdgeMeasure(vec4 a, vec4 b): the measure of an edge between merged points with the
 *   values a and b, the lower id first.
 * - float metricTag(float measure): the level, in [0, maximum level].
 *
 * Measures are not negative, so that their bits, read as unsigned integers, have the same order.
 * Levels increase with measures.
 *
 * With PER_VERTEX, the tag of a point is computed from its own measure if TagsPoints, otherwise
 * from the largest measure of the edges at its merged point.
 *
 * With PER_EDGE, the tag of an edge is computed from its measure. With Data, coincident points can
 * have different values. Their components must not be negative then, and the largest of each is
 * used.
 *
 * The functions return the same bits on all processors that round sums, products, quotients and
 * square roots according to IEEE 754. OpenGL does not specify the last bits of quotients and roots.
 */
#ifndef MetricShader_h
#define MetricShader_h

#include <array>  // for Parameters
#include <memory> // for Data
#include <string> // for Source
#include <vector> // for Data

namespace relevo
{
struct MetricShader
{
  /// Source of the functions. If it is empty, use ComputeTags() or ComputeEdgeTags().
  std::string Source;
  /// Whether metricPointMeasure() gives tags to points.
  bool TagsPoints = true;
  /// The parameters of this frame: 10 vectors with 4 components.
  std::array<float, 40> Parameters{};
  /// Four floats per point of the mesh, or nullptr. To change them, set a new vector: a new pointer
  /// marks a change.
  std::shared_ptr<const std::vector<float>> Data;
};
}

#endif
