// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkLICRival
 * @brief   the surface LIC of ParaView's VTK, drawn by a program of its own
 */
#ifndef BenchmarkLICRival_h
#define BenchmarkLICRival_h

#include "BenchmarkRival.h"

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

class vtkCamera;
class vtkImageData;
class vtkPolyData;
struct BenchmarkOptions;

/// Under the names that both mappers have.
struct LICSettings
{
  int NumberOfSteps = 20;
  double StepSize = 1.0;
  int EnhancedLIC = 1;
  int EnhanceContrast = 0;
  int AntiAlias = 0;
};

struct LICFrame
{
  double Milliseconds = std::numeric_limits<double>::quiet_NaN();
  double Processor = std::numeric_limits<double>::quiet_NaN(); // milliseconds of all cores
};

class BenchmarkLICRival
{
public:
  /// Of a mesh with the vectors FlowScene::VectorsName, in a window of that size. Without noise its
  /// own noise.
  BenchmarkLICRival(const BenchmarkOptions& options, vtkPolyData* mesh, int width, int height,
    vtkImageData* noise, const LICSettings& settings);
  ~BenchmarkLICRival();

  /// Empty where it does not run; then times are NaN and pictures empty.
  const std::string& GetRenderer() const { return this->Renderer; }

  void SetCamera(vtkCamera* camera);
  LICFrame Draw(bool hasLIC);

  /// The picture of the last frame: RGB, bytes.
  std::vector<unsigned char> GetPicture();

private:
  std::filesystem::path Folder; // of files for the program
  std::unique_ptr<BenchmarkRival> Program;
  std::string Renderer;
};

#endif
