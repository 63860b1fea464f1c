// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurvePointData.h"

#include "Arrays/NearestTuple.h"
#include "Arrays/NoDataTuples.h"
#include "Arrays/SimilarArray.h"
#include "Curves/CurveEvaluator.h"
#include "Curves/CurveMesh.h"
#include "Curves/CurveRows.h"
#include "Mathematics/NearestNumber.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayAccessor.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr int LargestGroup = 4; // number of components that are evaluated together

// Returns the node nearest to a parameter, assuming equal spacing.
vtkIdType GetNearestNode(const CurveMesh& mesh, vtkIdType c, double t)
{
  const CurveMesh::Curve& curve = mesh.GetCurves()[c];
  return mesh.GetNodes()[curve.FirstPoint + static_cast<int>(std::lround(t * curve.Degree))];
}

bool HasNoData(const CurveMesh& mesh, vtkIdType c, const NoDataTuples& noData)
{
  const CurveMesh::Curve& curve = mesh.GetCurves()[c];
  const vtkIdType* nodes = &mesh.GetNodes()[curve.FirstPoint];
  return !noData.IsEmpty() &&
    std::any_of(nodes, nodes + curve.Degree + 1,
      [&](vtkIdType node) { return noData.GetMarks()[node] != 0; });
}

// Evaluates an array.
struct ArrayEvaluation
{
  const CurveMesh& Mesh;
  const CurveRows& Rows;
  vtkDataArray* From;
  const NoDataTuples& NoData;

  template <typename ArrayT>
  void operator()(ArrayT* to) const
  {
    const std::vector<double> coefficients = this->Mesh.ComputeCoefficients(this->From);
    vtkSMPTools::For(0, this->Mesh.GetNumberOfCurves(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType c = begin; c < end; ++c)
        {
          if (HasNoData(this->Mesh, c, this->NoData))
          {
            this->SpreadNoData(to, c);
          }
          else
          {
            this->Evaluate(to, c, coefficients);
          }
        }
      });
  }

  template <typename ArrayT>
  void Evaluate(ArrayT* to, vtkIdType c, const std::vector<double>& coefficients) const
  {
    using T = typename vtkDataArrayAccessor<ArrayT>::APIType;
    vtkDataArrayAccessor<ArrayT> values(to);
    const int components = to->GetNumberOfComponents();
    CurveEvaluator curve(this->Mesh, c);
    const double* first = &coefficients[this->Mesh.GetCurves()[c].FirstPoint * components];
    this->Rows.ForEachRow(c,
      [&](double t, vtkIdType point, int)
      {
        const CurveEvaluator::CurveLine line = curve.curveLine(t);
        for (int group = 0; group < components; group += LargestGroup)
        {
          const int size = std::min(components - group, LargestGroup);
          curve.SetCoefficients(first + group, size, components);
          const dvec4 value = curve.curveValueAt(line, curve.curveValueLine(t), t);
          for (int i = 0; i < this->Rows.GetWidth() * size; ++i)
          {
            values.Set(point + i / size, group + i % size,
              getNearestNumber<T>(
                HoldsIntegers(to) ? std::round(value[i % size]) : value[i % size]));
          }
        }
      });
  }

  // Sets points between the ends to NaN. Ends keep their values. Integers, which have no NaN, are
  // copied from the nearest node.
  template <typename ArrayT>
  void SpreadNoData(ArrayT* to, vtkIdType c) const
  {
    using T = typename vtkDataArrayAccessor<ArrayT>::APIType;
    vtkDataArrayAccessor<ArrayT> values(to);
    this->Rows.ForEachRow(c,
      [&](double t, vtkIdType point, int)
      {
        const vtkIdType node = GetNearestNode(this->Mesh, c, t);
        const bool isCopy = t == 0.0 || t == 1.0 || HoldsIntegers(to);
        for (int i = 0; i < this->Rows.GetWidth() * to->GetNumberOfComponents(); ++i)
        {
          const int component = i % to->GetNumberOfComponents();
          values.Set(point + i / to->GetNumberOfComponents(), component,
            isCopy ? static_cast<T>(this->From->GetComponent(node, component))
                   : std::numeric_limits<T>::quiet_NaN());
        }
      });
  }
};

// Single-threaded, because string and bit arrays are not thread-safe.
void CopyNearest(
  vtkAbstractArray* from, const CurveMesh& mesh, const CurveRows& rows, vtkAbstractArray* to)
{
  for (vtkIdType c = 0; c < mesh.GetNumberOfCurves(); ++c)
  {
    rows.ForEachRow(c,
      [&](double t, vtkIdType point, int)
      {
        for (int i = 0; i < rows.GetWidth(); ++i)
        {
          to->SetTuple(point + i, GetNearestNode(mesh, c, t), from);
        }
      });
  }
}
}

void EvaluatePointData(vtkPointSet* input, const CurveMesh& mesh, const CurveRows& rows,
  bool keepNormals, double noDataMagnitude, vtkPointData* to, std::vector<std::string>& shortArrays)
{
  vtkPointData* from = input->GetPointData();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (array == from->GetGlobalIds() || array == from->GetPedigreeIds() ||
      array == from->GetRationalWeights() || (array == from->GetNormals() && !keepNormals))
    {
      continue;
    }
    if (array->GetNumberOfTuples() < input->GetNumberOfPoints())
    {
      shortArrays.emplace_back(array->GetName() ? array->GetName() : "");
      continue;
    }
    vtkAbstractArray* target = AddArrayLike(from, array, to, rows.GetNumberOfPoints());
    if (!IsInterpolated(array))
    {
      CopyNearest(array, mesh, rows, target);
      continue;
    }
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(array);
    const NoDataTuples noData =
      CanLackData(from, numbers) ? NoDataTuples(numbers, noDataMagnitude) : NoDataTuples();
    const ArrayEvaluation evaluate{ mesh, rows, numbers, noData };
    vtkDataArray* result = vtkDataArray::SafeDownCast(target);
    if (!vtkArrayDispatch::Dispatch::Execute(result, evaluate))
    {
      evaluate(result);
    }
  }
}
}
