// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightMap.h"

#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Heights/HeightGrid.h"
#include "Heights/HeightReduction.h"
#include "Mesh/PointBlanking.h"
#include "Raster/RasterFile.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
// Large enough for efficient reads, small compared with the heights.
constexpr long long SamplesPerRead = 1 << 20;

int rowsPerRead(const relevo::RasterDescription& contents)
{
  const long long width = static_cast<long long>(contents.Width) * contents.SamplesPerTexel;
  const long long rows = std::max(1LL, SamplesPerRead / width);
  const long long blocks = std::max(1LL, rows / contents.RowsPerBlock);
  return static_cast<int>(std::min<long long>(blocks * contents.RowsPerBlock, contents.Height));
}

const char* const NothingToRead = "There is neither a file name nor an image to read heights from: "
                                  "call SetFileName() or SetImageData().";

std::string cannotRead(const std::string& fileName, const std::string& error)
{
  return "Cannot read " + fileName + ": " + error + ".";
}

std::string toText(const int size[2])
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]);
}

// Compares no-data values, where two NaNs are equal.
bool differ(double a, double b)
{
  return !(a == b || (std::isnan(a) && std::isnan(b)));
}
}

vtkStandardNewMacro(vtkHeightMap);

vtkHeightMap::vtkHeightMap()
  : FileName(nullptr)
  , FlipRows(false)
  , NoDataValue(std::numeric_limits<double>::quiet_NaN())
  , NoDataValueSet(false)
  , DeclaredNoDataValue(std::numeric_limits<double>::quiet_NaN())
  , MaximumDimension(16384)
  , AbortExecute(false)
  , Dimensions{ 0, 0 }
  , FullDimensions{ 0, 0 }
  , Range{ 0.0, 0.0 }
{
}

vtkHeightMap::~vtkHeightMap()
{
  this->SetFileName(nullptr);
}

vtkCxxSetSmartPointerMacro(vtkHeightMap, ImageData, vtkImageData);

vtkImageData* vtkHeightMap::GetImageData()
{
  return this->ImageData;
}

void vtkHeightMap::SetNoDataValue(double value)
{
  if (!this->NoDataValueSet || differ(this->NoDataValue, value))
  {
    this->NoDataValue = value;
    this->NoDataValueSet = true;
    this->Modified();
  }
}

double vtkHeightMap::GetNoDataValue()
{
  return this->NoDataValueSet ? this->NoDataValue : this->DeclaredNoDataValue;
}

void vtkHeightMap::UnsetNoDataValue()
{
  if (this->NoDataValueSet)
  {
    this->NoDataValueSet = false;
    this->Modified();
  }
}

void vtkHeightMap::SetMaximumDimension(int dimension)
{
  relevo::SetInRange(this, "MaximumDimension", this->MaximumDimension, dimension, 0, VTK_INT_MAX);
}

vtkMTimeType vtkHeightMap::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImageData ? std::max(own, this->ImageData->GetMTime()) : own;
}

bool vtkHeightMap::Update()
{
  const std::lock_guard<std::recursive_mutex> lock(this->UpdateMutex);
  // The file can be open without having been read if an earlier attempt failed to open it.
  if (this->UpdateTime < this->GetMTime() || this->Raster)
  {
    this->AbortExecute = false;
    this->ErrorMessage.clear();
    this->WarningMessage.clear();
    this->Clear();
    if (!this->Open() || !this->Read())
    {
      std::fill_n(this->FullDimensions, 2, 0);
    }
    if (this->AbortExecute && !this->Grid)
    {
      this->ErrorMessage.clear();
      this->Description.reset();
      return false; // the next Update() tries again
    }
    this->UpdateTime.Modified();
    if (!this->WarningMessage.empty())
    {
      vtkWarningMacro(<< this->WarningMessage);
    }
  }
  if (!this->Grid)
  {
    vtkErrorMacro(<< this->ErrorMessage);
  }
  return this->Grid != nullptr;
}

void vtkHeightMap::ReleaseHeights()
{
  const std::lock_guard<std::recursive_mutex> lock(this->UpdateMutex);
  this->Clear();
  this->Description.reset(); // so that Update() opens the file again
  this->UpdateTime = vtkTimeStamp();
}

bool vtkHeightMap::UpdateInformation()
{
  const std::lock_guard<std::recursive_mutex> lock(this->UpdateMutex);
  if (!this->Open())
  {
    vtkErrorMacro(<< this->ErrorMessage);
    return false;
  }
  return true;
}

bool vtkHeightMap::Open()
{
  if (!this->Description || this->DescriptionTime.GetMTime() < this->GetMTime())
  {
    this->Raster.reset();
    this->Description.reset();
    if (this->ImageData)
    {
      this->Description = std::make_unique<relevo::RasterDescription>();
      const int* dimensions = this->ImageData->GetDimensions();
      this->Description->Width = dimensions[0];
      this->Description->Height = dimensions[1];
      this->Description->Location.SetSize(dimensions[0], dimensions[1]);
    }
    else if (this->FileName && *this->FileName)
    {
      std::string error;
      this->Raster = relevo::OpenRaster(this->FileName, error);
      if (!this->Raster)
      {
        this->ErrorMessage = cannotRead(this->FileName, error);
        return false;
      }
      this->Description = std::make_unique<relevo::RasterDescription>(this->Raster->Describe());
    }
    else
    {
      this->ErrorMessage = NothingToRead;
      return false;
    }
    this->ErrorMessage.clear();
    this->DescriptionTime.Modified();
  }
  this->FullDimensions[0] = this->Description->Width;
  this->FullDimensions[1] = this->Description->Height;
  return true;
}

void vtkHeightMap::Clear()
{
  this->Grid.reset();
  this->DeclaredNoDataValue = std::numeric_limits<double>::quiet_NaN();
  std::fill_n(this->Dimensions, 2, 0);
  std::fill_n(this->FullDimensions, 2, 0);
  std::fill_n(this->Range, 2, 0.0);
  this->SamplesTime.Modified();
}

bool vtkHeightMap::Read()
{
  auto grid = std::make_unique<relevo::HeightGrid>();
  std::string error;
  bool isRead = false;
  const auto read = [&]
  { isRead = this->ImageData ? this->ReadImage(*grid, error) : this->ReadFile(*grid, error); };
  if (!relevo::FitsMemory(read))
  {
    error = "not enough memory for " + toText(this->FullDimensions) + " heights";
  }
  this->Raster.reset();
  if (!isRead)
  {
    this->ErrorMessage = this->ImageData ? "The image cannot be a height map: " + error + "."
                                         : cannotRead(this->FileName, error);
    return false;
  }
  this->Dimensions[0] = grid->GetWidth();
  this->Dimensions[1] = grid->GetHeight();
  std::copy_n(grid->GetRange(), 2, this->Range);
  this->Grid = std::move(grid);
  if (!std::equal(this->Dimensions, this->Dimensions + 2, this->FullDimensions))
  {
    this->WarningMessage = std::string(this->ImageData ? "The image" : this->FileName) + " has " +
      toText(this->FullDimensions) + " heights, but the limit is " +
      std::to_string(this->MaximumDimension) + " per side: it is reduced to " +
      toText(this->Dimensions) +
      " means. For full detail, crop it (gdal_translate -srcwin), or raise MaximumDimension if "
      "textures may be that large.";
  }
  return true;
}

bool vtkHeightMap::ReadFile(relevo::HeightGrid& grid, std::string& error)
{
  relevo::Raster& raster = *this->Raster;
  const relevo::RasterDescription& contents = raster.Describe(); // of the selected level
  int size[2];
  relevo::GetReducedSize(this->FullDimensions, this->MaximumDimension, size);
  if (!std::equal(size, size + 2, this->FullDimensions))
  {
    raster.SelectLevel(size[0], size[1]);
  }
  const int source[2] = { contents.Width, contents.Height };
  relevo::HeightGrid::SampleEncoding encoding;
  if (contents.NoData)
  {
    this->DeclaredNoDataValue = *contents.NoData;
    encoding.NoData.push_back(*contents.NoData);
  }
  if (this->NoDataValueSet)
  {
    encoding.NoData.push_back(this->NoDataValue);
  }
  encoding.HasMask = contents.HasMask;
  encoding.Scale = contents.Scale;
  encoding.Offset = contents.Offset;
  encoding.FlipColumns = contents.Location.FlipColumns;
  encoding.FlipRows = contents.Location.FlipRows;
  if (!grid.Allocate(source, size, encoding, error))
  {
    return false;
  }

  const int rows = rowsPerRead(contents);
  const std::size_t samplesPerRead = static_cast<std::size_t>(rows) * contents.Width;
  const std::unique_ptr<char[]> samples(
    new (std::nothrow) char[samplesPerRead * vtkDataArray::GetDataTypeSize(contents.Type)]);
  std::unique_ptr<unsigned char[]> mask(
    contents.HasMask ? new (std::nothrow) unsigned char[samplesPerRead] : nullptr);
  if (!samples || (contents.HasMask && !mask))
  {
    error = "not enough memory for " + std::to_string(rows) + " rows of " +
      std::to_string(contents.Width) + " heights";
    return false;
  }
  for (int first = 0; first < contents.Height; first += rows)
  {
    const int count = std::min(rows, contents.Height - first);
    if (!raster.ReadRows(first, count, samples.get(), error) ||
      (mask && !raster.ReadMask(first, count, mask.get(), error)))
    {
      return false;
    }
    grid.SetRows(first, count, contents.Type, samples.get(), 1, mask.get());
    double progress = static_cast<double>(first + count) / contents.Height;
    this->InvokeEvent(vtkCommand::ProgressEvent, &progress);
    if (this->AbortExecute)
    {
      return false;
    }
  }
  if (grid.Finish(error))
  {
    return true;
  }
  if (!std::equal(source, source + 2, this->FullDimensions))
  {
    error = "in its overview of " + toText(source) + ", " + error;
  }
  return false;
}

bool vtkHeightMap::ReadImage(relevo::HeightGrid& grid, std::string& error)
{
  int dimensions[3];
  this->ImageData->GetDimensions(dimensions);
  vtkDataArray* scalars = this->ImageData->GetPointData()->GetScalars();
  if (dimensions[0] < 1 || dimensions[1] < 1 || dimensions[2] != 1)
  {
    error = "it has " + std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) +
      " x " + std::to_string(dimensions[2]) + " points, but n x m x 1 are needed";
    return false;
  }
  const vtkIdType size = static_cast<vtkIdType>(dimensions[0]) * dimensions[1];
  if (!scalars || scalars->GetNumberOfComponents() < 1)
  {
    error = "it has no numeric point scalars";
    return false;
  }
  if (scalars->GetNumberOfTuples() != size || scalars->GetDataType() == VTK_BIT)
  {
    error = std::string("its point scalars must be numbers, one tuple for each of ") +
      std::to_string(size) + " points, but there are " +
      std::to_string(scalars->GetNumberOfTuples()) + " tuples of type " +
      scalars->GetDataTypeAsString();
    return false;
  }
  vtkSmartPointer<vtkDataArray> samples = scalars;
  if (!scalars->HasStandardMemoryLayout())
  {
    samples.TakeReference(vtkDataArray::CreateDataArray(scalars->GetDataType()));
    samples->DeepCopy(scalars);
  }

  relevo::HeightGrid::SampleEncoding encoding;
  if (this->NoDataValueSet)
  {
    encoding.NoData.push_back(this->NoDataValue);
  }
  std::vector<unsigned char> mask;
  const relevo::PointBlanking blanking(this->ImageData);
  if (blanking.HidesAny())
  {
    mask.resize(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      mask[i] = !blanking.IsHidden(i);
    }
  }
  encoding.HasMask = !mask.empty();
  encoding.FlipRows = this->FlipRows;
  int reduced[2];
  relevo::GetReducedSize(dimensions, this->MaximumDimension, reduced);
  if (!grid.Allocate(dimensions, reduced, encoding, error))
  {
    return false;
  }
  grid.SetRows(0, dimensions[1], samples->GetDataType(), samples->GetVoidPointer(0),
    samples->GetNumberOfComponents(), mask.empty() ? nullptr : mask.data());
  return grid.Finish(error);
}

void vtkHeightMap::GetDimensions(int dimensions[2])
{
  std::copy_n(this->Dimensions, 2, dimensions);
}

int* vtkHeightMap::GetDimensions()
{
  return this->Dimensions;
}

void vtkHeightMap::GetFullDimensions(int dimensions[2])
{
  std::copy_n(this->FullDimensions, 2, dimensions);
}

int* vtkHeightMap::GetFullDimensions()
{
  return this->FullDimensions;
}

void vtkHeightMap::GetRange(double range[2])
{
  std::copy_n(this->Range, 2, range);
}

double* vtkHeightMap::GetRange()
{
  return this->Range;
}

double vtkHeightMap::GetSample(int column, int row)
{
  const bool inside = this->Update() && column >= 0 && column < this->Dimensions[0] && row >= 0 &&
    row < this->Dimensions[1];
  return inside
    ? this->Grid->GetSamples()[static_cast<std::size_t>(row) * this->Dimensions[0] + column]
    : 0.0;
}

bool vtkHeightMap::HasNoData()
{
  return this->GetValidity() != nullptr;
}

vtkMTimeType vtkHeightMap::GetSamplesMTime()
{
  return this->SamplesTime.GetMTime();
}

vtkIdType vtkHeightMap::GetNumberOfSamples()
{
  return this->Grid ? static_cast<vtkIdType>(this->Dimensions[0]) * this->Dimensions[1] : 0;
}

const float* vtkHeightMap::GetSamples()
{
  return this->Grid ? this->Grid->GetSamples() : nullptr;
}

const unsigned char* vtkHeightMap::GetValidity()
{
  return this->Grid ? this->Grid->GetValidity() : nullptr;
}

std::shared_ptr<const unsigned char> vtkHeightMap::ShareValidity()
{
  return { this->Grid, this->GetValidity() };
}

void vtkHeightMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ImageData: " << this->ImageData.Get() << "\n";
  os << indent << "FlipRows: " << this->FlipRows << "\n";
  os << indent << "NoDataValue: " << this->GetNoDataValue() << "\n";
  os << indent << "MaximumDimension: " << this->MaximumDimension << "\n";
  os << indent << "Dimensions: " << toText(this->Dimensions) << "\n";
  os << indent << "FullDimensions: " << toText(this->FullDimensions) << "\n";
  os << indent << "Range: " << this->Range[0] << ", " << this->Range[1] << "\n";
  os << indent << "HasNoData: " << this->HasNoData() << "\n";
}
