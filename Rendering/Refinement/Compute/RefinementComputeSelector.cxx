// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Compute/RefinementComputeSelector.h"

#include "Compute/RefinementComputeView.h"

#include "relevoCountCS.h"
#include "relevoCulling.h"
#include "relevoGroupCS.h"
#include "relevoLevels.h"
#include "relevoScanCS.h"
#include "relevoScatterCS.h"
#include "relevoSelectCS.h"

namespace relevo
{
bool RefinementComputeSelector::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

bool RefinementComputeSelector::BuildPrograms()
{
  const std::string group = relevoGroupCS;
  const std::string morph = this->Morphing ? "#define RELEVO_MORPHING\n" : "";
  const struct
  {
    RefinementComputeProgram& Program;
    std::string Source;
  } stages[] = { { this->SelectProgram, relevoLevels + morph + relevoSelectCS },
    { this->CountProgram, group + relevoCulling + relevoCountCS },
    { this->ScanProgram, group + relevoScanCS },
    { this->ScatterProgram, group + relevoScatterCS } };
  for (const auto& stage : stages)
  {
    if (!stage.Program.Build(stage.Source))
    {
      return this->Fail(stage.Program.GetError());
    }
  }
  return true;
}

bool RefinementComputeSelector::UploadOrders(const std::vector<unsigned char>& orders)
{
  this->NumberOfFaces = static_cast<int>(orders.size());
  std::vector<unsigned char> padded = orders; // padded to whole integers
  padded.resize((orders.size() + 3) / 4 * 4, 0);
  return this->Orders.Upload(padded) || this->Fail(RefinementComputeBuffer::GetTooLarge());
}

bool RefinementComputeSelector::UploadCulling(const std::vector<float>& data)
{
  return this->Culling.Upload(data) || this->Fail(RefinementComputeBuffer::GetTooLarge());
}

bool RefinementComputeSelector::UploadPatterns(const std::vector<Pattern>& patterns,
  const std::vector<unsigned int>& table, int maximumLevel, bool morphing)
{
  this->NumberOfKeys = static_cast<int>(patterns.size());
  this->MaximumLevel = maximumLevel;
  this->Morphing = morphing;
  return ((this->Patterns.Upload(patterns) && this->Table.Upload(table)) ||
           this->Fail(RefinementComputeBuffer::GetTooLarge("the patterns"))) &&
    this->BuildPrograms();
}

bool RefinementComputeSelector::Select(
  RefinementComputeView& view, const Tags& tags, unsigned int morphTags)
{
  if (!view.Resize(this->NumberOfFaces, this->NumberOfKeys))
  {
    return this->Fail(RefinementComputeBuffer::GetTooLarge());
  }
  RefinementComputeProgram& program = this->SelectProgram;
  program.Use({ tags.Elements, this->Orders.GetHandle(), tags.Values, this->Table.GetHandle(),
    view.Entries.GetHandle(), morphTags });
  program.SetUniform("relevoTagKind", static_cast<int>(tags.Kind));
  program.SetUniform("relevoElementStride", tags.Stride);
  program.SetUniform("relevoTagOffset", tags.Offset);
  program.SetUniform("relevoMaximumLevel", this->MaximumLevel);
  program.Dispatch(this->NumberOfFaces);
  return true;
}

void RefinementComputeSelector::Count(RefinementComputeView& view, const Camera* camera)
{
  view.Counts.Clear();
  RefinementComputeProgram& program = this->CountProgram;
  program.Use({ view.Entries.GetHandle(), view.Counts.GetHandle(), view.Ranks.GetHandle(),
    this->Culling.GetHandle() });
  program.SetUniform("relevoCulled", camera ? 1 : 0);
  if (camera)
  {
    program.SetUniform("relevoPlanes", camera->Planes[0], 4, Camera::NumberOfPlanes);
    program.SetUniform("relevoEye", camera->Eye, 3);
    program.SetUniform("relevoParallel", camera->Parallel ? 1 : 0);
    program.SetUniform("relevoHidesBackFaces", camera->HidesBackFaces ? 1 : 0);
  }
  program.Dispatch(this->NumberOfFaces);
}

void RefinementComputeSelector::Group(
  RefinementComputeView& view, const Camera* camera, unsigned int instances)
{
  this->Count(view, camera);

  this->ScanProgram.Use({ view.Counts.GetHandle(), this->Patterns.GetHandle(),
    view.Groups.GetHandle(), view.Triangles.GetHandle(), view.Others.GetHandle() });
  this->ScanProgram.SetUniform("relevoNumberOfKeys", this->NumberOfKeys);
  this->ScanProgram.DispatchGroup();

  this->ScatterProgram.Use({ view.Entries.GetHandle(), view.Ranks.GetHandle(),
    view.Groups.GetHandle(), instances, view.Members.GetHandle() });
  this->ScatterProgram.Dispatch(this->NumberOfFaces);
}

vtkTypeInt64 RefinementComputeSelector::GetMemorySize() const
{
  return this->Orders.GetMemorySize() + this->Culling.GetMemorySize() +
    this->Table.GetMemorySize() + this->Patterns.GetMemorySize();
}

void RefinementComputeSelector::ReleaseGraphicsResources()
{
  for (RefinementComputeProgram* program :
    { &this->SelectProgram, &this->CountProgram, &this->ScanProgram, &this->ScatterProgram })
  {
    program->ReleaseGraphicsResources();
  }
  for (RefinementComputeBuffer* buffer :
    { &this->Orders, &this->Culling, &this->Table, &this->Patterns })
  {
    buffer->ReleaseGraphicsResources();
  }
}
}
