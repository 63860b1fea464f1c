// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ResultFile
 * @brief   a mesh file with its time steps, guarded against damaged content
 */
#ifndef ResultFile_h
#define ResultFile_h

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class ResultReader;
class ViewerMessages;
class vtkDataObject;

class ResultFile
{
public:
  /// Opens the file and reads its times. Throws ViewerError.
  ResultFile(const std::string& fileName, ViewerMessages& messages);
  ~ResultFile();

  const std::string& GetFileName() const { return this->FileName; }

  /// The times of the steps, in increasing order. Empty if the file has no times.
  const std::vector<double>& GetTimes() const { return this->Times; }

  /// The index of the step that is nearest to a time; of the first step without one. Throws
  /// ViewerError if a time is given and the file has none.
  int FindStep(const std::optional<double>& time) const;

  /// Reads a step, which is ignored for a file without times, and passes the data to take(), under
  /// the same guard. Throws ViewerError if the file has no data, or a cell has a missing point.
  void Read(int step, const std::function<void(vtkDataObject*)>& take);

private:
  void Guard(const std::function<void()>& work);

  std::string FileName;
  ViewerMessages& Messages;
  std::unique_ptr<ResultReader> Reader;
  std::vector<double> Times;
};

#endif
