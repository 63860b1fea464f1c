// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Compute/RefinementComputeTags.h"

#include "Mesh/RefinementMesh.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricShader.h"

#include "relevoMeasureEdgesCS.h"
#include "relevoMeasurePointsCS.h"
#include "relevoTagMergedPointsCS.h"
#include "relevoTagsCS.h"
#include "relevoValuesCS.h"

#include <vector>

namespace relevo
{
bool RefinementComputeTags::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

bool RefinementComputeTags::UploadMesh(const RefinementMesh& mesh)
{
  this->NumberOfPoints = static_cast<int>(mesh.Points.size() / 3);
  this->NumberOfEdges = -1;
  this->HasMergedPoints = !mesh.MergedPoints.empty();
  const std::vector<int> places(mesh.MergedPoints.begin(), mesh.MergedPoints.end());
  return (this->Points.Upload(mesh.Points) && this->MergedPoints.Upload(places)) ||
    this->Fail(RefinementComputeBuffer::GetTooLarge());
}

bool RefinementComputeTags::UploadEdges(const SurfaceEdges& edges)
{
  if (this->NumberOfEdges >= 0)
  {
    return true;
  }
  if (!this->Edges.Upload(edges.GetEdges()))
  {
    return this->Fail(RefinementComputeBuffer::GetTooLarge());
  }
  this->NumberOfEdges = edges.GetNumberOfEdges();
  return true;
}

bool RefinementComputeTags::UploadData(const MetricShader& shader)
{
  if (!shader.Data)
  {
    return true;
  }
  const size_t expected = 4 * static_cast<size_t>(this->NumberOfPoints);
  if (shader.Data->size() != expected)
  {
    return this->Fail("the metric's shader has data of " + std::to_string(shader.Data->size()) +
      " floats, but " + std::to_string(expected) + " are needed, four for each point");
  }
  if (this->UploadedData == shader.Data)
  {
    return true;
  }
  if (!this->Data.Upload(*shader.Data))
  {
    return this->Fail(RefinementComputeBuffer::GetTooLarge());
  }
  this->UploadedData = shader.Data;
  return true;
}

bool RefinementComputeTags::Build(
  RefinementComputeProgram& program, const MetricShader& shader, const char* stage)
{
  return program.Build(std::string(relevoTagsCS) + shader.Source + stage) ||
    this->Fail(program.GetError());
}

bool RefinementComputeTags::Evaluate(const MetricShader& shader, bool perEdge)
{
  if (!this->UploadData(shader))
  {
    return false;
  }
  if (shader.TagsPoints && !perEdge)
  {
    return this->MeasurePoints(shader) && (!this->HasMergedPoints || this->TagMergedPoints(shader));
  }
  return this->MeasureEdges(shader, perEdge) && (perEdge || this->TagMergedPoints(shader));
}

void RefinementComputeTags::UseForPoints(
  RefinementComputeProgram& program, const MetricShader& shader, bool united, unsigned int target)
{
  program.Use(
    { this->Points.GetHandle(), this->Data.GetHandle(), this->MergedPoints.GetHandle(), target });
  program.SetUniform("metricParameters", shader.Parameters.data(), 4, 10);
  program.SetUniform("relevoHasData", shader.Data ? 1 : 0);
  program.SetUniform("relevoHasMergedPoints", united ? 1 : 0);
}

bool RefinementComputeTags::MeasurePoints(const MetricShader& shader)
{
  RefinementComputeBuffer& target = this->HasMergedPoints ? this->Measures : this->Tags;
  if (!this->Build(this->PointProgram, shader, relevoMeasurePointsCS))
  {
    return false;
  }
  if (!target.Resize(sizeof(float) * static_cast<size_t>(this->NumberOfPoints)))
  {
    return this->Fail(RefinementComputeBuffer::GetTooLarge());
  }
  if (this->HasMergedPoints)
  {
    target.Clear();
  }
  this->UseForPoints(this->PointProgram, shader, this->HasMergedPoints, target.GetHandle());
  this->PointProgram.Dispatch(this->NumberOfPoints);
  return true;
}

bool RefinementComputeTags::MeasureEdges(const MetricShader& shader, bool perEdge)
{
  // Without separate data, merged points have one value.
  const bool united = this->HasMergedPoints && shader.Data;
  RefinementComputeBuffer& target = perEdge ? this->Tags : this->Measures;
  if (!this->Build(this->ValueProgram, shader, relevoValuesCS) ||
    !this->Build(this->EdgeProgram, shader, relevoMeasureEdgesCS))
  {
    return false;
  }
  if (!this->Values.Resize(4 * sizeof(float) * static_cast<size_t>(this->NumberOfPoints)) ||
    !target.Resize(
      sizeof(float) * static_cast<size_t>(perEdge ? this->NumberOfEdges : this->NumberOfPoints)))
  {
    return this->Fail(RefinementComputeBuffer::GetTooLarge());
  }
  if (united)
  {
    this->Values.Clear();
  }
  if (!perEdge)
  {
    target.Clear();
  }
  this->UseForPoints(this->ValueProgram, shader, united, this->Values.GetHandle());
  this->ValueProgram.Dispatch(this->NumberOfPoints);

  this->EdgeProgram.Use({ this->Edges.GetHandle(), this->Values.GetHandle(), target.GetHandle() });
  this->EdgeProgram.SetUniform("metricParameters", shader.Parameters.data(), 4, 10);
  this->EdgeProgram.SetUniform("relevoPerEdge", perEdge ? 1 : 0);
  this->EdgeProgram.Dispatch(this->NumberOfEdges);
  return true;
}

bool RefinementComputeTags::TagMergedPoints(const MetricShader& shader)
{
  if (!this->Build(this->PlaceProgram, shader, relevoTagMergedPointsCS))
  {
    return false;
  }
  if (!this->Tags.Resize(sizeof(float) * static_cast<size_t>(this->NumberOfPoints)))
  {
    return this->Fail(RefinementComputeBuffer::GetTooLarge());
  }
  this->PlaceProgram.Use(
    { this->Measures.GetHandle(), this->MergedPoints.GetHandle(), this->Tags.GetHandle() });
  this->PlaceProgram.SetUniform("metricParameters", shader.Parameters.data(), 4, 10);
  this->PlaceProgram.SetUniform("relevoHasMergedPoints", this->HasMergedPoints ? 1 : 0);
  this->PlaceProgram.Dispatch(this->NumberOfPoints);
  return true;
}

vtkTypeInt64 RefinementComputeTags::GetMemorySize() const
{
  vtkTypeInt64 size = 0;
  for (const RefinementComputeBuffer* buffer : { &this->Points, &this->MergedPoints, &this->Edges,
         &this->Data, &this->Values, &this->Measures, &this->Tags })
  {
    size += buffer->GetMemorySize();
  }
  return size;
}

void RefinementComputeTags::ReleaseGraphicsResources()
{
  for (RefinementComputeProgram* program :
    { &this->PointProgram, &this->ValueProgram, &this->EdgeProgram, &this->PlaceProgram })
  {
    program->ReleaseGraphicsResources();
  }
  for (RefinementComputeBuffer* buffer : { &this->Points, &this->MergedPoints, &this->Edges,
         &this->Data, &this->Values, &this->Measures, &this->Tags })
  {
    buffer->ReleaseGraphicsResources();
  }
  this->NumberOfEdges = -1;
  this->UploadedData.reset();
}
}
