// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICParallelFrame
 * @brief   the streaks of an image that several processes draw together
 *
 * All processes take part in each exchange, including those that show nothing or have failed.
 * Private to the module's own sources.
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
  /// Return whether there are other processes.
  bool IsUsed() const;

  /// The contribution of this process to the frame.
  struct Contribution
  {
    LICScreen* Screen = nullptr; // nullptr without streaks
    bool IsChanged = false;
    std::vector<float> Vectors;
    std::string Error;
  };

  /// The steps of a mapper in a frame, in this order.
  struct Steps
  {
    /// Find the screen, unless the mapper shows no streaks.
    std::function<void(Contribution&)> Prepare;
    /// Draw the screen's vectors and read them back.
    std::function<void(Contribution&)> DrawVectors;
    /// Compute the screen's image; return an error, or "".
    std::function<std::string(LICScreen&, bool convolve, const LICImage::RangeMerger&)> DrawImage;
    /// Return how often DrawImage() merges ranges, and the number of pixels that it needs around
    /// the visible region.
    std::function<int(bool convolve)> CountRanges;
    std::function<int()> FindReach;
    /// Mark the screen as up to date after drawing.
    std::function<void(LICScreen&)> Finish;
    bool StretchesColors;
  };

  /**
   * Draw the LIC of the vectors of all processes into this process's screen, unless nothing has
   * changed. The facts of the other processes are set in `field`. Return the error as a sentence,
   * or "".
   */
  std::string Run(vtkRenderer* ren, vtkActor* act, LICVectorField& field, const Steps& steps);

  /// Forget the screen after all screens have been removed.
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
