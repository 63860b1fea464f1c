// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SegmentCaster
 * @brief   the stage that casts rays and reads back their segments
 *
 * With OpenGL 4.3, all rays append their segments to one buffer, which grows to the number of
 * segments. Otherwise, and if the buffer would be too large, each pass outputs the next segment of
 * all pixels. Private to the module.
 */
#ifndef SegmentCaster_h
#define SegmentCaster_h

#include "Buffers/SegmentBuffer.h"
#include "Targets/RenderTarget.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class RayCaster;
class RaySegments;
struct VolumeFrame;

class SegmentCaster
{
public:
  /// Return whether the current context supports storage buffers.
  static bool HasStorageBuffers() { return SegmentBuffer::IsSupported(); }

  /// Cast the rays of the frame's viewport, and keep the `most` nearest segments of each. The
  /// frame's options decide whether a buffer is used. Return the error, or "". If the buffer is too
  /// large, there is no error, and it is not done.
  std::string Cast(
    const VolumeFrame& frame, RayCaster& rays, int most, RaySegments& segments, bool& isDone);

  /// Return whether the last buffer was too large for this OpenGL. Then use passes.
  bool IsBufferTooLarge() const { return this->IsTooLarge; }

  vtkTypeInt64 GetMemorySize() const { return this->Records.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  using Words = std::vector<std::uint32_t>;
  bool Fill(const VolumeFrame& frame, vtkShaderProgram* program, size_t words, size_t& found);
  bool CastToBuffer(
    const VolumeFrame& frame, vtkShaderProgram* program, size_t words, Words& records);
  bool CastInPasses(
    const VolumeFrame& frame, vtkShaderProgram* program, int passes, size_t words, Words& records);
  void ReadPass(size_t words, Words& records) const;

  SegmentBuffer Records;
  size_t Capacity = 0; // in records
  bool IsTooLarge = false;
  RenderTarget Target;
};
}

#endif
