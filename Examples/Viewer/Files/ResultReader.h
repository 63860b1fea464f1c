// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ResultReader
 * @brief   reads the time steps of a file
 */
#ifndef ResultReader_h
#define ResultReader_h

#include "vtkSmartPointer.h"

#include <optional>
#include <vector>

class vtkDataObject;

class ResultReader
{
public:
  virtual ~ResultReader() = default;

  /// The times of the steps, in increasing order. Empty if the file has no times.
  virtual std::vector<double> GetTimes() { return {}; }

  /// Reads the step of one of the times, or the only one of a file without times. Returns nullptr
  /// if the file has no data.
  virtual vtkSmartPointer<vtkDataObject> Read(const std::optional<double>& time) = 0;
};

#endif
