// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   StepFilter
 * @brief   what the options change in the data of each time step
 */
#ifndef StepFilter_h
#define StepFilter_h

#include "Files/MeshWarp.h"

#include "vtkSmartPointer.h"

#include <string>

class ViewerMessages;
class vtkDataObject;

class StepFilter
{
public:
  /// array is the name of an array, or of a quantity of vtkArrayQuantityFilter.
  StepFilter(const MeshWarp& warp, const std::string& array);

  /// Moves the points and computes the quantity. Returns nullptr after an error, which is not one
  /// of reading: Check() throws it as ViewerError.
  vtkSmartPointer<vtkDataObject> Apply(vtkDataObject* data, ViewerMessages& messages);
  void Check(const std::string& fileName) const;

  void SetFactor(double factor) { this->Warp.Factor = factor; }
  const MeshWarp& GetWarp() const { return this->Warp; }

  /// The array with the quantity, after the first step.
  const std::string& GetArray() const { return this->Array; }

private:
  vtkSmartPointer<vtkDataObject> AddQuantity(vtkDataObject* data, ViewerMessages& messages);

  std::string Error;
  MeshWarp Warp;
  std::string Array;
};

#endif
