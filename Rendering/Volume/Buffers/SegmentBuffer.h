// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SegmentBuffer
 * @brief   the buffer to which relevoVolumeSegments.glsl appends records of segments
 *
 * Needs a current context with OpenGL 4.3. Private to the module.
 */
#ifndef SegmentBuffer_h
#define SegmentBuffer_h

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relevo
{
class SegmentBuffer
{
public:
  SegmentBuffer() = default;
  SegmentBuffer(const SegmentBuffer&) = delete;
  void operator=(const SegmentBuffer&) = delete;

  /// Return whether shaders of the current context can write to buffers.
  static bool IsSupported();

  /// Allocate this number of words after the number of records, and bind the buffer. Return false
  /// if shaders of this context cannot access that many words.
  bool Begin(size_t words);
  /// Wait for the GPU and return the number of records.
  size_t End();
  /// Return the words after the number of records.
  std::vector<std::uint32_t> Read(size_t words) const;

  vtkTypeInt64 GetMemorySize() const { return this->Size; }
  void ReleaseGraphicsResources();

private:
  unsigned int Handle = 0;
  vtkTypeInt64 Size = 0; // bytes
};
}

#endif
