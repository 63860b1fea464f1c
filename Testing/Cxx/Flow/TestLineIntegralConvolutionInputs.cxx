// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLineIntegralConvolution promises: it accepts vectors of every type and layout, slices in every
// plane, spacing and direction matrices, and noise of several types. The output has the geometry of
// the input.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkLICNoiseSource.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"

#include <iostream>

namespace
{
constexpr int Columns = 64;
constexpr int Rows = 48;

// Whole numbers, which arrays of every type can store.
void Flow(double x, double y, double* v)
{
  v[0] = std::floor(60.0 - 2.0 * y);
  v[1] = std::floor(x - 20.0);
}

std::vector<double> RunOn(vtkImageData* image)
{
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(image);
  return RunLIC(filter);
}

// Makes a slice whose flow runs along two coordinate axes. The third component has no effect.
vtkSmartPointer<vtkImageData> MakeSlice(int firstAxis, int secondAxis, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  int extent[6] = { 4, 4, -3, -3, 7, 7 };
  extent[2 * firstAxis + 1] += Columns - 1;
  extent[2 * secondAxis + 1] += Rows - 1;
  image->SetExtent(extent);
  image->SetOrigin(3.0, 2.0, 1.0);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetNumberOfComponents(components);
  for (int row = 0; row < Rows; ++row)
  {
    for (int column = 0; column < Columns; ++column)
    {
      double flow[2];
      Flow(column + 0.5, row + 0.5, flow);
      double vector[3] = { 77.0, 77.0, 77.0 };
      vector[firstAxis] = flow[0];
      vector[secondAxis] = flow[1];
      vectors->InsertNextTuple(components == 2 ? flow : vector);
    }
  }
  image->GetPointData()->AddArray(vectors);
  return image;
}

void TestArrays(RelevoCheck& check, const std::vector<double>& expected)
{
  for (int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_INT, VTK_LONG, VTK_LONG_LONG,
         VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    CHECK_CASE(type);
    for (int components : { 2, 3 })
    {
      CHECK_CASE(components);
      const auto image = MakeFlowImage(Columns, Rows, Flow);
      vtkDataArray* flow = image->GetPointData()->GetArray("Flow");
      auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
      array->SetNumberOfComponents(components);
      array->SetNumberOfTuples(flow->GetNumberOfTuples());
      for (int c = 0; c < components; ++c)
      {
        array->CopyComponent(c, flow, c);
      }
      image->GetPointData()->Initialize();
      image->GetPointData()->AddArray(array);
      CHECK_EQUAL(RunOn(image), expected);
    }
  }
  vtkNew<vtkSOADataArrayTemplate<double>> soa;
  soa->DeepCopy(MakeFlowImage(Columns, Rows, Flow)->GetPointData()->GetArray("Flow"));
  vtkNew<vtkImageData> image;
  image->SetDimensions(Columns, Rows, 1);
  image->GetPointData()->AddArray(soa);
  CHECK_EQUAL(RunOn(image), expected);
}

void TestChoice(RelevoCheck& check, const std::vector<double>& expected)
{
  const auto image = MakeFlowImage(Columns, Rows, Flow);
  const auto uniform = MakeFlowImage(Columns, Rows, MakeUniformField(1.0, 0.0));
  vtkDataArray* other = uniform->GetPointData()->GetArray("Flow");
  other->SetName("Other");
  image->GetPointData()->AddArray(other);
  CHECK_EQUAL(RunOn(image), expected);
  const std::vector<double> expectedOther = RunOn(uniform);
  CHECK_NOT_EQUAL(expectedOther, expected);

  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Other");
  CHECK_EQUAL(RunLIC(filter), expectedOther);
  image->GetPointData()->SetActiveVectors("Other");
  CHECK_EQUAL(RunOn(image), expectedOther);

  // Without active vectors or a selected array, the filter takes the first suitable array.
  const auto noise = MakeNoiseImage(Columns, Rows);
  vtkDataArray* scalars = noise->GetPointData()->GetScalars();
  scalars->SetName("First");
  const vtkSmartPointer<vtkDataArray> flow = image->GetPointData()->GetArray("Flow");
  image->GetPointData()->Initialize();
  image->GetPointData()->SetScalars(scalars);
  image->GetPointData()->AddArray(flow);
  image->GetPointData()->AddArray(other);
  CHECK_EQUAL(RunOn(image), expected);
}

void TestPlanes(RelevoCheck& check, const std::vector<double>& expected)
{
  for (const auto& axes : { std::array<int, 2>{ 0, 1 }, { 0, 2 }, { 1, 2 } })
  {
    for (int components : { 2, 3 })
    {
      CHECK_CASE(components);
      const auto slice = MakeSlice(axes[0], axes[1], components);
      vtkNew<vtkLineIntegralConvolution> filter;
      filter->SetInputData(slice);
      CHECK_EQUAL(RunLIC(filter), expected);
      vtkImageData* lic = filter->GetOutput();
      int extent[6];
      slice->GetExtent(extent);
      CHECK(std::equal(extent, extent + 6, lic->GetExtent()));
      CHECK(std::equal(lic->GetOrigin(), lic->GetOrigin() + 3, slice->GetOrigin()));
      CHECK_EQUAL(lic->GetPointData()->GetNumberOfArrays(), 2);
      CHECK_EQUAL(lic->GetScalarType(), VTK_FLOAT);
      CHECK_EQUAL(lic->GetNumberOfScalarComponents(), 1);
      CHECK_EQUAL(lic->GetPointData()->GetArray("LICMask")->GetDataType(), VTK_UNSIGNED_CHAR);
    }
  }
}

void TestGeometry(RelevoCheck& check, const std::vector<double>& expected)
{
  // Here vectors are given in units of the spacing.
  const auto stretched = MakeFlowImage(Columns, Rows,
    [](double x, double y, double* v)
    {
      Flow(x, y, v);
      v[0] *= 0.25;
      v[1] *= -8.0;
    });
  stretched->SetSpacing(0.25, -8.0, 5.0);
  CHECK_EQUAL(RunOn(stretched), expected);

  // Rotated by 90 degrees about z: the image's first axis is y, and its second is -x.
  vtkNew<vtkMatrix3x3> turn;
  const double elements[9] = { 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0 };
  turn->DeepCopy(elements);
  const auto turned = MakeFlowImage(Columns, Rows,
    [](double x, double y, double* v)
    {
      double flow[2];
      Flow(x, y, flow);
      v[0] = -flow[1];
      v[1] = flow[0];
    });
  turned->SetDirectionMatrix(turn);
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(turned);
  CHECK_EQUAL(RunLIC(filter), expected);
  CHECK_EQUAL(filter->GetOutput()->GetDirectionMatrix()->GetElement(1, 0), 1.0);
}

void TestNoise(RelevoCheck& check, const std::vector<double>& expected)
{
  const auto image = MakeFlowImage(Columns, Rows, Flow);
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(image);
  vtkNew<vtkLICNoiseSource> source;
  filter->SetNoiseConnection(source->GetOutputPort());
  CHECK_EQUAL(RunLIC(filter), expected);
  source->SetNoiseGeneratorSeed(2);
  CHECK_NOT_EQUAL(RunLIC(filter), expected);

  // Noise has several types and numbers of components, and may lie in another plane.
  for (int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_DOUBLE, VTK_INT })
  {
    CHECK_CASE(type);
    const double largest = type == VTK_UNSIGNED_CHAR ? 255.0
      : type == VTK_UNSIGNED_SHORT                   ? 65535.0
                                                     : 1.0;
    const auto floats = MakeNoiseImage(30, 20);
    vtkNew<vtkImageData> noise;
    noise->SetDimensions(30, 1, 20);
    noise->AllocateScalars(type, 2);
    for (vtkIdType i = 0; i < 600; ++i)
    {
      vtkDataArray* scalars = floats->GetPointData()->GetScalars();
      const double value = std::round(scalars->GetComponent(i, 0) * largest);
      noise->GetPointData()->GetScalars()->SetComponent(i, 0, value);
      noise->GetPointData()->GetScalars()->SetComponent(i, 1, 3.0);
      scalars->SetComponent(i, 0, value / largest);
    }
    filter->SetNoiseData(floats);
    const std::vector<double> ofFloats = RunLIC(filter);
    filter->SetNoiseData(noise);
    CHECK_LESS(LargestDifference(RunLIC(filter), ofFloats), 1e-6);
  }
}

void TestSmallest(RelevoCheck& check)
{
  const auto noise = MakeNoiseImage(1, 1);
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(MakeFlowImage(1, 1, MakeUniformField(1.0, 2.0)));
  filter->SetNoiseData(noise);
  CHECK_LESS(LargestDifference(RunLIC(filter), ValuesOf(noise)), 1e-6);
  CHECK_EQUAL(ValuesOf(filter->GetOutput(), "LICMask"), std::vector<double>{ 0.0 });
}

// Extremely long and short vectors and steps work.
void TestExtremes(RelevoCheck& check)
{
  for (double scale : { 1e-300, 1e-30, 1e7 })
  {
    const auto image = MakeFlowImage(Columns, Rows, MakeUniformField(0.0, 0.0));
    vtkNew<vtkSOADataArrayTemplate<double>> vectors;
    vectors->SetNumberOfComponents(2);
    vectors->SetNumberOfTuples(image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      double flow[2];
      Flow(i % Columns + 0.5, i / Columns + 0.5, flow);
      vectors->SetTypedComponent(i, 0, flow[0] * scale * 0.01);
      vectors->SetTypedComponent(i, 1, flow[1] * scale * 0.01);
    }
    image->GetPointData()->Initialize();
    image->GetPointData()->AddArray(vectors);
    // Rounding moves only a few samples to the neighbouring texel.
    vtkNew<vtkLineIntegralConvolution> filter;
    filter->EnhancedLICOff();
    filter->SetInputData(MakeFlowImage(Columns, Rows, Flow));
    const std::vector<double> expected = RunLIC(filter);
    filter->SetInputData(image);
    const std::vector<double> lic = RunLIC(filter);
    double difference = 0.0;
    for (std::size_t i = 0; i < expected.size() && CHECK_EQUAL(lic.size(), expected.size()); ++i)
    {
      difference += std::abs(lic[i] - expected[i]) / expected.size();
    }
    CHECK_LESS(difference, 2e-3);
    std::cout << "vectors times " << scale << ": mean difference " << difference << "\n";
    for (double stepSize : { 1e-30, 1e30, 1e300 })
    {
      CHECK_CASE(stepSize);
      for (bool normalized : { false, true })
      {
        CHECK_CASE(normalized);
        filter->SetStepSize(stepSize);
        filter->SetNormalizeVectors(normalized);
        const std::vector<double> values = RunLIC(filter);
        CHECK(!values.empty() &&
          std::all_of(values.begin(), values.end(),
            [](double value) { return value >= 0.0 && value <= 1.0; }));
      }
    }
  }
}

// The filter reports progress and stops when it is aborted.
void TestProgress(RelevoCheck& check)
{
  struct Reports
  {
    std::vector<double> Shares;
    double AbortAt = 2.0;
  } reports;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&reports);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* clientData, void* share)
    {
      Reports* seen = static_cast<Reports*>(clientData);
      seen->Shares.push_back(*static_cast<double*>(share));
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(seen->Shares.back() > seen->AbortAt);
    });
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(MakeFlowImage(Columns, Rows, Flow));
  filter->SetEnhanceContrastToLIC();
  filter->SetAntiAlias(1);
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  CHECK(!RunLIC(filter).empty());
  CHECK_GREATER(reports.Shares.size(), 30);
  CHECK(std::is_sorted(reports.Shares.begin(), reports.Shares.end()));
  CHECK_NEAR(reports.Shares.back(), 1.0, 1e-9);

  reports.AbortAt = 0.3;
  reports.Shares.clear();
  filter->SetPhase(0.5);
  CHECK(RunLIC(filter).empty());
  CHECK(!reports.Shares.empty() && reports.Shares[reports.Shares.size() - 2] < 0.4);
  filter->SetAbortExecute(0);
  reports.AbortAt = 2.0;
  filter->Modified();
  CHECK(!RunLIC(filter).empty());
}
}

int TestLineIntegralConvolutionInputs(int, char*[])
{
  RelevoCheck check;
  const std::vector<double> expected = RunOn(MakeFlowImage(Columns, Rows, Flow));
  CHECK_EQUAL(expected.size(), Columns * Rows);
  TestArrays(check, expected);
  TestChoice(check, expected);
  TestPlanes(check, expected);
  TestGeometry(check, expected);
  TestNoise(check, expected);
  TestSmallest(check);
  TestExtremes(check);
  TestProgress(check);
  return check.GetResult();
}
