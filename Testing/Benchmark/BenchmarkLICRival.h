// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkLICRival
 * @brief   the surface LIC of ParaView's VTK, drawn by a separate program
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

/// The names are those of both mappers.
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
  /// For a mesh with the vectors FlowScene::VectorsName, in a window of this size. Without noise,
  /// VTK's default noise is used.
  BenchmarkLICRival(const BenchmarkOptions& options, vtkPolyData* mesh, int width, int height,
    vtkImageData* noise, const LICSettings& settings);
  ~BenchmarkLICRival();

  /// Empty if the program does not run. Times are then NaN, and pictures empty.
  const std::string& GetRenderer() const { return this->Renderer; }

  void SetCamera(vtkCamera* camera);
  LICFrame Draw(bool hasLIC);

  /// The picture of the last frame as RGB bytes.
  std::vector<unsigned char> GetPicture();

private:
  std::filesystem::path Folder; // contains files for the program
  std::unique_ptr<BenchmarkRival> Program;
  std::string Renderer;
};

#endif
