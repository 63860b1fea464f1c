// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   StudioComparison
 * @brief   a second view of a scene with other options beside the first, and their difference
 *
 * Both views share the camera. The difference is a third view. Pixels depend on the place in the
 * window: OpenGL rounds positions. For the comparison, the second view is therefore also drawn in
 * the place of the first one, before it.
 */
#ifndef StudioComparison_h
#define StudioComparison_h

#include "Drawing/PictureDifference.h"
#include "Drawing/StudioScene.h"

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <array>
#include <memory>
#include <string>

class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;

class StudioComparison
{
public:
  /// The method and the options of the second view.
  struct Request
  {
    std::string Method;  // empty: that of the first view
    std::string Options; // such as "max-level=2;metric=distance"; may be empty
    bool HasDifference = false;
    double Gain = 1.0; // of the difference

    bool operator==(const Request& other) const
    {
      return this->Method == other.Method && this->Options == other.Options &&
        this->HasDifference == other.HasDifference && this->Gain == other.Gain;
    }
    bool IsOn() const { return !this->Method.empty() || !this->Options.empty(); }
  };

  /// The first scene must outlive this object.
  StudioComparison(vtkRenderWindow* window, StudioScene& first, bool isComplete);
  ~StudioComparison();
  StudioComparison(const StudioComparison&) = delete;
  void operator=(const StudioComparison&) = delete;

  /// Shows or removes the second view. Throws UsageError or ViewerError without a change.
  void Apply(const Request& request);
  const Request& GetShown() const { return this->Shown; }

  /// See StudioScene::SetPanelWidth(), for both scenes.
  void SetPanelWidth(int width);
  /// Hides the second view and the difference, so that the first view has their room.
  void SetHidden(bool hidden);

  /// Reports errors of the last frame as ViewerError.
  void CheckFrame();
  /// Compares the last frame. Figures of the second view begin with "second-".
  SceneFigures MeasureFrame();

private:
  OptionValues FindValues(const Request& request) const;
  void SetColumns();
  void DrawInFirstPlace();
  void ShowDifference();
  void Measure();

  vtkRenderWindow* Window;
  StudioScene& First;
  bool IsComplete;
  std::unique_ptr<StudioScene> Second;
  Request Shown;
  bool IsHidden = false;
  // Of both scenes in the columns. They change when a scene is built again.
  std::array<vtkWeakPointer<vtkRenderer>, 2> Renderers;
  PictureDifference Difference;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkRenderer> Renderer; // of the difference
};

#endif
