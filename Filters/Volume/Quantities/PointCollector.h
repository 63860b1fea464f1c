// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PointCollector
 * @brief   collects the integration points of data sets, with their values
 */
#ifndef PointCollector_h
#define PointCollector_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <string>

class vtkDataArray;
class vtkDataSet;
class vtkIdTypeArray;
class vtkPoints;
class vtkPolyData;

namespace relevo
{
class PointCollector
{
public:
  explicit PointCollector(const std::string& arrayName);
  ~PointCollector();

  /// Add the points of a block. Nothing if it has no such array. Returns an error, or "".
  std::string Add(vtkDataSet* data);
  /// Whether a block had the array.
  bool HasArray() const { return this->Values != nullptr; }
  /// The number of points so far.
  vtkIdType GetNumberOfPoints() const;
  /// Cells without points: their number by the name of their type.
  const std::map<std::string, vtkIdType>& GetOtherCells() const { return this->OtherCells; }

  void Finish(vtkPolyData* output);

private:
  std::string AddField(vtkDataSet* data, vtkDataArray* values);
  std::string AddCells(vtkDataSet* data, vtkDataArray* values);
  std::string Prepare(vtkDataArray* values, int components);

  std::string Name;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIdTypeArray> Cells;
  vtkSmartPointer<vtkDataArray> Values;
  std::map<std::string, vtkIdType> OtherCells;
};
}

#endif
