// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a vtkReliefMapper keeps
 *
 * Private to the mapper's own sources.
 */
#ifndef vtkReliefMapperInternals_h
#define vtkReliefMapperInternals_h

#include "Changes/Dependencies.h"
#include "Data/Reliefs.h"
#include "Drawing/ReliefPainter.h"
#include "OpenGL/ContextWatch.h"
#include "Picking/PickerDetector.h"
#include "vtkCompositeDataSet.h"
#include "vtkReliefMapper.h"
#include "vtkStructuredGrid.h"

#include <map>
#include <string>
#include <vector>

struct vtkReliefMapper::vtkInternals
{
  struct Block
  {
    relevo::ReliefBlock Relief;
    vtkSmartPointer<relevo::ReliefPainter> Painter;
    vtkSmartPointer<relevo::ReliefPainter> Rims; // nullptr for none
    relevo::Dependencies Source;
    std::string Problem; // said last, as the next
    std::string ShaderProblem;
    vtkSmartPointer<vtkStructuredGrid> Picked; // of the surface, when a picker has asked
  };
  std::map<unsigned int, Block> Blocks; // by flat index
  relevo::Dependencies Source;
  relevo::Dependencies RimSource;
  vtkNew<relevo::ContextWatch> Context;
  int MethodInUse = METHOD_RAY_MARCH;

  relevo::PickerDetector Questions;
  vtkSmartPointer<vtkCompositeDataSet> PickedBlocks;
  vtkNew<vtkStructuredGrid> Nothing; // for pickers, of what is not drawn
  vtkStructuredGrid* GetPicked(unsigned int block, double maximumStretch);

  std::vector<relevo::ReliefPainter*> GetPainters() const;
  // Counts what a painter has done, and releases it.
  void Retire(relevo::ReliefPainter* painter);
  void UpdateRims(bool areWanted, double maximumStretch);

  // Of painters that are gone.
  vtkIdType NumberOfBufferBuilds = 0;
  vtkIdType NumberOfShaderBuilds = 0;
  vtkIdType NumberOfWarps = 0;
};

#endif
