// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeBuffer
 * @brief   an array on the GPU that compute shaders read and write
 *
 * Needs a current context with OpenGL 4.3. Private to the module and
 * its tests.
 */
#ifndef RefinementComputeBuffer_h
#define RefinementComputeBuffer_h

#include "RelevoRenderingRefinementModule.h" // for export macro
#include "vtkType.h"                         // for vtkTypeInt64

#include <cstddef> // for std::size_t
#include <string>  // for errors
#include <vector>  // for data

namespace relevo
{
class RELEVORENDERINGREFINEMENT_EXPORT RefinementComputeBuffer
{
public:
  RefinementComputeBuffer() = default;
  RefinementComputeBuffer(const RefinementComputeBuffer&) = delete;
  void operator=(const RefinementComputeBuffer&) = delete;

  //@{
  /**
   * Allocate this number of bytes, at least for one value, with undefined content; or store values.
   * Return false if shaders of this context cannot access that many bytes.
   */
  bool Resize(std::size_t bytes);
  template <typename T>
  bool Upload(const std::vector<T>& values)
  {
    return this->Upload(values.data(), values.size() * sizeof(T));
  }
  bool Upload(const void* values, std::size_t bytes);
  //@}

  /// Set all bytes to zero.
  void Clear();

  //@{
  /**
   * Wait for the GPU and copy `number` values from index `first` on.
   */
  template <typename T>
  std::vector<T> Read(std::size_t number, std::size_t first = 0) const
  {
    std::vector<T> values(number);
    ReadBuffer(this->Handle, first * sizeof(T), values.data(), number * sizeof(T));
    return values;
  }
  static void ReadBuffer(unsigned int handle, std::size_t offset, void* values, std::size_t bytes);
  //@}

  /// Return the message for data that do not fit, with the limit of the current context.
  static std::string GetTooLarge(const std::string& what = "the mesh");

  /// Return OpenGL's name of the buffer; 0 for none.
  unsigned int GetHandle() const { return this->Handle; }
  vtkTypeInt64 GetMemorySize() const { return this->Size; }
  void ReleaseGraphicsResources();

private:
  unsigned int Handle = 0;
  vtkTypeInt64 Size = 0; // bytes
};
}

#endif
