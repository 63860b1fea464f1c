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
class vtkPolyData;

class StepFilter
{
public:
  /// array is the name of an array, or of a quantity of vtkArrayQuantityFilter. integrationPoints
  /// is one of values at integration points, which replaces it by the averages of cells; empty for
  /// none.
  StepFilter(
    const MeshWarp& warp, const std::string& array, const std::string& integrationPoints = "");
  ~StepFilter();

  /// Moves the points, averages values at integration points in each cell, and computes the
  /// quantity. Returns nullptr after an error, which is not one of reading: Check() throws it as
  /// ViewerError.
  vtkSmartPointer<vtkDataObject> Apply(vtkDataObject* data, ViewerMessages& messages);
  void Check(const std::string& fileName) const;

  void SetFactor(double factor) { this->Warp.Factor = factor; }
  const MeshWarp& GetWarp() const { return this->Warp; }

  /// The array with the quantity, after the first step.
  const std::string& GetArray() const { return this->Array; }

  /// Whether this array is an average of values at integration points, or a quantity of one.
  bool IsAverage() const { return this->ShowsAverage; }

  /// The integration points of the last step with their values; nullptr if none are requested.
  vtkPolyData* GetIntegrationPoints() const;
  /// The array of these points, after the first step.
  const std::string& GetPointArray() const { return this->PointArray; }

private:
  vtkSmartPointer<vtkDataObject> Average(vtkDataObject* data, ViewerMessages& messages);
  void FindPoints(vtkDataObject* data, ViewerMessages& messages);
  vtkSmartPointer<vtkDataObject> AddQuantity(vtkDataObject* data, ViewerMessages& messages);

  std::string Error;
  MeshWarp Warp;
  std::string Array;
  bool ShowsAverage = false;
  std::string PointArray;
  vtkSmartPointer<vtkPolyData> Points;
};

#endif
