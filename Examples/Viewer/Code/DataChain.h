// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DataChain
 * @brief   a reader and filters, which run at once and are written into a program
 */
#ifndef DataChain_h
#define DataChain_h

#include "Code/SceneCode.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

class DataChain
{
public:
  using Calls = std::vector<std::pair<std::string, SceneCode::Values>>;

  /// Starts with a reader of VTK or Relevo. Returns false if the format of the file needs more than
  /// one.
  bool Read(const std::string& fileName, const SceneCode& code);
  /// Adds a filter with settings, which the calls repeat.
  void Add(vtkAlgorithm* filter, const std::string& name, const Calls& calls);

  vtkDataObject* GetOutput();
  std::size_t GetSize() const { return this->Steps.size(); }
  /// Adds all filters to the program. Returns their outputs.
  std::vector<CodeValue> Write(SceneCode& code) const;

private:
  struct Step
  {
    vtkSmartPointer<vtkAlgorithm> Filter;
    std::string Name;
    Calls Settings;
  };
  std::vector<Step> Steps;
};

#endif
