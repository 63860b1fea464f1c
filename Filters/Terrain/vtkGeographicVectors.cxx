// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeographicVectors.h"

#include "Arrays/ImageExtents.h"
#include "Arrays/VectorData.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/MisplacedArray.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Geodesy/MapDirectionsFactory.h"
#include "Raster/VectorRaster.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr double NoDataMagnitude = 1e8;
constexpr double LargestVectorExaggeration = VTK_FLOAT_MAX;
constexpr vtkIdType PointsAtOnce = 65536; // points between two checks of progress and abort
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

bool hasVectors(vtkDataArray* array)
{
  return array && (array->GetNumberOfComponents() == 2 || array->GetNumberOfComponents() == 3);
}

// The default array; nullptr for none.
vtkDataArray* findVectors(vtkPointData* data)
{
  if (hasVectors(data->GetVectors()))
  {
    return data->GetVectors();
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (hasVectors(array) && array != data->GetNormals() && array != data->GetTCoords())
    {
      return array;
    }
  }
  return nullptr;
}

// Sets each vector to the result of get(i, vector), or to NaN if it returns false.
template <typename Function>
void forPoints(vtkIdType numberOfPoints, Function&& get, vtkFloatArray* vectors)
{
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double vector[3] = { 0.0, 0.0, 0.0 };
        float tuple[3] = { NaN, NaN, NaN };
        if (get(i, vector))
        {
          std::copy_n(vector, 3, tuple);
        }
        vectors->SetTypedTuple(i, tuple);
      }
    });
}

// Copies east, north and up components of the mesh's array.
bool takeVectors(vtkPolyData* mesh, vtkDataArray* array, vtkFloatArray* vectors, std::string& error)
{
  if (array->GetNumberOfTuples() != mesh->GetNumberOfPoints())
  {
    error = "has " + std::to_string(array->GetNumberOfTuples()) + " tuples, but there are " +
      std::to_string(mesh->GetNumberOfPoints()) + " points";
    return false;
  }
  forPoints(
    mesh->GetNumberOfPoints(),
    [=](vtkIdType i, double* vector)
    {
      array->GetTuple(i, vector);
      return relevo::IsVectorData(vector, 3, NoDataMagnitude);
    },
    vectors);
  return true;
}

bool sampleVectors(vtkPolyData* mesh, vtkImageData* image, vtkDataArray* array,
  vtkFloatArray* vectors, std::string& error)
{
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  if (!coordinates || coordinates->GetNumberOfComponents() < 2 ||
    coordinates->GetNumberOfTuples() != mesh->GetNumberOfPoints())
  {
    error = "is sampled by texture coordinates, but the mesh has none";
    return false;
  }
  relevo::VectorRaster raster;
  if (!raster.SetImage(image, array, NoDataMagnitude, error))
  {
    error = "cannot be sampled: " + error;
    return false;
  }
  forPoints(
    mesh->GetNumberOfPoints(),
    [&](vtkIdType i, double* vector) {
      return raster.Sample(
        coordinates->GetComponent(i, 0), coordinates->GetComponent(i, 1), vector);
    },
    vectors);
  return true;
}

// Reads the location of the mesh from its field data, which vtkTerrainSource writes.
void takePlace(vtkPolyData* mesh, std::string& system, double origin[3])
{
  vtkFieldData* fields = mesh->GetFieldData();
  auto* name = vtkStringArray::SafeDownCast(fields->GetAbstractArray("CoordinateSystem"));
  vtkDataArray* place = fields->GetArray("Origin");
  if (name && name->GetNumberOfValues() == 1 && place && place->GetNumberOfTuples() == 1 &&
    place->GetNumberOfComponents() == 3)
  {
    system = name->GetValue(0);
    place->GetTuple(0, origin);
  }
}

// Rotates the direction to the axes and preserves the length.
void turn(const relevo::MapAxes& axes, float vector[3])
{
  const double x = vector[0] * axes.East[0] + vector[1] * axes.North[0];
  const double y = vector[0] * axes.East[1] + vector[1] * axes.North[1];
  const double length = std::hypot(x, y);
  if (!std::isfinite(length))
  {
    std::fill_n(vector, 3, NaN);
    return;
  }
  const double scale = length > 0.0 ? std::hypot(vector[0], vector[1]) / length : 0.0;
  vector[0] = static_cast<float>(scale * x);
  vector[1] = static_cast<float>(scale * y);
}
}

vtkStandardNewMacro(vtkGeographicVectors);

vtkGeographicVectors::vtkGeographicVectors()
  : Origin{ 0.0, 0.0, 0.0 }
  , Exaggeration(1.0)
{
  this->SetNumberOfInputPorts(2);
}

vtkGeographicVectors::~vtkGeographicVectors() = default;

vtkCxxSetSmartPointerMacro(vtkGeographicVectors, Terrain, vtkTerrainSource);

vtkTerrainSource* vtkGeographicVectors::GetTerrain()
{
  return this->Terrain;
}

void vtkGeographicVectors::SetCoordinateSystem(const char* definition)
{
  const std::string given = definition ? definition : "";
  if (this->CoordinateSystem != given)
  {
    this->CoordinateSystem = given;
    this->Modified();
  }
}

void vtkGeographicVectors::SetOrigin(double x, double y, double z)
{
  relevo::SetVector<3>(
    this, "Origin", this->Origin, { x, y, z }, -relevo::LargestDouble, relevo::LargestDouble);
}

void vtkGeographicVectors::SetExaggeration(double exaggeration)
{
  relevo::SetInRange(this, "Exaggeration", this->Exaggeration, exaggeration,
    -LargestVectorExaggeration, LargestVectorExaggeration);
}

void vtkGeographicVectors::SetOutputArrayName(const char* name)
{
  const std::string given = name ? name : "";
  if (this->OutputArrayName != given)
  {
    this->OutputArrayName = given;
    this->Modified();
  }
}

void vtkGeographicVectors::SetRasterData(vtkImageData* image)
{
  this->SetInputDataObject(1, image);
}

void vtkGeographicVectors::SetRasterConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

vtkMTimeType vtkGeographicVectors::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Terrain ? std::max(own, this->Terrain->GetMTime()) : own;
}

int vtkGeographicVectors::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkGeographicVectors::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  relevo::RequestWholeExtent(inputVector[1]->GetInformationObject(0)); // any part of the image may
                                                                       // be sampled
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkGeographicVectors::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return relevo::RequestWithinMemory(this, outputVector, "the vectors",
    [&] { return this->Convert(inputVector, vtkPolyData::GetData(outputVector, 0)); });
}

int vtkGeographicVectors::Convert(vtkInformationVector** inputVector, vtkPolyData* output)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkImageData* raster = vtkImageData::GetData(inputVector[1], 0);
  output->Initialize();
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }

  bool isOfRaster = raster != nullptr;
  vtkDataArray* array = this->ChooseArray(inputVector, isOfRaster);
  std::unique_ptr<relevo::MapDirections> directions;
  double exaggeration = 1.0;
  if (!array || !this->Locate(input, directions, exaggeration)) // the error has been reported
  {
    return 0;
  }
  const std::string inputName = array->GetName() ? array->GetName() : "Vectors";
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName(
    this->OutputArrayName.empty() ? inputName.c_str() : this->OutputArrayName.c_str());
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(input->GetNumberOfPoints());
  std::string error;
  if (!(isOfRaster ? sampleVectors(input, raster, array, vectors, error)
                   : takeVectors(input, array, vectors, error)))
  {
    vtkErrorMacro(<< "The array \"" << inputName << "\" " << error << ".");
    return 0;
  }
  if (this->Turn(input, directions.get(), exaggeration, vectors))
  {
    output->ShallowCopy(input);
    output->GetPointData()->AddArray(vectors);
    output->GetPointData()->SetActiveVectors(vectors->GetName());
    this->UpdateProgress(1.0);
  }
  return 1;
}

vtkDataArray* vtkGeographicVectors::ChooseArray(
  vtkInformationVector** inputVector, bool& isOfRaster)
{
  vtkInformation* choice = this->GetInputArrayInformation(0);
  if (!choice->Has(vtkAlgorithm::INPUT_PORT()))
  {
    vtkDataSet* data = vtkDataSet::GetData(inputVector[isOfRaster ? 1 : 0], 0);
    vtkDataArray* array = findVectors(data->GetPointData());
    if (!array)
    {
      vtkErrorMacro(<< "The " << (isOfRaster ? "image" : "mesh")
                    << " has no point array of 2 or 3 components (east, north and optionally up).");
    }
    return array;
  }

  const int port = choice->Get(vtkAlgorithm::INPUT_PORT());
  const char* place = port == 0 ? "mesh" : "image";
  if (port < 0 || port > 1 || !inputVector[port]->GetInformationObject(0))
  {
    vtkErrorMacro(<< "SetInputArrayToProcess() selects input " << port << ", which has no data.");
    return nullptr;
  }
  const std::string name =
    choice->Has(vtkDataObject::FIELD_NAME()) ? choice->Get(vtkDataObject::FIELD_NAME()) : "";
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->GetInputArrayToProcess(0, inputVector, association);
  if (!array || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    const std::string misplaced = relevo::DescribeMisplacedArray(
      vtkDataSet::GetData(inputVector[port], 0), name, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    vtkErrorMacro(<< "The " << place << " has "
                  << (misplaced.empty() ? "no point array of numbers named \"" + name + "\""
                                        : misplaced)
                  << ".");
    return nullptr;
  }
  if (!hasVectors(array))
  {
    vtkErrorMacro(<< "The array \"" << name << "\" of the " << place << " has "
                  << array->GetNumberOfComponents()
                  << " components, but 2 or 3 are needed (east, north and optionally up).");
    return nullptr;
  }
  isOfRaster = port == 1;
  return array;
}

bool vtkGeographicVectors::Locate(
  vtkPolyData* mesh, std::unique_ptr<relevo::MapDirections>& directions, double& exaggeration)
{
  std::string system = this->CoordinateSystem;
  double origin[3];
  this->GetOrigin(origin);
  exaggeration = this->Exaggeration;
  if (this->Terrain)
  {
    this->Terrain->Update();
    if (this->Terrain->GetOutput()->GetNumberOfPoints() == 0)
    {
      vtkErrorMacro("The terrain has no mesh; its own error gives the reason.");
      return false;
    }
    system = this->Terrain->GetCoordinateSystem();
    this->Terrain->GetOrigin(origin);
    exaggeration = this->Terrain->GetExaggeration();
  }
  else if (system.empty())
  {
    takePlace(mesh, system, origin);
  }
  std::string error;
  directions = relevo::NewMapDirections(system, { origin[0], origin[1] }, error);
  if (!error.empty())
  {
    vtkErrorMacro(<< "The coordinate system \"" << system << "\" cannot be used: " << error << ".");
    return false;
  }
  return true;
}

bool vtkGeographicVectors::Turn(vtkPolyData* mesh, const relevo::MapDirections* directions,
  double exaggeration, vtkFloatArray* vectors)
{
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  std::vector<relevo::MapPlace> places;
  std::vector<relevo::MapAxes> axes;
  for (vtkIdType first = 0; first < numberOfPoints; first += PointsAtOnce)
  {
    this->UpdateProgress(static_cast<double>(first) / static_cast<double>(numberOfPoints));
    if (relevo::IsAborted(this))
    {
      return false;
    }
    const vtkIdType count = std::min(PointsAtOnce, numberOfPoints - first);
    if (directions)
    {
      places.resize(count);
      for (vtkIdType i = 0; i < count; ++i)
      {
        double point[3];
        mesh->GetPoint(first + i, point);
        places[i] = { point[0], point[1] };
      }
      directions->Evaluate(places, axes);
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      float* vector = vectors->GetPointer(3 * (first + i));
      if (directions)
      {
        turn(axes[i], vector);
      }
      vector[2] *= static_cast<float>(exaggeration);
    }
  }
  return true;
}

void vtkGeographicVectors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Terrain: " << this->Terrain.Get() << "\n";
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "Origin: " << this->Origin[0] << ", " << this->Origin[1] << ", "
     << this->Origin[2] << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "OutputArrayName: " << this->OutputArrayName << "\n";
}
