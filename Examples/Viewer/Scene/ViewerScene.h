// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScene
 * @brief   something to look at, its light and the view of it
 */
#ifndef ViewerScene_h
#define ViewerScene_h

#include "Options/ViewerOptions.h"
#include "Scene/ViewerView.h"
#include "Text/ViewerMessages.h"

#include "vtkNew.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class ViewerCamera;
class ViewerLegend;
class vtkPoints;
class vtkRenderer;
class vtkRenderWindow;
class vtkScalarsToColors;

class ViewerScene
{
public:
  virtual ~ViewerScene();

  vtkRenderer* GetRenderer() { return this->Renderer; }

  /// The unit of lengths, "m" or "".
  virtual std::string GetUnit() { return ""; }

  /// Where a point of a surface is and what is there, in lines; lengths as exact as the
  /// resolution. "" where there are no surfaces.
  virtual std::string Describe(const double point[3], double resolution) = 0;

  /// What a key of the window has changed, "" for nothing.
  virtual std::string Change(char) { return ""; }

  /// Writes the refined mesh as it is seen, where there is one; throws ViewerError.
  virtual void Export(const std::string&) {}

  /// What was found in the files, on stdout, where that was asked for.
  virtual void Report() {}

  /// The first frame, with its costs on stdout where the options ask for them; throws ViewerError.
  virtual void Draw(vtkRenderWindow* window) = 0;

protected:
  ViewerScene(const ViewerOptions& options, ViewerMessages& messages);

  /// The unit is "" where it is not known.
  void AddLegend(vtkScalarsToColors* table, const std::string& name, const std::string& unit,
    int numberOfLabels);
  /// Shows all points beside the legend, from the direction that the options give, else the
  /// default.
  void FitView(vtkPoints* points, const ViewerDirection& defaultDirection);
  /// Lamps for what has no vertical of its own, and all of its bounds, or what the options ask for.
  void SetView(const double bounds[6]);
  /// As near as the options ask for.
  void Zoom();
  /// Light from the direction that the options give, else the first of the lamps; the others keep
  /// their azimuths from it.
  void SetLights(std::vector<ViewerLamp> lamps);

  ViewerOptions Options; // and what a file decides where they say nothing
  ViewerMessages& Messages;
  vtkNew<vtkRenderer> Renderer;
  std::unique_ptr<ViewerCamera> Camera; // of the renderer

private:
  std::unique_ptr<ViewerLegend> Legend;
};

#endif
