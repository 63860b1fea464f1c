// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICParallelFrame
 * @brief   the streaks of a picture that several processes draw together
 *
 * All processes come to each exchange, whatever they have to show and whatever fails. Private to
 * the module's own sources.
 */
#ifndef LICParallelFrame_h
#define LICParallelFrame_h

#include "Passes/LICImage.h"
#include "Stages/LICVectorField.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkMultiProcessController;
class vtkRenderer;

namespace relevo
{
struct LICScreen;

class LICParallelFrame
{
public:
  LICParallelFrame();
  ~LICParallelFrame();

  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  /// Whether there are other processes.
  bool IsUsed() const;

  /// The contribution of this process to the frame.
  struct Contribution
  {
    LICScreen* Screen = nullptr; // if there are to be streaks
    bool IsChanged = false;
    std::vector<float> Vectors;
    std::string Error;
  };

  /// The steps of a mapper in a frame, in this order.
  struct Steps
  {
    /// Find the screen, unless the mapper shows no streaks.
    std::function<void(Contribution&)> Prepare;
    /// Draw the screen's vectors, and read them back.
    std::function<void(Contribution&)> DrawVectors;
    /// Make the screen's image; an error, or "".
    std::function<std::string(LICScreen&, bool convolve, const LICImage::RangeMerger&)> DrawImage;
    /// How often DrawImage() merges ranges, and how many pixels around what is seen it needs.
    std::function<int(bool convolve)> CountRanges;
    std::function<int()> FindReach;
    /// The screen has been drawn: its sources are those of now.
    std::function<void(LICScreen&)> Finish;
    bool StretchesColors;
  };

  /**
   * Draw the LIC of the vectors of all processes into this process's screen, unless nothing has
   * changed. `field` learns about the vectors of the others. Returns what is wrong, as a sentence;
   * or "".
   */
  std::string Run(vtkRenderer* ren, vtkActor* act, LICVectorField& field, const Steps& steps);

  /// All screens are gone.
  void ForgetScreen();

private:
  bool Agree(LICVectorField& field, const Steps& steps, bool didContribute, bool& changed);
  void Draw(const Steps& steps, bool changed);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::unique_ptr<Contribution> Local; // during Run()
  std::set<std::pair<vtkRenderer*, vtkActor*>> PreviousContributors;
};
}

#endif
