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
   * Take room for that many bytes, at least one value's, with undefined contents; or store values.
   * False when shaders of this context cannot access that many.
   */
  bool Resize(std::size_t bytes);
  template <typename T>
  bool Upload(const std::vector<T>& values)
  {
    return this->Upload(values.data(), values.size() * sizeof(T));
  }
  bool Upload(const void* values, std::size_t bytes);
  //@}

  /// Set all to zero.
  void Clear();

  //@{
  /**
   * Copy `number` values from the GPU, from the one with the index `first` on. Waits for it.
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

  /// What to say when something does not fit, with the limit of the current context.
  static std::string GetTooLarge(const std::string& what = "the mesh");

  /// OpenGL's name of the buffer; 0 for none.
  unsigned int GetHandle() const { return this->Handle; }
  vtkTypeInt64 GetMemorySize() const { return this->Size; }
  void ReleaseGraphicsResources();

private:
  unsigned int Handle = 0;
  vtkTypeInt64 Size = 0; // bytes
};
}

#endif
