// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CollectionReader
 * @brief   reads the files that a ParaView data file (.pvd) lists for its time steps
 */
#ifndef CollectionReader_h
#define CollectionReader_h

#include "Files/ResultReader.h"

#include <map>
#include <string>

class ViewerMessages;

class CollectionReader : public ResultReader
{
public:
  /// Reads the list. Throws ViewerError.
  CollectionReader(const std::string& fileName, ViewerMessages& messages);

  std::vector<double> GetTimes() override;
  /// Several files of one time are the blocks of a vtkMultiBlockDataSet.
  vtkSmartPointer<vtkDataObject> Read(const std::optional<double>& time) override;

private:
  ViewerMessages& Messages;
  std::map<double, std::vector<std::string>> Files; // of each time
};

#endif
