// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshContourFilter promises the isosurfaces of vtkFlyingEdges3D and vtkContourGrid within
// the tolerance, without cracks between blocks, and requests only the points of a block from
// sources that can produce them.
#include "RelevoCheck.h"
#include "RelevoMicroMeshes.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkContourGrid.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMicroMeshContourFilter.h"
#include "vtkMicroMeshErrorDepthTagMetric.h"
#include "vtkMicroMeshSurface.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

using namespace RelevoMicroMeshes;

namespace
{
constexpr double Tolerance = 0.012;
constexpr double Spacing = 0.055;

double Evaluate(const double x[3])
{
  const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  return r + 0.05 * std::sin(9.0 * x[0]) * std::sin(8.0 * x[1] + 1.0) * std::sin(10.0 * x[2]);
}

// A source that produces any part of an image, and stores the largest number of points requested.
class BumpsSource : public vtkImageAlgorithm
{
public:
  static BumpsSource* New();
  vtkTypeMacro(BumpsSource, vtkImageAlgorithm);

  bool CanProduceParts = true;
  vtkIdType MostPoints = 0;
  int NumberOfRequests = 0;

protected:
  BumpsSource() { this->SetNumberOfInputPorts(0); }
  ~BumpsSource() override = default;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* output = outputs->GetInformationObject(0);
    const int whole[6] = { -20, 21, -21, 20, -20, 20 };
    const double origin[3] = { 0.003, -0.004, 0.002 };
    const double spacing[3] = { Spacing, Spacing, Spacing };
    output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
    output->Set(vtkDataObject::ORIGIN(), origin, 3);
    output->Set(vtkDataObject::SPACING(), spacing, 3);
    if (this->CanProduceParts)
    {
      output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    }
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* output = outputs->GetInformationObject(0);
    auto image = vtkImageData::GetData(outputs);
    image->SetExtent(output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
    image->SetOrigin(output->Get(vtkDataObject::ORIGIN()));
    image->SetSpacing(output->Get(vtkDataObject::SPACING()));
    const vtkIdType number = image->GetNumberOfPoints();
    this->MostPoints = std::max(this->MostPoints, number);
    ++this->NumberOfRequests;
    vtkNew<vtkFloatArray> bumps;
    bumps->SetName("Bumps");
    vtkNew<vtkFloatArray> ramp;
    ramp->SetName("Ramp");
    ramp->SetNumberOfComponents(2);
    vtkNew<vtkUnsignedCharArray> color;
    color->SetName("Color");
    color->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < number; ++i)
    {
      double x[3];
      image->GetPoint(i, x);
      bumps->InsertNextValue(static_cast<float>(Evaluate(x)));
      ramp->InsertNextTuple2(x[0] - 2.0 * x[2], x[1]);
      color->InsertNextTuple3(128.0 + 90.0 * x[0], 128.0, 128.0 - 90.0 * x[1]);
    }
    image->GetPointData()->SetScalars(bumps);
    image->GetPointData()->AddArray(ramp);
    image->GetPointData()->AddArray(color);
    return 1;
  }
};
vtkStandardNewMacro(BumpsSource);

vtkSmartPointer<vtkMicroMeshContourFilter> NewFilter()
{
  auto filter = vtkSmartPointer<vtkMicroMeshContourFilter>::New();
  filter->SetTolerance(Tolerance);
  filter->SetTargetReduction(0.95);
  filter->SetMaximumLevel(3);
  filter->SetBlockSize(16);
  filter->SetValue(0, 0.83);
  return filter;
}

vtkIdType CountOpenEdges(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> places;
  places->SetPoints(mesh->GetPoints());
  places->SetPolys(mesh->GetPolys());
  vtkNew<vtkCleanPolyData> clean; // merges only equal points
  clean->SetInputData(places);
  clean->SetTolerance(0.0);
  clean->ConvertPolysToLinesOff();
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(clean->GetOutputPort());
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

// Levels that differ between edges.
Mesh DecodeMixed(vtkPolyData* micro)
{
  vtkNew<vtkMicroMeshSurface> surface;
  vtkNew<vtkMicroMeshErrorDepthTagMetric> metric;
  metric->SetMaximumError(0.5 * Tolerance);
  const auto recipe = RelevoMeshes::MakeRecipe(3, surface);
  recipe->SetMetric(metric);
  recipe->SetLevelRuleToPerEdge();
  return RelevoMeshes::Refine(micro, recipe);
}

void CheckSurface(
  RelevoCheck& check, vtkMicroMeshContourFilter* filter, vtkPolyData* dense, double most)
{
  vtkPolyData* micro = filter->GetOutput();
  CHECK_GREATER(dense->GetNumberOfPolys(), 1000);
  CHECK_EQUAL(filter->GetNumberOfTriangles(), dense->GetNumberOfPolys());
  CHECK_GREATER(micro->GetNumberOfPolys(), 3);
  CHECK_LESS(micro->GetNumberOfPolys(), most * dense->GetNumberOfPolys());
  CHECK_LESS_EQUAL(filter->GetError(), Tolerance);
  vtkDataArray* bounds = micro->GetFieldData()->GetArray("MicroMeshError");
  if (!CHECK(bounds && bounds->GetNumberOfTuples() == 2))
  {
    return;
  }
  CHECK_EQUAL(filter->GetError(), std::max(bounds->GetTuple1(0), bounds->GetTuple1(1)));
  const Mesh result = Decode(micro, 3);
  CHECK_LESS_EQUAL(GetDistance(dense, result), bounds->GetTuple1(0) + 1e-6);
  CHECK_LESS_EQUAL(GetDistance(result, dense), bounds->GetTuple1(1) + 1e-6);
  CHECK_EQUAL(CountOpenEdges(result), 0);
  CHECK_EQUAL(CountOpenEdges(DecodeMixed(micro)), 0);
  for (const char* name : { "MicroMeshFixedPoints", "vtkOriginalCellIds" })
  {
    CHECK(!micro->GetPointData()->HasArray(name) && !micro->GetCellData()->HasArray(name));
  }
}

// Points of different blocks at the same place have the same normal.
void CheckNormals(RelevoCheck& check, vtkPolyData* micro)
{
  vtkDataArray* normals = micro->GetPointData()->GetNormals();
  std::map<std::array<double, 3>, std::array<double, 3>> places;
  int shared = 0;
  int different = 0;
  double largest = -1.0;
  for (vtkIdType i = 0; i < micro->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> x{};
    std::array<double, 3> n{};
    micro->GetPoint(i, x.data());
    normals->GetTuple(i, n.data());
    const auto added = places.emplace(x, n);
    shared += added.second ? 0 : 1;
    different += added.first->second == n ? 0 : 1;
    const double size = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    largest = std::max(largest, (n[0] * x[0] + n[1] * x[1] + n[2] * x[2]) / size);
  }
  CHECK_GREATER(shared, 50);
  CHECK_EQUAL(different, 0);
  CHECK_LESS(largest, -0.5); // towards lower scalars
}

void CheckAttributes(RelevoCheck& check, vtkPolyData* micro)
{
  const Mesh result = Decode(micro, 3);
  vtkDataArray* ramp = result->GetPointData()->GetArray("Ramp");
  vtkDataArray* gradients = micro->GetPointData()->GetArray("Gradients");
  vtkDataArray* color = micro->GetPointData()->GetArray("Color");
  vtkDataArray* value = micro->GetPointData()->GetArray("Bumps");
  if (!CHECK(ramp && gradients && color && value))
  {
    return;
  }
  CHECK_EQUAL(color->GetDataType(), VTK_UNSIGNED_CHAR);
  CHECK_EQUAL(value->GetRange()[0], value->GetRange()[1]);
  CHECK_NEAR(value->GetRange()[0], 0.83, 1e-6);
  double ofRamp = 0.0;
  double ofGradients = 0.0;
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    double x[3];
    result->GetPoint(i, x);
    ofRamp = std::max({ ofRamp, std::abs(ramp->GetComponent(i, 0) - x[0] + 2.0 * x[2]),
      std::abs(ramp->GetComponent(i, 1) - x[1]) });
  }
  for (vtkIdType i = 0; i < micro->GetNumberOfPoints(); ++i)
  {
    double x[3];
    micro->GetPoint(i, x); // on the isosurface
    for (int axis = 0; axis < 3; ++axis)
    {
      double before[3] = { x[0], x[1], x[2] };
      double after[3] = { x[0], x[1], x[2] };
      before[axis] -= Spacing;
      after[axis] += Spacing;
      const double slope = (Evaluate(after) - Evaluate(before)) / (2.0 * Spacing);
      ofGradients = std::max(ofGradients, std::abs(gradients->GetComponent(i, axis) - slope));
    }
  }
  CHECK_LESS(ofRamp, 3.0 * Tolerance);
  CHECK_LESS(ofGradients, 0.04); // of about 1; one-sided differences at borders are worse
}

void CheckImage(RelevoCheck& check)
{
  vtkNew<BumpsSource> source;
  const auto filter = NewFilter();
  RelevoErrors errors(filter);
  filter->SetInputConnection(source->GetOutputPort());
  filter->ComputeGradientsOn();
  filter->ComputeScalarsOn();
  vtkNew<vtkCleanPolyData> next; // runs the requests of all blocks, too
  next->SetInputConnection(filter->GetOutputPort());
  next->PointMergingOff();
  next->Update();
  CHECK(errors.None());
  CHECK_EQUAL(filter->GetNumberOfBlocks(), 27);
  CHECK_GREATER(source->NumberOfRequests, 26);
  CHECK_LESS(source->NumberOfRequests, 2 * 27); // some blocks twice
  CHECK_LESS_EQUAL(source->MostPoints, 17 * 17 * 17);
  CHECK_EQUAL(next->GetOutput()->GetNumberOfCells(), filter->GetOutput()->GetNumberOfCells());
  vtkNew<vtkPolyData> streamed;
  streamed->DeepCopy(filter->GetOutput());

  vtkNew<BumpsSource> whole;
  whole->CanProduceParts = false;
  filter->SetInputConnection(whole->GetOutputPort());
  vtkSMPTools::Initialize(3);
  filter->Update();
  vtkSMPTools::Initialize();
  CHECK_EQUAL(whole->NumberOfRequests, 1);
  CHECK_EQUAL(CountDifferences(streamed, filter->GetOutput()), 0);

  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(whole->GetOutputPort());
  contour->SetValue(0, 0.83);
  contour->Update();
  CheckSurface(check, filter, contour->GetOutput(), 0.08);
  CheckNormals(check, filter->GetOutput());
  CheckAttributes(check, filter->GetOutput());
  // A block with the whole image, and none.
  filter->SetBlockSize(64);
  filter->AttributesOff();
  filter->SetValue(0, 5.0);
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfBlocks(), 1);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->SetValue(0, 0.7);
  filter->Update();
  CHECK_GREATER(filter->GetOutput()->GetNumberOfCells(), 0);
  CHECK(!filter->GetOutput()->GetPointData()->HasArray("Ramp"));
  CHECK(errors.None());
}

void CheckGrid(RelevoCheck& check, vtkUnstructuredGrid* grid)
{
  const auto filter = NewFilter();
  RelevoErrors errors(filter);
  filter->SetBlockSize(20);
  filter->SetInputData(grid);
  filter->Update();
  CHECK(errors.None());
  CHECK_GREATER(filter->GetNumberOfBlocks(), 2);
  vtkNew<vtkContourGrid> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, 0.83);
  contour->Update();
  CheckSurface(check, filter, contour->GetOutput(), 0.08);
  CheckNormals(check, filter->GetOutput());
  CHECK(filter->GetOutput()->GetPointData()->HasArray("Ramp"));
  CHECK(!filter->GetOutput()->GetPointData()->HasArray("Bumps"));
}

void CheckErrors(RelevoCheck& check)
{
  vtkNew<BumpsSource> source;
  source->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(source->GetOutputDataObject(0));
  vtkNew<vtkMicroMeshContourFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(image);
  filter->Update();
  CHECK(errors.Said("Tolerance is not set"));
  filter->SetTolerance(0.0);
  CHECK(errors.Said("Tolerance must be more than 0"));
  filter->SetTolerance(0.1);
  filter->Update();
  CHECK(errors.Said("There is no contour value"));
  filter->SetValue(0, std::nan(""));
  filter->Update();
  CHECK(errors.Said("Contour value 0 is not finite"));
  filter->SetValue(0, 0.8);
  filter->SetBlockSize(1);
  CHECK(errors.Said("BlockSize must be in [8, 16384]"));
  for (const char* name : { "Nothing", "Color", "Cells" })
  {
    vtkNew<vtkDoubleArray> cells;
    cells->SetName("Cells");
    cells->SetNumberOfTuples(image->GetNumberOfCells());
    cells->Fill(0.0);
    image->GetCellData()->AddArray(cells);
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    filter->Update();
    const std::string text = name;
    CHECK(errors.Said(text == "Nothing" ? "no numeric point array \"Nothing\""
        : text == "Color"               ? "\"Color\" has 3 components, but 1 is needed"
                                        : "a cell array of that name"));
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  }
  // Where scalars are missing, the surface has a hole.
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Bumps");
  filter->Update();
  CHECK_EQUAL(CountOpenEdges(Decode(filter->GetOutput(), 2)), 0);
  const int corner[3] = { 15, 0, 0 };
  auto bumps = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  bumps->SetValue(image->ComputePointId(const_cast<int*>(corner)), std::nanf(""));
  bumps->Modified();
  image->Modified();
  filter->Update();
  CHECK_GREATER(filter->GetOutput()->GetNumberOfCells(), 0);
  CHECK(errors.None());
}
}

int TestMicroMeshContourFilter(int, char*[])
{
  RelevoCheck check;
  CheckImage(check);
  vtkNew<BumpsSource> source;
  vtkNew<vtkAppendFilter> hexahedra; // voxels
  hexahedra->SetInputConnection(source->GetOutputPort());
  hexahedra->Update();
  CheckGrid(check, hexahedra->GetOutput());
  vtkNew<vtkDataSetTriangleFilter> tetrahedra;
  tetrahedra->SetInputConnection(source->GetOutputPort());
  tetrahedra->Update();
  CheckGrid(check, tetrahedra->GetOutput());
  CheckErrors(check);
  return check.GetResult();
}
