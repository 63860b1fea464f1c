// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   ways to draw reliefs: the methods and searches of vtkReliefMapper
 */
#ifndef BenchmarkReliefWay_h
#define BenchmarkReliefWay_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkDataObject;

enum class ReliefWay
{
  Automatic,
  MaximumMipmap,
  LinearBinary,
  LinearSecant,
  RelaxedCones,
  Refinement,
  Warp
};

const std::vector<ReliefWay>& GetReliefWays();

const char* GetName(ReliefWay way);

vtkSmartPointer<vtkActor> MakeReliefActor(ReliefWay way, vtkDataObject* reliefs);

#endif
