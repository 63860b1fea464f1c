// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeTags
 * @brief   the tags of a metric, evaluated in compute shaders
 *
 * The stage "tag" of a frame on the GPU, for metrics that are functions of a shader (MetricShader),
 * by either rule. The same functions in the same order as on the CPU: tags differ at most where the
 * driver's quotients and square roots are not rounded as IEEE 754 demands.
 *
 * Needs a current context with OpenGL 4.3; Evaluate() is called between
 * RefinementComputeProgram::Begin() and End(). Private to the module.
 */
#ifndef RefinementComputeTags_h
#define RefinementComputeTags_h

#include "Compute/RefinementComputeBuffer.h"  // for members
#include "Compute/RefinementComputeProgram.h" // for members
#include "vtkType.h"                          // for vtkTypeInt64

#include <memory> // for members
#include <string> // for errors
#include <vector> // for members

namespace relevo
{
class RefinementMesh;
class SurfaceEdges;
struct MetricShader;

class RefinementComputeTags
{
public:
  RefinementComputeTags() = default;
  RefinementComputeTags(const RefinementComputeTags&) = delete;
  void operator=(const RefinementComputeTags&) = delete;

  /// Take a mesh, which has changed; then edges are to be taken again.
  bool UploadMesh(const RefinementMesh& mesh);

  /// Take the mesh's edges, if they are not there yet.
  bool UploadEdges(const SurfaceEdges& edges);

  /**
   * Tag every edge, or else every point, points at one place alike. Edges are needed for the former
   * and for metrics that do not tag points. False, with GetError(), when a shader does not compile
   * or the GPU cannot hold the tags.
   */
  bool Evaluate(const MetricShader& shader, bool perEdge);

  /// Buffer of the tags.
  unsigned int GetTags() const { return this->Tags.GetHandle(); }

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();
  const std::string& GetError() const { return this->Error; }

private:
  bool Build(RefinementComputeProgram& program, const MetricShader& shader, const char* stage);
  bool UploadData(const MetricShader& shader);
  bool MeasurePoints(const MetricShader& shader);
  bool MeasureEdges(const MetricShader& shader, bool perEdge);
  bool TagMergedPoints(const MetricShader& shader);
  void UseForPoints(RefinementComputeProgram& program, const MetricShader& shader, bool united,
    unsigned int target);
  bool Fail(const std::string& error);

  int NumberOfPoints = 0;
  int NumberOfEdges = -1; // not taken yet
  bool HasMergedPoints = false;
  std::shared_ptr<const std::vector<float>> UploadedData; // kept, so that no other has its address
  RefinementComputeProgram PointProgram;
  RefinementComputeProgram ValueProgram;
  RefinementComputeProgram EdgeProgram;
  RefinementComputeProgram PlaceProgram;
  RefinementComputeBuffer Points;
  RefinementComputeBuffer MergedPoints;
  RefinementComputeBuffer Edges;
  RefinementComputeBuffer Data;
  RefinementComputeBuffer Values;
  RefinementComputeBuffer Measures;
  RefinementComputeBuffer Tags;
  std::string Error;
};
}

#endif
