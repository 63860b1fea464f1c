// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CaptureRanks
 * @brief   the processes that capture one scene together, each with a part of it
 *
 * Rank 0 has the reliefs. All methods are collective: all ranks call them in the same order. With
 * one process, they return their argument. Private to the module.
 */
#ifndef CaptureRanks_h
#define CaptureRanks_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkMultiProcessController;

namespace relevo
{
struct CapturedPixels;

class CaptureRanks
{
public:
  void SetController(vtkMultiProcessController* controller) { this->Controller = controller; }
  vtkMultiProcessController* GetController() const { return this->Controller; }

  /// Return whether a value is true on any rank.
  bool IsAny(bool value) const;
  /// Return the numbers of rank 0.
  std::vector<double> GetFirst(std::vector<double> numbers) const;
  /// Return the points of all ranks.
  std::vector<dvec3> Collect(const std::vector<dvec3>& points) const;
  /// Keep the nearest pixels of all ranks on rank 0. They have the same size and camera. Normals
  /// are ignored.
  void Composite(CapturedPixels& pixels) const;

private:
  bool AreSeveral() const;

  vtkSmartPointer<vtkMultiProcessController> Controller;
};
}

#endif
