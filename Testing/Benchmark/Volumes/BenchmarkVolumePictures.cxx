// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkVolumePictures.h"

#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "BenchmarkVolumeReference.h"
#include "BenchmarkVolumeScene.h"
#include "BenchmarkVolumeWay.h"

#include "vtkVolumeRayCastFilter.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
constexpr int Nodes = 11;

struct Errors
{
  double Largest; // in units of 1/255
  double Quantile;
};

// Excludes the reference's silhouette.
Errors Compare(const std::vector<unsigned char>& picture, const VolumePicture& reference)
{
  std::vector<double> errors;
  for (size_t i = 0; i < reference.RGB.size(); ++i)
  {
    if (!reference.IsOutline[i / 3])
    {
      errors.push_back(std::abs(picture[i] - 255.0 * std::clamp(reference.RGB[i], 0.0, 1.0)));
    }
  }
  std::sort(errors.begin(), errors.end());
  return { errors.back(), errors[static_cast<size_t>(0.999 * (errors.size() - 1.0))] };
}

// A mesh in a view.
struct Shot
{
  Shot(const std::string& name, BenchmarkVolumeScene::Split split, int size)
    : View(size, size)
  {
    const BenchmarkVolumeScene scene(name);
    if (scene.IsEmpty())
    {
      return;
    }
    this->Mesh = scene.MakeMesh(split);
    this->Property = scene.MakeProperty(this->Mesh, Nodes);
    this->View.LookAt(this->Mesh->GetBounds());
    this->View.MoveCamera(20.0);
    // A black background avoids the rounding errors of blended bytes.
    this->SetBackground(0.0);
  }

  void SetBackground(double gray) { this->View.GetRenderer()->SetBackground(gray, gray, gray); }

  std::vector<unsigned char> Draw(VolumeWay way)
  {
    const auto volume = MakeVolume(way, this->Mesh, this->Property);
    this->View.GetRenderer()->AddViewProp(volume);
    this->View.TimeFrame();
    this->View.TimeFrame(); // the first frame of vtkProjectedTetrahedraMapper lacks cells
    std::vector<unsigned char> picture = this->View.GetPicture();
    this->View.GetRenderer()->RemoveViewProp(volume);
    return picture;
  }

  VolumePicture MakeReference()
  {
    vtkRenderer* renderer = this->View.GetRenderer();
    return MakeVolumeReference(this->Mesh, this->Property, renderer->GetActiveCamera(),
      this->View.GetWidth(), renderer->GetBackground());
  }

  // By the filter, in whose picture the background has alpha 0.
  VolumePicture MakeFiltered()
  {
    vtkRenderer* renderer = this->View.GetRenderer();
    const int size = this->View.GetWidth();
    vtkNew<vtkVolumeRayCastFilter> filter;
    filter->SetInputData(this->Mesh);
    filter->SetCamera(renderer->GetActiveCamera());
    filter->SetViewportSize(size, size);
    filter->SetVolumeProperty(this->Property);
    filter->Update();
    vtkDataArray* rgba = filter->GetOutput()->GetPointData()->GetScalars();
    VolumePicture picture;
    for (vtkIdType i = 0; i < rgba->GetNumberOfTuples(); ++i)
    {
      const double* color = rgba->GetTuple4(i);
      const double alpha = color[3];
      for (int k = 0; k < 3; ++k)
      {
        picture.RGB.push_back(color[k] + (1.0 - alpha) * renderer->GetBackground()[k]);
      }
      picture.IsOutline.push_back(alpha == 0.0);
    }
    return picture;
  }

  BenchmarkView View;
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  vtkSmartPointer<vtkVolumeProperty> Property;
};

void AddRow(BenchmarkTable& table, const std::string& scene, const Shot& shot,
  const std::string& picture, const Errors& errors, const char* asked)
{
  table.AddRow({ scene, static_cast<double>(shot.Mesh->GetNumberOfCells()), picture, errors.Largest,
    errors.Quantile, std::string(asked) });
}

void AddScene(const std::string& name, int size, BenchmarkTable& table)
{
  std::cerr << "volumes: pictures of " << name << std::endl;
  Shot shot(name, BenchmarkVolumeScene::FIVE, size);
  if (!shot.Mesh)
  {
    return;
  }
  shot.Draw(VolumeWay::Exact); // sets the camera of the pictures
  const VolumePicture reference = shot.MakeReference();
  for (const VolumeWay way : { VolumeWay::Exact, VolumeWay::PreIntegrated, VolumeWay::Projection,
         VolumeWay::VTKLinear, VolumeWay::VTKProjected })
  {
    AddRow(table, name, shot, GetName(way), Compare(shot.Draw(way), reference),
      way == VolumeWay::Exact ? "2, 1" : "");
  }
  shot.SetBackground(1.0);
  AddRow(table, name, shot, GetName(VolumeWay::Exact) + std::string(", over white"),
    Compare(shot.Draw(VolumeWay::Exact), shot.MakeReference()), "");
  const auto errors = RunInOwnProcess({ "volumes", "picture", name, std::to_string(size) });
  if (errors.size() == 2)
  {
    AddRow(table, name, shot, GetName(VolumeWay::VTKDefault), { errors[0], errors[1] }, "");
  }
  else
  {
    table.AddNote(std::string(GetName(VolumeWay::VTKDefault)) + " crashed for " + name + '.');
  }
  Shot unsplit(name, BenchmarkVolumeScene::UNSPLIT, size);
  const auto picture = unsplit.Draw(VolumeWay::Exact);
  AddRow(table, name, unsplit, "hexahedra unsplit, against vtkVolumeRayCastFilter",
    Compare(picture, unsplit.MakeFiltered()), "3");
}
}

std::vector<double> MeasureVolumePicture(const std::vector<std::string>& arguments)
{
  Shot shot(arguments.at(0), BenchmarkVolumeScene::FIVE, std::stoi(arguments.at(1)));
  const auto picture = shot.Draw(VolumeWay::VTKDefault);
  const Errors errors = Compare(picture, shot.MakeReference());
  return { errors.Largest, errors.Quantile };
}

void AddVolumePictures(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("volumes-pictures",
    "Pictures of volumes against a reference in double precision, errors of 255",
    { { "mesh", "mesh", 0 }, { "cells", "cells", 0 }, { "picture", "picture", 0 },
      { "largest", "largest error", 2 }, { "quantile", "99.9 %", 2 }, { "asked", "at most", 0 } });
  const int size = options.Quick ? 48 : 128;
  AddScene(options.Quick ? "bent 6" : "bent 20", size, table);
  if (!options.Quick)
  {
    AddScene("fin", size, table);
  }
  table.AddNote(std::to_string(size) + " x " + std::to_string(size) +
    " pixels over black, off the outline; bytes, so that 0.5 is rounding. The reference intersects "
    "the rays "
    "of pixels with tetrahedra by planes, and sums up 64 steps in each.");
  addTable(table);
}
