// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/PointDataInterpolation.h"

#include "Arrays/NearestTuple.h"
#include "Arrays/NoDataTuples.h"
#include "Arrays/SimilarArray.h"
#include "Mathematics/NearestNumber.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace relevo
{
class PointDataInterpolation::ArrayPair
{
public:
  virtual ~ArrayPair() = default;
  virtual void Interpolate(const int corners[3], const std::vector<RefinedPoint>& points) = 0;
  virtual void Copy(vtkIdType inputPoint, vtkIdType point) = 0;
};

namespace
{
// For two arrays with contiguous memory.
template <typename T>
class TypedPair : public PointDataInterpolation::ArrayPair
{
public:
  TypedPair(const T* from, T* to, int numberOfComponents, NoDataTuples&& noData)
    : From(from)
    , To(to)
    , NumberOfComponents(numberOfComponents)
    , NoData(std::move(noData))
  {
  }
  void Interpolate(const int corners[3], const std::vector<RefinedPoint>& points) override
  {
    for (const RefinedPoint& point : points)
    {
      const float* w = point.Weights;
      const int nearest = point.GetNearestCorner();
      if (w[nearest] == 1.0f)
      {
        this->Copy(corners[nearest], point.Id);
        continue;
      }
      T* to = this->To + point.Id * this->NumberOfComponents;
      const int noDataCorner = this->NoData.FindCorner(corners, w);
      if (noDataCorner >= 0)
      {
        this->SpreadNoData(corners[noDataCorner], to, std::is_integral<T>());
        continue;
      }
      for (int c = 0; c < this->NumberOfComponents; ++c)
      {
        // A corner with weight 0 must be ignored even if its value is NaN.
        double sum = 0.0;
        for (int i = 0; i < 3; ++i)
        {
          sum += w[i] == 0.0f ? 0.0 : w[i] * static_cast<double>(this->GetFrom(corners[i])[c]);
        }
        to[c] = getNearestNumber<T>(sum);
      }
    }
  }
  void Copy(vtkIdType inputPoint, vtkIdType point) override
  {
    std::copy_n(this->GetFrom(inputPoint), this->NumberOfComponents,
      this->To + point * this->NumberOfComponents);
  }

private:
  const T* GetFrom(vtkIdType point) const { return this->From + point * this->NumberOfComponents; }

  // Integers have no NaN, so the corner's missing value is copied.
  void SpreadNoData(vtkIdType corner, T* to, std::true_type) const
  {
    std::copy_n(this->GetFrom(corner), this->NumberOfComponents, to);
  }
  void SpreadNoData(vtkIdType, T* to, std::false_type) const
  {
    std::fill_n(to, this->NumberOfComponents, std::numeric_limits<T>::quiet_NaN());
  }

  const T* From;
  T* To;
  int NumberOfComponents;
  NoDataTuples NoData;
};

struct MakeTypedPair
{
  NoDataTuples NoData;
  std::unique_ptr<PointDataInterpolation::ArrayPair> Result;

  template <typename T>
  void operator()(vtkAOSDataArrayTemplate<T>* to, vtkDataArray* from)
  {
    if (auto* typed = vtkAOSDataArrayTemplate<T>::FastDownCast(from))
    {
      this->Result.reset(new TypedPair<T>(typed->GetPointer(0), to->GetPointer(0),
        to->GetNumberOfComponents(), std::move(this->NoData)));
    }
  }
  // Other memory layouts use GeneralPair.
  template <typename ArrayT>
  void operator()(ArrayT*, vtkDataArray*)
  {
  }
};

// For all other numeric arrays.
class GeneralPair : public PointDataInterpolation::ArrayPair
{
public:
  GeneralPair(vtkDataArray* from, vtkDataArray* to, NoDataTuples&& noData)
    : From(from)
    , To(to)
    , IsInteger(HoldsIntegers(to))
    , NoData(std::move(noData))
  {
  }
  void Interpolate(const int corners[3], const std::vector<RefinedPoint>& points) override
  {
    for (const RefinedPoint& point : points)
    {
      const int nearest = point.GetNearestCorner();
      const int noDataCorner = this->NoData.FindCorner(corners, point.Weights);
      if (point.Weights[nearest] == 1.0f || (noDataCorner >= 0 && this->IsInteger))
      {
        this->Copy(corners[noDataCorner >= 0 ? noDataCorner : nearest], point.Id);
        continue;
      }
      for (int c = 0; c < this->To->GetNumberOfComponents(); ++c)
      {
        double sum = 0.0;
        for (int i = 0; i < 3; ++i)
        {
          const float w = point.Weights[i];
          sum += w == 0.0f ? 0.0 : w * this->From->GetComponent(corners[i], c);
        }
        sum = noDataCorner >= 0 ? std::numeric_limits<double>::quiet_NaN() : sum;
        this->To->SetComponent(point.Id, c, this->IsInteger ? std::round(sum) : sum);
      }
    }
  }
  void Copy(vtkIdType inputPoint, vtkIdType point) override
  {
    this->To->SetTuple(point, inputPoint, this->From);
  }

private:
  vtkDataArray* From;
  vtkDataArray* To;
  bool IsInteger;
  NoDataTuples NoData;
};
}

PointDataInterpolation::PointDataInterpolation(vtkPointData* from, vtkIdType numberOfInputPoints,
  vtkPointData* to, vtkIdType numberOfPoints, double noDataMagnitude)
{
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* source = from->GetAbstractArray(a);
    if (source == from->GetGlobalIds() || source == from->GetPedigreeIds())
    {
      continue;
    }
    if (source->GetNumberOfTuples() < numberOfInputPoints)
    {
      this->ShortArrays.emplace_back(source->GetName() ? source->GetName() : "");
      continue;
    }
    vtkAbstractArray* target = AddArrayLike(from, source, to, numberOfPoints);
    if (!IsInterpolated(source))
    {
      this->SerialArrays.emplace_back(source, target);
      continue;
    }
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(source);
    vtkDataArray* result = vtkDataArray::SafeDownCast(target);
    MakeTypedPair make;
    if (CanLackData(from, numbers))
    {
      make.NoData = NoDataTuples(numbers, noDataMagnitude);
    }
    vtkArrayDispatch::Dispatch::Execute(result, make, numbers);
    if (!make.Result)
    {
      make.Result.reset(new GeneralPair(numbers, result, std::move(make.NoData)));
    }
    this->Arrays.push_back(std::move(make.Result));
  }
}

PointDataInterpolation::~PointDataInterpolation() = default;

void PointDataInterpolation::Interpolate(
  const int corners[3], const std::vector<RefinedPoint>& points) const
{
  for (const auto& array : this->Arrays)
  {
    array->Interpolate(corners, points);
  }
}

void PointDataInterpolation::Copy(vtkIdType inputPoint, vtkIdType point) const
{
  for (const auto& array : this->Arrays)
  {
    array->Copy(inputPoint, point);
  }
}

void PointDataInterpolation::InterpolateSerial(
  const int corners[3], const std::vector<RefinedPoint>& points) const
{
  for (const RefinedPoint& point : points)
  {
    this->CopySerial(corners[point.GetNearestCorner()], point.Id);
  }
}

void PointDataInterpolation::CopySerial(vtkIdType inputPoint, vtkIdType point) const
{
  for (const auto& pair : this->SerialArrays)
  {
    pair.second->SetTuple(point, inputPoint, pair.first);
  }
}
}
