// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMicroMeshContourFilter.h"

#include "Blocks/BlockBorders.h"
#include "Blocks/ContourSettings.h"
#include "Blocks/GridBlocks.h"
#include "Blocks/ImageBlocks.h"
#include "Blocks/MicroMeshAppender.h"
#include "Checks/ErrorCollector.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Data/MicroGrid.h"
#include "Data/MicroMeshArrays.h"
#include "vtkCallbackCommand.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMicroMeshFilter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace
{
constexpr int SmallestBlock = 8;
constexpr int LargestBlock = 1 << 14;
constexpr int LargestNumberOfContours = 1000;

using Pipeline = vtkStreamingDemandDrivenPipeline;

bool HasPiece(vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  return !output->Has(Pipeline::UPDATE_PIECE_NUMBER()) ||
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) <= 0;
}
}

// The blocks and the results of an update. With streaming, there is a request per block.
struct vtkMicroMeshContourFilter::Work
{
  struct Block
  {
    vtkSmartPointer<vtkPolyData> Result;
    double Error = 0.0;
    vtkIdType Triangles = 0;
  };

  void SetNumberOfBlocks(std::size_t number)
  {
    this->Blocks.resize(number);
    this->Borders = relevo::BlockBorders(number);
    this->Queue.resize(number);
    std::iota(this->Queue.begin(), this->Queue.end(), 0);
  }
  bool IsDone() const { return this->Next >= this->Queue.size(); }

  relevo::ContourSettings Settings;
  bool IsStreaming = false;
  bool IsContinued = false; // by another request
  bool HasFailed = false;
  relevo::ImageExtent Whole{};
  std::vector<relevo::ImageExtent> Extents;
  std::vector<Block> Blocks;
  relevo::BlockBorders Borders;
  std::vector<std::size_t> Queue; // blocks; those that do not match others come again
  std::size_t Next = 0;           // in the queue
  double Progress = 0.0;
  std::array<double, 6> Bounds{}; // of the input
};

vtkStandardNewMacro(vtkMicroMeshContourFilter);

vtkMicroMeshContourFilter::vtkMicroMeshContourFilter()
  : ContourValues(vtkSmartPointer<vtkContourValues>::New())
{
  this->ContourValues->SetNumberOfContours(0); // VTK's default is the value 0
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkMicroMeshContourFilter::~vtkMicroMeshContourFilter() = default;

void vtkMicroMeshContourFilter::SetValue(int i, double value)
{
  if (i < 0 || i >= LargestNumberOfContours)
  {
    vtkErrorMacro(
      "SetValue: the index must be 0 to " << LargestNumberOfContours - 1 << ", got " << i << ".");
    return;
  }
  this->ContourValues->SetValue(i, value);
}

double vtkMicroMeshContourFilter::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

void vtkMicroMeshContourFilter::SetNumberOfContours(int number)
{
  if (number < 0 || number > LargestNumberOfContours)
  {
    vtkErrorMacro(
      "NumberOfContours must be 0 to " << LargestNumberOfContours << ", got " << number << ".");
    return;
  }
  this->ContourValues->SetNumberOfContours(number);
}

int vtkMicroMeshContourFilter::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

void vtkMicroMeshContourFilter::GenerateValues(int number, double rangeStart, double rangeEnd)
{
  if (number < 0 || number > LargestNumberOfContours)
  {
    vtkErrorMacro("GenerateValues: the number must be 0 to " << LargestNumberOfContours << ", got "
                                                             << number << ".");
    return;
  }
  this->ContourValues->GenerateValues(number, rangeStart, rangeEnd);
}

void vtkMicroMeshContourFilter::SetTolerance(double tolerance)
{
  if (!(tolerance > 0.0) || !std::isfinite(tolerance))
  {
    vtkErrorMacro("Tolerance must be more than 0 and finite, got " << tolerance << ".");
  }
  else if (this->Tolerance != tolerance)
  {
    this->Tolerance = tolerance;
    this->Modified();
  }
}

void vtkMicroMeshContourFilter::SetTargetReduction(double reduction)
{
  relevo::SetInRange(this, "TargetReduction", this->TargetReduction, reduction, 0.0, 1.0);
}

void vtkMicroMeshContourFilter::SetMaximumLevel(int level)
{
  relevo::SetInRange(this, "MaximumLevel", this->MaximumLevel, level, 0, relevo::LargestMicroLevel);
}

void vtkMicroMeshContourFilter::SetBlockSize(int cells)
{
  relevo::SetInRange(this, "BlockSize", this->BlockSize, cells, SmallestBlock, LargestBlock);
}

vtkMTimeType vtkMicroMeshContourFilter::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

int vtkMicroMeshContourFilter::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

bool vtkMicroMeshContourFilter::CheckSettings()
{
  if (this->Tolerance == 0.0)
  {
    vtkErrorMacro("Tolerance is not set. Call SetTolerance() with a length above 0.");
    return false;
  }
  if (this->GetNumberOfContours() == 0)
  {
    vtkErrorMacro("There is no contour value. Call SetValue(0, value).");
    return false;
  }
  for (int i = 0; i < this->GetNumberOfContours(); ++i)
  {
    if (!std::isfinite(this->GetValue(i)))
    {
      vtkErrorMacro("Contour value " << i << " is not finite.");
      return false;
    }
  }
  return true;
}

int vtkMicroMeshContourFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (!this->Current || !this->Current->IsContinued)
  {
    this->Current = std::make_unique<Work>();
  }
  this->Current->IsContinued = false;
  if (!input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), HasPiece(outputVector) ? 0 : 1);
    input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), HasPiece(outputVector) ? 1 : 2);
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    return 1;
  }
  Work& work = *this->Current;
  relevo::ImageExtent extent{};
  input->Get(Pipeline::WHOLE_EXTENT(), extent.data());
  if (work.Next == 0)
  {
    work.Whole = extent;
    work.Extents = relevo::DivideExtent(extent, this->BlockSize);
    work.SetNumberOfBlocks(work.Extents.size());
    work.IsStreaming =
      input->Has(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT()) && work.Extents.size() > 1;
  }
  if (work.IsStreaming && !work.IsDone())
  {
    extent = relevo::GrowExtent(
      work.Extents[work.Queue[work.Next]], work.Whole, this->ComputeGradients ? 1 : 0);
    input->Set(Pipeline::EXACT_EXTENT(), 1);
  }
  input->Set(Pipeline::UPDATE_EXTENT(), extent.data(), 6);
  return 1;
}

bool vtkMicroMeshContourFilter::FindScalarsName(vtkInformationVector** inputVector)
{
  vtkInformation* wanted = this->GetInputArrayInformation(0);
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->GetInputArrayToProcess(0, inputVector, association);
  Work& work = *this->Current;
  if (array && association == vtkDataObject::FIELD_ASSOCIATION_POINTS && array->GetName())
  {
    work.Settings.Scalars = array->GetName();
    return true;
  }
  if (wanted && wanted->Has(vtkDataObject::FIELD_NAME()))
  {
    work.Settings.Scalars = wanted->Get(vtkDataObject::FIELD_NAME());
    return true; // described later
  }
  this->Fail("The input has no point scalars with a name. Call SetInputArrayToProcess().");
  return false;
}

void vtkMicroMeshContourFilter::Fail(const std::string& error)
{
  vtkErrorMacro(<< error);
  this->Current->HasFailed = true;
}

int vtkMicroMeshContourFilter::EncodeBlock(vtkPolyData* surface)
{
  Work& work = *this->Current;
  const std::size_t index = work.Queue[work.Next];
  Work::Block& block = work.Blocks[index];
  work.Borders.Keep(surface);
  block.Triangles = surface->GetNumberOfPolys();
  if (block.Triangles > 0 && !this->EncodeSurface(surface, block.Result, block.Error))
  {
    return 0;
  }
  ++work.Next;
  this->Report(0.0);
  if (block.Result)
  {
    work.Borders.Take(index, surface, block.Result);
  }
  if (work.IsDone() && !work.HasFailed)
  {
    const std::vector<std::size_t> unmatched = work.Borders.FindUnmatched();
    work.Queue.insert(work.Queue.end(), unmatched.begin(), unmatched.end());
  }
  return 1;
}

// Reports progress with a share of the next block. It does not go back when blocks come again.
void vtkMicroMeshContourFilter::Report(double share)
{
  Work& work = *this->Current;
  work.Progress =
    std::max(work.Progress, (double(work.Next) + share) / double(work.Queue.size() + 1));
  this->UpdateProgress(work.Progress);
  work.HasFailed = work.HasFailed || relevo::IsAborted(this);
}

bool vtkMicroMeshContourFilter::EncodeSurface(
  vtkPolyData* surface, vtkSmartPointer<vtkPolyData>& result, double& error)
{
  vtkNew<vtkMicroMeshFilter> encode;
  encode->SetInputData(surface);
  encode->SetTolerance(this->Tolerance);
  encode->SetTargetReduction(this->TargetReduction);
  encode->SetMaximumLevel(this->MaximumLevel);
  encode->SetFeatureAngle(180.0);
  encode->SetFixedPointArrayName(relevo::FixedPointsName);
  std::string errors;
  std::string warnings; // triangles without area are usual in isosurfaces
  encode->AddObserver(vtkCommand::ErrorEvent, relevo::NewErrorCollector(errors));
  encode->AddObserver(vtkCommand::WarningEvent, relevo::NewErrorCollector(warnings));
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(this);
  progress->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto filter = static_cast<vtkMicroMeshContourFilter*>(data);
      auto encode = static_cast<vtkAlgorithm*>(caller);
      filter->Report(encode->GetProgress());
      encode->SetAbortExecute(relevo::IsAborted(filter) ? 1 : 0);
    });
  encode->AddObserver(vtkCommand::ProgressEvent, progress);
  encode->Update();
  if (!errors.empty())
  {
    this->Fail(errors);
    return false;
  }
  result = encode->GetOutput();
  error = encode->GetError();
  return true;
}

// Joins the micro-meshes of all blocks.
bool vtkMicroMeshContourFilter::Finish(vtkPolyData* output)
{
  Work& work = *this->Current;
  relevo::MicroMeshAppender joined;
  for (Work::Block& block : work.Blocks)
  {
    std::string error;
    if (block.Result && !joined.Append(block.Result, error))
    {
      this->Fail(error);
      return false;
    }
    block.Result = nullptr;
    this->Error = std::max(this->Error, block.Error);
    this->NumberOfTriangles += block.Triangles;
  }
  this->NumberOfBlocks = static_cast<int>(work.Blocks.size());
  joined.Finish(output);
  if (output->GetNumberOfPolys() > 0)
  {
    relevo::StoreInputBounds(work.Bounds.data(), output);
  }
  return true;
}

int vtkMicroMeshContourFilter::ContourImage(vtkImageData* image, bool isWhole)
{
  Work& work = *this->Current;
  do
  {
    if (work.IsDone())
    {
      return 1;
    }
    std::string error;
    const vtkSmartPointer<vtkPolyData> surface = relevo::ContourImageBlock(
      image, work.Extents[work.Queue[work.Next]], work.Whole, work.Settings, error);
    if (!surface)
    {
      this->Fail(error);
      return 0;
    }
    if (this->EncodeBlock(surface) == 0)
    {
      return 0;
    }
  } while (isWhole && !work.HasFailed);
  return 1;
}

int vtkMicroMeshContourFilter::ContourGrid(vtkUnstructuredGrid* grid)
{
  Work& work = *this->Current;
  if (this->ComputeGradients)
  {
    vtkWarningMacro("ComputeGradients works for images only. Use vtkGradientFilter for grids.");
  }
  relevo::GridBlocks blocks;
  std::string error;
  const vtkIdType mostCells = vtkIdType(4) * this->BlockSize * this->BlockSize;
  if (!blocks.Find(grid, work.Settings, mostCells, error))
  {
    this->Fail(error);
    return 0;
  }
  work.SetNumberOfBlocks(static_cast<std::size_t>(blocks.GetNumberOfBlocks()));
  while (!work.IsDone() && !work.HasFailed)
  {
    const auto surface =
      blocks.Contour(grid, static_cast<int>(work.Queue[work.Next]), work.Settings);
    if (this->EncodeBlock(surface) == 0)
    {
      return 0;
    }
  }
  return 1;
}

int vtkMicroMeshContourFilter::RunStep(vtkInformation* request, vtkInformationVector** inputVector)
{
  Work& work = *this->Current;
  if (work.Next == 0)
  {
    this->Error = 0.0;
    this->NumberOfTriangles = 0;
    this->NumberOfBlocks = 0;
  }
  auto data = vtkDataSet::GetData(inputVector[0]);
  if (data->GetNumberOfPoints() == 0 || !this->FindScalarsName(inputVector))
  {
    return work.HasFailed ? 0 : 1;
  }
  work.Settings.Values.assign(this->ContourValues->GetValues(),
    this->ContourValues->GetValues() + this->GetNumberOfContours());
  work.Settings.Attributes = this->Attributes;
  work.Settings.Gradients = this->ComputeGradients;
  work.Settings.ContourValues = this->ComputeScalars;
  if (auto grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    grid->GetBounds(work.Bounds.data());
    return this->ContourGrid(grid);
  }
  auto image = vtkImageData::SafeDownCast(data);
  vtkNew<vtkImageData> whole;
  whole->CopyStructure(image);
  whole->SetExtent(work.Whole.data());
  whole->GetBounds(work.Bounds.data());
  if (this->ContourImage(image, !work.IsStreaming) == 0)
  {
    return 0;
  }
  if (work.IsStreaming && !work.IsDone() && !work.HasFailed)
  {
    request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
    work.IsContinued = true;
  }
  return 1;
}

int vtkMicroMeshContourFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  request->Remove(Pipeline::CONTINUE_EXECUTING());
  int result = 0;
  if (!HasPiece(outputVector))
  {
    result = 1;
  }
  else if (relevo::CheckInputTypes(this, inputVector) && this->CheckSettings())
  {
    result = relevo::RequestWithinMemory(this, outputVector, "the micro-mesh",
      [&]
      {
        const int step = this->RunStep(request, inputVector);
        if (step != 0 && !this->Current->HasFailed && !request->Has(Pipeline::CONTINUE_EXECUTING()))
        {
          return this->Finish(vtkPolyData::GetData(outputVector)) ? 1 : 0;
        }
        return step;
      });
  }
  if (!request->Has(Pipeline::CONTINUE_EXECUTING()))
  {
    this->Current = nullptr;
  }
  return result;
}

void vtkMicroMeshContourFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "TargetReduction: " << this->TargetReduction << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "BlockSize: " << this->BlockSize << "\n";
  os << indent << "Attributes: " << (this->Attributes ? "on" : "off") << "\n";
  os << indent << "ComputeScalars: " << (this->ComputeScalars ? "on" : "off") << "\n";
  os << indent << "ComputeGradients: " << (this->ComputeGradients ? "on" : "off") << "\n";
  os << indent << "Error: " << this->Error << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "NumberOfBlocks: " << this->NumberOfBlocks << "\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}
