// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/LICArray.h"

#include "Arrays/VectorData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Return false for no data. A missing third component is 0.
template <typename Tuple>
bool GetVector(const Tuple& tuple, double noDataMagnitude, double vector[3])
{
  vector[2] = 0.0;
  for (vtk::ComponentIdType c = 0; c < tuple.size(); ++c)
  {
    vector[c] = static_cast<double>(tuple[c]);
  }
  return IsVectorData(vector, 3, noDataMagnitude) && IsVectorData(vector, 3, VTK_FLOAT_MAX);
}
}

LICArray LICArray::Check(vtkDataArray* chosen, int association, vtkPolyData* input)
{
  LICArray found;
  found.Array = chosen;
  if (!found.Array)
  {
    return found;
  }
  found.IsOfCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const std::string name = found.Array->GetName() ? found.Array->GetName() : "";
  const int components = found.Array->GetNumberOfComponents();
  const vtkIdType expected =
    found.IsOfCells ? input->GetNumberOfCells() : input->GetNumberOfPoints();
  if (components != 2 && components != 3)
  {
    found.Error = "The array \"" + name + "\" has " + std::to_string(components) +
      (components == 1 ? " component" : " components") + ", but vectors have 2 or 3.";
  }
  else if (found.Array->GetNumberOfTuples() != expected)
  {
    found.Error = "The array \"" + name + "\" has " +
      std::to_string(found.Array->GetNumberOfTuples()) + " vectors, but there are " +
      std::to_string(expected) + (found.IsOfCells ? " cells." : " points.");
  }
  if (!found.Error.empty())
  {
    found.Array = nullptr;
  }
  return found;
}

double LICArray::FindLongest(double noDataMagnitude) const
{
  if (!this->Array)
  {
    return -1.0;
  }
  const auto tuples = vtk::DataArrayTupleRange(this->Array);
  vtkSMPThreadLocal<double> longest(-1.0);
  vtkSMPTools::For(0, this->Array->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      double& local = longest.Local();
      double v[3];
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (GetVector(tuples[i], noDataMagnitude, v))
        {
          local = std::max(local, std::hypot(v[0], v[1], v[2]));
        }
      }
    });
  return longest.size() > 0 ? *std::max_element(longest.begin(), longest.end()) : -1.0;
}

vtkSmartPointer<vtkFloatArray> LICArray::Prepare(double noDataMagnitude, double unit) const
{
  auto prepared = vtkSmartPointer<vtkFloatArray>::New();
  prepared->SetNumberOfComponents(4);
  prepared->SetNumberOfTuples(this->Array->GetNumberOfTuples());
  const auto tuples = vtk::DataArrayTupleRange(this->Array);
  float* out = prepared->GetPointer(0);
  vtkSMPTools::For(0, this->Array->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      double v[3];
      for (vtkIdType i = begin; i < end; ++i)
      {
        const bool valid = GetVector(tuples[i], noDataMagnitude, v);
        for (int c = 0; c < 3; ++c)
        {
          out[4 * i + c] = valid ? static_cast<float>(v[c] / unit) : 0.0f;
        }
        out[4 * i + 3] = valid ? 1.0f : 0.0f;
      }
    });
  return prepared;
}
}
