// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeTags
 * @brief   evaluates the tags of a metric in compute shaders
 *
 * This is the stage "tag" of a frame on the GPU, for metrics that are functions of a shader
 * (MetricShader), per point or per edge. The functions are the same as on the CPU and run in the
 * same order. Tags differ only if the driver does not round divisions and square roots according to
 * IEEE 754.
 *
 * Needs a current context with OpenGL 4.3. Evaluate() is called between
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

  /// Upload a mesh that has changed; its edges must be uploaded again afterwards.
  bool UploadMesh(const RefinementMesh& mesh);

  /// Upload the mesh's edges, unless that has been done.
  bool UploadEdges(const SurfaceEdges& edges);

  /**
   * Tag each edge, or each point with equal tags for merged points. Edges are needed for the former
   * and for metrics that do not tag points. Return false and set GetError() if a shader does not
   * compile or the GPU cannot hold the tags.
   */
  bool Evaluate(const MetricShader& shader, bool perEdge);

  /// Return the buffer of the tags.
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
  int NumberOfEdges = -1; // -1 before the upload
  bool HasMergedPoints = false;
  // owned so that no other data can get its address
  std::shared_ptr<const std::vector<float>> UploadedData;
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
