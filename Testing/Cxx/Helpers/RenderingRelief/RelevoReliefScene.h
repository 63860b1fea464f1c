// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window that shows reliefs by vtkReliefMapper, and how it compares to rays through them.
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

// What a picture is like, pixel by pixel.
struct RelevoReliefComparison
{
  int NumberOfHits = 0;   // of the rays
  int NumberOfMisses = 0; // pixels that are hit only in the picture, or only by the ray
  int NumberOfWrong = 0;  // farther than the tolerance from the ray's hit
  int NumberFar = 0;      // depths that are wrong by more than the tolerance
  // Of those that both hit.
  double GetShareRight() const
  {
    return 1.0 - static_cast<double>(this->NumberOfWrong) / std::max(this->NumberOfHits, 1);
  }
  // 99.9 %, but for two pixels at an outline, which few hits may have.
  bool IsRight() const
  {
    return this->NumberOfMisses + this->NumberOfWrong <= std::max(this->NumberOfHits / 1000, 2);
  }
};

class RelevoReliefScene
{
public:
  // An oblique view of the surface, black behind, no multisamples.
  explicit RelevoReliefScene(vtkDataObject* reliefs, int width = 160, int height = 120);

  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }
  void ResetCamera();
  void LookStraight();

  // Draws. Depths row after row: 1 where there is nothing.
  std::vector<float> DrawDepths();

  // Draws and compares with the one relief that is there; what is farther away than a tolerance in
  // texels is wrong. Points that are not kept are no hits.
  RelevoReliefComparison Compare(
    vtkImageData* relief, double stretch = 8.0, double tolerance = 0.5,
    const std::function<bool(const RelevoReliefHit&)>& keeps = [](const RelevoReliefHit&)
    { return true; });

  // What rays through the pixels' centres meet first.
  std::vector<RelevoReliefHit> Cast(
    vtkImageData* relief, double stretch = 8.0,
    const std::function<bool(const RelevoReliefHit&)>& keeps = [](const RelevoReliefHit&)
    { return true; });

  // From the actor's coordinates to those of the view's cube.
  void GetToClip(double toClip[16]);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkReliefMapper> Mapper;
};

// Smooth hills, in texels; NaN in a hole in the middle and above a line.
double RelevoHills(int column, int row);
double RelevoHillsWithHoles(int column, int row);

// In parallel, a texel 0.1 wide and high, depths 0.1 for 1.
relevo::dmat4 RelevoSmallTexels();

#endif
