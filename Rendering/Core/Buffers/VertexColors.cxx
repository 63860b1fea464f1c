// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/VertexColors.h"

#include "Arrays/NoDataTuples.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Between a range and the bias, relative to the width of the range. 24 bits of a float leave 14
// bits for values within the range.
constexpr double LargestDistance = 1024.0;
}

// See vtkScalarsToColors::MapScalars().
VertexColors::Choice VertexColors::ChooseComponents(
  int components, vtkScalarsToColors* table, int component)
{
  Choice choice;
  if (components > 1)
  {
    if (component >= 0)
    {
      choice.First = component;
    }
    else if (table->GetVectorMode() == vtkScalarsToColors::COMPONENT)
    {
      choice.First = table->GetVectorComponent();
    }
    else if (table->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
    {
      const int size = table->GetVectorSize();
      choice.First = size > 0 ? table->GetVectorComponent() : 0;
      choice.Count = size > 0 ? size : components;
    }
    else
    {
      choice.Count = 0;
    }
    choice.First = std::min(std::max(choice.First, 0), components - 1);
    choice.Count = std::min(choice.Count, components - choice.First);
  }
  choice.IsLength = choice.Count > 1;
  return choice;
}

// See vtkMapper::MapScalarsToTexture().
VertexColors::Choice VertexColors::ChooseTextureComponents(
  int components, vtkScalarsToColors* table)
{
  Choice choice;
  choice.First = table->GetVectorComponent();
  if ((table->GetVectorMode() == vtkScalarsToColors::MAGNITUDE && components > 1) ||
    choice.First < 0 || choice.First >= components)
  {
    choice = { 0, components, true };
  }
  return choice;
}

bool VertexColors::Upload(vtkOpenGLRenderWindow* window, vtkAbstractArray* scalars,
  vtkScalarsToColors* table, int component, bool byTexture, double noDataMagnitude, int type)
{
  this->Kind = BY_VTK;
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(scalars);
  if (!numbers || numbers->GetDataType() == VTK_BIT)
  {
    this->ReleaseGraphicsResources(window);
    this->Kind = byTexture ? BY_VTK : BY_NEAREST;
    return true;
  }
  // VTK's colours are used for categories and for logarithms of negative numbers.
  if (table->GetIndexedLookup() || (table->UsingLogScale() && !(table->GetRange()[0] > 0.0)))
  {
    return true;
  }
  const int components = numbers->GetNumberOfComponents();
  const Choice choice = byTexture ? ChooseTextureComponents(components, table)
                                  : ChooseComponents(components, table, component);
  if (choice.Count < 1)
  {
    return true;
  }
  type = type == VTK_VOID ? numbers->GetDataType() : type;
  this->AreIntegers = type != VTK_FLOAT && type != VTK_DOUBLE;
  Dependencies values = Dependencies::On(choice.First, choice.Count, choice.IsLength);
  values.AddObject(numbers);
  if (this->RangeDependencies.Update(values))
  {
    this->FindRange(numbers, choice);
  }
  this->ChooseBias(table, choice);
  values.Add(this->Bias);
  values.Add(noDataMagnitude);
  if (this->UploadDependencies.Update(values))
  {
    ++this->NumberOfUploads;
    if (!this->UploadValues(window, numbers, choice) ||
      !this->UploadNoData(window, numbers, noDataMagnitude))
    {
      this->UploadDependencies.Clear();
      return false;
    }
  }
  if (byTexture)
  {
    this->SetCoordinates(table);
    this->Kind = BY_TEXTURE;
    return true;
  }
  this->Kind = BY_VALUE;
  return this->Table.Upload(
    window, table, this->Bias, this->Range, this->AreIntegers && !choice.IsLength);
}

void VertexColors::FindRange(vtkDataArray* scalars, const Choice& choice)
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  double largest = 0.0; // squared length
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    double squares = 0.0;
    for (int c = 0; c < choice.Count; ++c)
    {
      const double value = scalars->GetComponent(i, choice.First + c);
      squares += value * value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    largest = squares > largest ? squares : largest;
  }
  // An interpolated vector can be shorter than at all points.
  this->Range[0] = choice.IsLength ? 0.0 : low;
  this->Range[1] = choice.IsLength ? std::sqrt(largest) : high;
}

// Subtracting a bias keeps the precision of narrow ranges far from zero. It is the smallest value
// if that is precise enough, so that other ranges need no upload.
void VertexColors::ChooseBias(vtkScalarsToColors* table, const Choice& choice)
{
  const double* range = table->GetRange();
  const double smallest = this->Range[0];
  const double distance = std::max(std::abs(range[0] - smallest), std::abs(range[1] - smallest));
  const bool isPrecise = distance <= LargestDistance * (range[1] - range[0]);
  const bool isLog = ColorTable::IsLogarithmic(table);
  this->Bias = choice.IsLength || isLog ? 0.0 : isPrecise ? smallest : range[0];
  if (this->AreIntegers)
  {
    constexpr double largestExact = 1 << 24;
    const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
    this->Bias = largest < largestExact ? 0.0 : std::floor(this->Bias);
  }
}

bool VertexColors::UploadValues(
  vtkOpenGLRenderWindow* window, vtkDataArray* scalars, const Choice& choice)
{
  this->Texels = choice.IsLength ? (choice.Count + 3) / 4 : 0;
  const int perPoint = choice.IsLength ? 4 * this->Texels : 1;
  const vtkIdType numberOfPoints = scalars->GetNumberOfTuples();
  std::vector<float> values(static_cast<size_t>(perPoint) * numberOfPoints, 0.0f);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    for (int c = 0; c < choice.Count; ++c)
    {
      values[static_cast<size_t>(perPoint) * i + c] =
        static_cast<float>(scalars->GetComponent(i, choice.First + c) - this->Bias);
    }
  }
  return this->Scalars.Upload(window, values, choice.IsLength ? 4 : 1);
}

void VertexColors::SetCoordinates(vtkScalarsToColors* table)
{
  // As in vtkMapper, there is one more texel at both ends for the colours below and above the
  // range.
  double range[2] = { table->GetRange()[0], table->GetRange()[1] };
  const bool isLog = table->UsingLogScale() != 0;
  if (isLog)
  {
    vtkLookupTable::GetLogRange(range, range);
  }
  const double texel =
    (range[1] - range[0]) / static_cast<double>(table->GetNumberOfAvailableColors());
  this->Coordinates[0] = static_cast<float>(range[0] - texel - this->Bias);
  this->Coordinates[1] = static_cast<float>(1.0 / (range[1] - range[0] + 2.0 * texel));
  this->Coordinates[2] = isLog ? 1.0f : 0.0f;
}

bool VertexColors::UploadNoData(
  vtkOpenGLRenderWindow* window, vtkDataArray* scalars, double noDataMagnitude)
{
  const NoDataTuples noData(scalars, noDataMagnitude);
  if (noData.IsEmpty())
  {
    this->NoData.ReleaseGraphicsResources(window);
    return true;
  }
  const std::vector<unsigned char>& marks = noData.GetMarks();
  return this->NoData.Upload(window, std::vector<float>(marks.begin(), marks.end()), 1);
}

void VertexColors::Activate(vtkShaderProgram* program)
{
  this->NoData.Activate(program, "relevoNoData");
  if (!program->IsUniformUsed("relevoScalars"))
  {
    return;
  }
  this->Scalars.Activate(program, "relevoScalars");
  this->Table.Activate(program);
  if (program->IsUniformUsed("relevoNotANumber"))
  {
    program->SetUniformf("relevoNotANumber", std::numeric_limits<float>::quiet_NaN());
  }
  program->SetUniformi("relevoScalarTexels", this->Texels);
  program->SetUniformi("relevoScalarsAreIntegers", this->AreIntegers ? 1 : 0);
  program->SetUniform3f("relevoScalarCoordinates", this->Coordinates);
}

void VertexColors::Deactivate()
{
  this->NoData.Deactivate();
  this->Scalars.Deactivate();
  this->Table.Deactivate();
}

vtkTypeInt64 VertexColors::GetMemorySize() const
{
  return this->NoData.GetMemorySize() + this->Scalars.GetMemorySize() + this->Table.GetMemorySize();
}

void VertexColors::ReleaseGraphicsResources(vtkWindow* window)
{
  this->UploadDependencies.Clear();
  this->NoData.ReleaseGraphicsResources(window);
  this->Scalars.ReleaseGraphicsResources(window);
  this->Table.ReleaseGraphicsResources(window);
}
}
