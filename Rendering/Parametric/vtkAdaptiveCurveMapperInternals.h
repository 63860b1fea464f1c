// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a vtkAdaptiveCurveMapper keeps
 *
 * Private to the mapper's own sources.
 */
#ifndef vtkAdaptiveCurveMapperInternals_h
#define vtkAdaptiveCurveMapperInternals_h

#include "Drawing/CurvePainter.h"
#include "OpenGL/ContextWatch.h"
#include "vtkAdaptiveCurveMapper.h"

#include <functional>
#include <map>
#include <string>

/// A data set of the input.
struct vtkAdaptiveCurveMapper::vtkBlock
{
  /// What can be wrong with it.
  enum Kinds
  {
    CELLS,
    RADII,
    INPUT,
    COLORS,
    SHADERS,
    NUMBER_OF_KINDS
  };
  vtkSmartPointer<relevo::CurvePainter> Painter; // nullptr of what has no curves
  std::string Prefix;                            // of messages
  std::string Problems[NUMBER_OF_KINDS];         // said last
  std::string Warning;                           // likewise
  bool IsDrawn = false;                          // in the last render
};

struct vtkAdaptiveCurveMapper::vtkInternals
{
  using Number = std::function<vtkIdType(const relevo::CurvePainter&)>;

  std::map<unsigned int, vtkBlock> Blocks; // by flat index
  vtkNew<relevo::ContextWatch> Context;
  std::string Problem; // of all blocks, said last
  std::string TessellationProblem;
  int MethodInUse = METHOD_INSTANCING;

  /// Of all blocks, and of those that the last render drew.
  vtkIdType Sum(const Number& getNumber) const;
  vtkIdType SumOfFrame(const Number& getNumber) const;

  /// Of blocks that are gone.
  vtkIdType NumberOfSelections = 0;
  vtkIdType NumberOfBufferBuilds = 0;
  vtkIdType NumberOfShaderBuilds = 0;
  void AddCounts(const relevo::CurvePainter& painter);
};

#endif
