// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VertexAttribute
 * @brief   an attribute of the vertex array in use, for as long as the object lives
 *
 * VTK's vertex array does not support integers, and leaves attributes enabled for programs that
 * have others in their places. Private to the module.
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
  /// The types of its components; both have four bytes.
  enum Types
  {
    FLOAT,
    UNSIGNED_INT
  };

  /**
   * Where in the buffer the attribute is: from `offset` on, every `stride` bytes (0: without gaps),
   * and whether it is one per instance.
   */
  struct Layout
  {
    Types Type = FLOAT;
    int Components = 4;
    int Stride = 0;
    size_t Offset = 0;
    bool IsPerInstance = false;
  };

  /// Feed it from the buffer of this name. Nothing happens if the program has no such attribute.
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
