// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkLICContest
 * @brief   a mesh with vectors, drawn by vtkAdaptiveLICMapper and by VTK's surface LIC
 *
 * Neither refines, so both draw the same triangles. The actors are white and unlit, so the picture
 * shows the grey values of the LIC.
 */
#ifndef BenchmarkLICContest_h
#define BenchmarkLICContest_h

#include "BenchmarkLICRival.h"
#include "BenchmarkView.h"

#include "vtkSmartPointer.h"

#include <map>

class vtkActor;
class vtkAdaptiveRefinementMapper;
class vtkCamera;
struct FlowScene;

class BenchmarkLICContest
{
public:
  enum Policy
  {
    PLAIN,     // the refinement mapper, without LIC
    LIC,       // vtkAdaptiveLICMapper
    LIC_SHORT, // with one step in each direction
    VTK_PLAIN, // vtkPolyDataMapper
    VTK_LIC    // vtkSurfaceLICMapper
  };

  /// Without noise, each uses its default noise.
  BenchmarkLICContest(const BenchmarkOptions& options, const FlowScene& scene, vtkImageData* noise,
    const LICSettings& settings, const LICSettings& vtkSettings);
  ~BenchmarkLICContest();
  BenchmarkLICContest(const BenchmarkLICContest&) = delete;
  void operator=(const BenchmarkLICContest&) = delete;

  BenchmarkView& GetView() { return this->View; }
  BenchmarkLICRival& GetRival() { return this->Rival; }
  vtkCamera* GetCamera();

  /// Draws a frame from the view's camera.
  LICFrame Draw(Policy way);

private:
  void Add(Policy way, const FlowScene& scene, vtkSmartPointer<vtkAdaptiveRefinementMapper> mapper);

  BenchmarkView View;
  BenchmarkLICRival Rival;
  std::map<Policy, vtkSmartPointer<vtkActor>> Actors;
};

#endif
