// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/SegmentCaster.h"

#include "Passes/ScreenPass.h"
#include "Segments/RaySegments.h"
#include "Shaders/VolumePrograms.h"
#include "Stages/FeatureSelector.h"
#include "Stages/RayCaster.h"
#include "Stages/VolumeFrame.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPixelBufferObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace relevo
{
namespace
{
// Enough for the first frame of most meshes.
constexpr size_t SegmentsPerPixel = 2;
// Words of a record before its values.
constexpr size_t PlaceWords = 3;
// The output of a pass: a flag, begin, end and the values.
constexpr int NumberOfTextures = 3;
static_assert(4 * NumberOfTextures >= 3 + SegmentFormat::MaximumValues, "values do not fit");

std::vector<float> ReadTexture(vtkTextureObject* texture)
{
  vtkSmartPointer<vtkPixelBufferObject> pixels;
  pixels.TakeReference(texture->Download());
  unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
  vtkIdType increments[2] = { 0, 0 };
  std::vector<float> values(4 * static_cast<size_t>(size[0]) * size[1]);
  pixels->Download2D(VTK_FLOAT, values.data(), size, 4, increments);
  return values;
}

std::uint32_t GetBits(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}
}

// Cast all rays once. Return false if the buffer or the target cannot be allocated.
bool SegmentCaster::Fill(
  const VolumeFrame& frame, vtkShaderProgram* program, size_t words, size_t& found)
{
  if (!this->Records.Begin(words * this->Capacity))
  {
    return false;
  }
  const bool isBound =
    this->Target.Begin(frame.Window, frame.Viewport[2], frame.Viewport[3], { { 1 } });
  if (isBound)
  {
    program->SetUniformi("maximumRecords", static_cast<int>(this->Capacity));
    this->Target.Draw(BlendOperation::Add, &ScreenPass::DrawTriangle);
    this->Target.End();
  }
  found = this->Records.End();
  return isBound;
}

// Repeat with a larger buffer if there are more segments than in the frames before.
bool SegmentCaster::CastToBuffer(
  const VolumeFrame& frame, vtkShaderProgram* program, size_t words, Words& records)
{
  const size_t pixels = static_cast<size_t>(frame.Viewport[2]) * frame.Viewport[3];
  this->Capacity = std::max(this->Capacity, SegmentsPerPixel * pixels);
  size_t found = 0;
  bool isDone = this->Fill(frame, program, words, found);
  if (isDone && found > this->Capacity)
  {
    this->Capacity = found + found / 4;
    isDone = this->Fill(frame, program, words, found);
  }
  this->IsTooLarge = !isDone;
  if (isDone)
  {
    records = this->Records.Read(words * std::min(found, this->Capacity));
    // A buffer that is much too large is replaced in the next frame.
    this->Capacity = found < this->Capacity / 4 ? 0 : this->Capacity;
  }
  return isDone;
}

bool SegmentCaster::CastInPasses(
  const VolumeFrame& frame, vtkShaderProgram* program, int passes, size_t words, Words& records)
{
  const std::vector<RenderTarget::Format> formats(NumberOfTextures);
  if (!this->Target.Begin(frame.Window, frame.Viewport[2], frame.Viewport[3], formats))
  {
    return false;
  }
  size_t before = 0;
  for (int pass = 0; pass < passes && (pass == 0 || records.size() > before); ++pass)
  {
    before = records.size();
    program->SetUniformi("lastSegment", pass);
    this->Target.Draw(BlendOperation::Add, &ScreenPass::DrawTriangle);
    this->ReadPass(words, records);
  }
  this->Target.End();
  return true;
}

// Append the segments of a pass.
void SegmentCaster::ReadPass(size_t words, Words& records) const
{
  std::array<std::vector<float>, NumberOfTextures> textures;
  for (size_t i = 0; i < textures.size(); ++i)
  {
    textures[i] = ReadTexture(this->Target.GetTexture(i));
  }
  for (size_t pixel = 0; pixel < textures[0].size() / 4; ++pixel)
  {
    if (textures[0][4 * pixel] == 0.0f)
    {
      continue;
    }
    records.push_back(static_cast<std::uint32_t>(pixel));
    for (size_t i = 1; i < words; ++i)
    {
      records.push_back(GetBits(textures[i / 4][4 * pixel + i % 4]));
    }
  }
}

std::string SegmentCaster::Cast(
  const VolumeFrame& frame, RayCaster& rays, int most, RaySegments& segments, bool& isDone)
{
  vtkShaderProgram* program = rays.Begin(frame, { { 0, 0, frame.Viewport[2], frame.Viewport[3] } });
  isDone = false;
  if (!program)
  {
    return VolumePrograms::Error;
  }
  const size_t words = static_cast<size_t>(segments.Format.GetNumberOfValues()) + PlaceWords;
  Words records;
  // One segment more than are kept shows whether there are more.
  program->SetUniformi("lastSegment", most);
  const bool isBuffer = frame.Features.Options.Segments == SegmentOutput::Buffer;
  isDone = isBuffer ? this->CastToBuffer(frame, program, words, records)
                    : this->CastInPasses(frame, program, most + 1, words, records);
  rays.End(frame);
  segments.Sort(records, most);
  return isDone || isBuffer ? "" : "There is not enough graphics memory for the segments of rays.";
}

void SegmentCaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Records.ReleaseGraphicsResources();
  this->Target.ReleaseGraphicsResources(window);
  this->Capacity = 0;
  this->IsTooLarge = false;
}
}
