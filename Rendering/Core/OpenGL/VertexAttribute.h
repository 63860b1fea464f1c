// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VertexAttribute
 * @brief   an attribute of the current vertex array, enabled as long as the object lives
 *
 * VTK's vertex array does not support integers, and leaves attributes enabled for programs that
 * have other attributes at the same locations. Private to the module.
 */
#ifndef VertexAttribute_h
#define VertexAttribute_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <cstddef> // for size_t

class vtkShaderProgram;

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT VertexAttribute
{
public:
  /// The types of components; both have four bytes.
  enum Types
  {
    FLOAT,
    UNSIGNED_INT
  };

  /**
   * The layout of the attribute in the buffer: it starts at `offset` and repeats every `stride`
   * bytes (0 for no gaps). It can advance once per instance.
   */
  struct Layout
  {
    Types Type = FLOAT;
    int Components = 4;
    int Stride = 0;
    size_t Offset = 0;
    bool IsPerInstance = false;
  };

  /// Feed the attribute of this name from a buffer. If the program has no such attribute, nothing
  /// happens.
  VertexAttribute(
    vtkShaderProgram* program, const char* name, unsigned int buffer, const Layout& layout);
  ~VertexAttribute();
  VertexAttribute(const VertexAttribute&) = delete;
  void operator=(const VertexAttribute&) = delete;

private:
  int Location;
};
}

#endif
