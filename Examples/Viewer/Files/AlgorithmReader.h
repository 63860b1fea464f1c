// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   AlgorithmReader
 * @brief   reads time steps with a reader of VTK
 */
#ifndef AlgorithmReader_h
#define AlgorithmReader_h

#include "Files/ResultReader.h"

class ViewerMessages;
class vtkAlgorithm;

class AlgorithmReader : public ResultReader
{
public:
  /// Takes a reader that has the name of its file. Its errors and progress are those of messages.
  AlgorithmReader(vtkAlgorithm* reader, ViewerMessages& messages);
  ~AlgorithmReader() override;

  std::vector<double> GetTimes() override;
  vtkSmartPointer<vtkDataObject> Read(const std::optional<double>& time) override;

private:
  vtkSmartPointer<vtkAlgorithm> Reader;
  ViewerMessages& Messages;
};

#endif
