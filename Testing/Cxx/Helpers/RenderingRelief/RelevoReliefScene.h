// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window that shows reliefs by vtkReliefMapper, compared with rays.
#ifndef RelevoReliefScene_h
#define RelevoReliefScene_h

#include "RelevoReliefRays.h"
#include "RelevoReliefs.h"
#include "RelevoScene.h"

#include "vtkActor.h"
#include "vtkReliefMapper.h"

#include <algorithm>
#include <functional>

#include <vector>

class vtkImageData;

// Result of a comparison, pixel by pixel.
struct RelevoReliefComparison
{
  int NumberOfHits = 0;   // pixels that the rays hit
  int NumberOfMisses = 0; // pixels that only the picture or only the ray hits
  int NumberOfWrong = 0;  // further than the tolerance from the ray's hit
  int NumberFar = 0;      // depths that differ by more than the tolerance
  // Share of the pixels that both hit.
  double GetShareRight() const
  {
    return 1.0 - static_cast<double>(this->NumberOfWrong) / std::max(this->NumberOfHits, 1);
  }
  // At least 99.9 %, but always allows two pixels at a silhouette.
  bool IsRight() const
  {
    return this->NumberOfMisses + this->NumberOfWrong <= std::max(this->NumberOfHits / 1000, 2);
  }
};

class RelevoReliefScene
{
public:
  // An oblique view of the surface on black, without multisampling.
  explicit RelevoReliefScene(vtkDataObject* reliefs, int width = 160, int height = 120);

  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }
  void ResetCamera();
  void LookStraight();

  // Draws. Returns depths row after row, 1 for the background.
  std::vector<float> DrawDepths();

  // Draws and compares with the only relief. Hits further away than a tolerance in texels are
  // wrong. Points for which `keeps` returns false are not hits.
  RelevoReliefComparison Compare(
    vtkImageData* relief, double stretch = 8.0, double tolerance = 0.5,
    const std::function<bool(const RelevoReliefHit&)>& keeps = [](const RelevoReliefHit&)
    { return true; });

  // First hits of rays through the pixels' centres.
  std::vector<RelevoReliefHit> Cast(
    vtkImageData* relief, double stretch = 8.0,
    const std::function<bool(const RelevoReliefHit&)>& keeps = [](const RelevoReliefHit&)
    { return true; });

  // The matrix from the actor's coordinates to clip coordinates.
  void GetToClip(double toClip[16]);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkReliefMapper> Mapper;
};

// Smooth hills in texel coordinates; NaN in a hole in the middle and above a line.
double RelevoHills(int column, int row);
double RelevoHillsWithHoles(int column, int row);

// Parallel projection with texels 0.1 wide and high, and 0.1 per unit of depth.
relevo::dmat4 RelevoSmallTexels();

#endif
