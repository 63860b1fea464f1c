// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SeriesReader
 * @brief   reads the files that a series of ParaView (.vtu.series and likewise) lists
 *
 * These are JSON files: {"files": [{"name": "a.vtu", "time": 0.5}, ...]}.
 */
#ifndef SeriesReader_h
#define SeriesReader_h

#include "Files/ResultReader.h"

#include <functional>
#include <map>
#include <memory>
#include <string>

class ViewerMessages;

class SeriesReader : public ResultReader
{
public:
  using Opener = std::function<std::unique_ptr<ResultReader>(const std::string&, ViewerMessages&)>;

  /// Reads the list. The files are opened by a function. Throws ViewerError.
  SeriesReader(const std::string& fileName, ViewerMessages& messages, const Opener& open);

  std::vector<double> GetTimes() override;
  vtkSmartPointer<vtkDataObject> Read(const std::optional<double>& time) override;

private:
  ViewerMessages& Messages;
  Opener Open;
  std::map<double, std::string> Files; // of each time
};

#endif
