// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::MetricShader
 * @brief   a view-dependent metric as functions that a shader, or C++, evaluates
 *
 * A compute shader (GLSL 4.30) includes Source after
 *
 *     #define RELEVO_FUNCTION
 *     uniform vec4 metricParameters[10];
 *
 * and has of it
 *
 * - vec4 metricValue(vec3 x, vec4 datum): what a point contributes; x is relative to the origin
 *   given to vtkDepthTagMetric::GetShader(), datum its four floats of Data, or 0 without;
 * - float metricPointMeasure(vec4 value): of a point, only if TagsPoints;
 * - float metricEdgeMeasure(vec4 a, vec4 b): of an edge between places of values a and b, that of
 *   the lower place first;
 * - float metricTag(float measure): the level, in [0, maximum level].
 *
 * Measures are 0 or more, so that their bits as unsigned integers have their order, and levels rise
 * with them.
 *
 * PER_VERTEX: the tag of a point is that of its own measure if TagsPoints, and else that of the
 * largest measure of the edges at its place.
 *
 * PER_EDGE: the tag of an edge is that of its measure. With Data, points that coincide have
 * different values: of each of their components, which are 0 or more then, the largest is taken.
 *
 * The functions give the same bits on all processors that round sums, products, quotients and
 * square roots as IEEE 754 demands; OpenGL leaves the last bits of quotients and roots to the
 * driver.
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
  /// Text of the functions; empty when there are none, so that tags must be computed by
  /// ComputeTags() or ComputeEdgeTags().
  std::string Source;
  /// Whether points have tags of their own.
  bool TagsPoints = true;
  /// Of this frame: 10 vectors of four.
  std::array<float, 40> Parameters{};
  /// Four floats per point of the mesh, or nullptr. They must not change: give another vector
  /// instead, which tells that they are others.
  std::shared_ptr<const std::vector<float>> Data;
};
}

#endif
