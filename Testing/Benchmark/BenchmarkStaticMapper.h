// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkStaticMapper
 * @brief   VTK's mapper with the size of its buffers in bytes
 */
#ifndef BenchmarkStaticMapper_h
#define BenchmarkStaticMapper_h

#include "vtkOpenGLPolyDataMapper.h"

class BenchmarkStaticMapper : public vtkOpenGLPolyDataMapper
{
public:
  static BenchmarkStaticMapper* New();
  vtkTypeMacro(BenchmarkStaticMapper, vtkOpenGLPolyDataMapper);

  /// Vertices with normals and colours, and indices.
  double GetGraphicsMemorySize();

protected:
  BenchmarkStaticMapper() = default;
  ~BenchmarkStaticMapper() override = default;

private:
  BenchmarkStaticMapper(const BenchmarkStaticMapper&) = delete;
  void operator=(const BenchmarkStaticMapper&) = delete;
};

#endif
