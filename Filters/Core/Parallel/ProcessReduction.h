// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ProcessReduction
 * @brief   a PieceReduction over the processes of a controller
 */
#ifndef ProcessReduction_h
#define ProcessReduction_h

#include "Parallel/PieceReduction.h"
#include "RelevoFiltersCoreModule.h" // for export macro

class vtkMultiProcessController;

namespace relevo
{
class RELEVOFILTERSCORE_EXPORT ProcessReduction : public PieceReduction
{
public:
  explicit ProcessReduction(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  bool IsWhole() const override { return false; }
  void Add(std::vector<double>& values) const override;
  void TakeLargest(std::vector<double>& values) const override;
  std::vector<double> Collect(std::vector<double> values) const override;

private:
  void Reduce(std::vector<double>& values, int operation) const;

  vtkMultiProcessController* Controller;
};
}

#endif
