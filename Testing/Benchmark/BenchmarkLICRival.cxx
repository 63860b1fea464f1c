// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkLICRival.h"

#include "BenchmarkFlow.h"
#include "Benchmarks.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <iomanip>
#include <sstream>
#include <unistd.h> // for getpid

namespace fs = std::filesystem;

namespace
{
fs::path MakeFolder()
{
  static int number = 0;
  const fs::path folder = fs::temp_directory_path() /
    ("relevo-benchmark-" + std::to_string(getpid()) + '-' + std::to_string(number++));
  fs::create_directory(folder);
  return folder;
}
}

BenchmarkLICRival::BenchmarkLICRival(const BenchmarkOptions& options, vtkPolyData* mesh, int width,
  int height, vtkImageData* noise, const LICSettings& settings)
{
  if (options.ParaView.empty())
  {
    return;
  }
  this->Folder = MakeFolder();
  const std::string meshFile = (this->Folder / "mesh.vtp").string();
  vtkNew<vtkXMLPolyDataWriter> meshWriter;
  meshWriter->SetInputData(mesh);
  meshWriter->SetFileName(meshFile.c_str());
  meshWriter->Write();
  std::string noiseFile;
  if (noise)
  {
    noiseFile = (this->Folder / "noise.png").string();
    vtkNew<vtkPNGWriter> noiseWriter;
    noiseWriter->SetInputData(noise);
    noiseWriter->SetFileName(noiseFile.c_str());
    noiseWriter->Write();
  }
  this->Program.reset(new BenchmarkRival(
    { options.ParaView + "/bin/paraview-python", options.ProgramFolder + "/surface-lic.py",
      meshFile, FlowScene::VectorsName, std::to_string(width), std::to_string(height), noiseFile,
      "NumberOfSteps=" + std::to_string(settings.NumberOfSteps),
      "StepSize=" + std::to_string(settings.StepSize),
      "EnhancedLIC=" + std::to_string(settings.EnhancedLIC),
      "EnhanceContrast=" + std::to_string(settings.EnhanceContrast),
      "AntiAlias=" + std::to_string(settings.AntiAlias), "LICIntensity=1.0" }));
  this->Renderer = this->Program->Ask("renderer");
}

BenchmarkLICRival::~BenchmarkLICRival()
{
  this->Program.reset();
  if (!this->Folder.empty())
  {
    fs::remove_all(this->Folder);
  }
}

void BenchmarkLICRival::SetCamera(vtkCamera* camera)
{
  std::ostringstream line;
  line << std::setprecision(17) << "camera";
  for (const double* point :
    { camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp() })
  {
    line << ' ' << point[0] << ' ' << point[1] << ' ' << point[2];
  }
  line << ' ' << camera->GetParallelProjection() << ' ' << camera->GetParallelScale() << ' '
       << camera->GetViewAngle();
  if (this->Program)
  {
    this->Program->Ask(line.str());
  }
}

LICFrame BenchmarkLICRival::Draw(bool hasLIC)
{
  std::vector<double> times;
  if (this->Program)
  {
    times = this->Program->AskNumbers(hasLIC ? "frame lic" : "frame plain");
  }
  return times.size() == 2 ? LICFrame{ times[0], times[1] } : LICFrame();
}

std::vector<unsigned char> BenchmarkLICRival::GetPicture()
{
  const std::string fileName = (this->Folder / "picture.png").string();
  if (!this->Program || this->Program->Ask("picture " + fileName) != "ok")
  {
    return {};
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  return std::vector<unsigned char>(
    pixels, pixels + image->GetNumberOfPoints() * image->GetNumberOfScalarComponents());
}
