// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScene
 * @brief   a scene with its lights and view
 */
#ifndef ViewerScene_h
#define ViewerScene_h

#include "Options/OptionCopy.h"
#include "Options/ViewerOptions.h"
#include "Scene/SceneContent.h"
#include "Scene/ViewerView.h"
#include "Text/ViewerMessages.h"

#include "vtkNew.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class PictureMarks;
class SceneCode;
class ViewerCamera;
class ViewerLegend;
class vtkPoints;
class vtkRenderer;
class vtkRenderWindow;
class vtkScalarsToColors;
struct FlightPosition;

class ViewerScene
{
public:
  virtual ~ViewerScene();

  vtkRenderer* GetRenderer() { return this->Renderer; }

  bool IsTerrain() const { return this->Options.IsTerrain(); }

  /// The unit of lengths, "m" or "".
  virtual std::string GetUnit() { return ""; }

  /// Position and values at a point of a surface, as lines of text. Lengths are rounded to the
  /// resolution. Empty if there are no surfaces.
  virtual std::string Describe(const double point[3], double resolution) = 0;

  /// The same for a pixel, from the lower left corner, of a scene without surfaces.
  virtual std::string DescribePixel(const int[2]) { return ""; }

  /// The visible point in a pixel, from the lower left corner, of a scene without surfaces. Returns
  /// false for the background.
  virtual bool FindPoint(const int[2], double[3]) { return false; }

  /// Shows the distance between two points in place of an earlier one. Returns the option that
  /// repeats it.
  std::string ShowRuler(const std::array<double, 3>& first, const std::array<double, 3>& second);
  void HideRuler();

  /// Looks at the whole scene along an axis, for the keys 1 to 6 of the window. Returns the option
  /// that repeats the view, or an empty string for other keys.
  std::string ShowPlanView(char key);

  /// Handles a key of the window. Returns a description of the change, or an empty string.
  virtual std::string Change(char) { return ""; }

  /// Like Change(), and stores changes that an option repeats.
  std::string ChangeByKey(char key);
  /// These options, with their values.
  const std::map<std::string, std::string>& GetChanges() const { return this->Changes; }

  /// Writes the visible refined mesh, if there is one. Throws ViewerError.
  virtual void Export(const std::string&) {}

  /// Adds the picture of the last frame to a program. Throws ViewerError if a program cannot draw
  /// it.
  void AddCode(SceneCode& code, const std::array<int, 2>& size);

  /// Prints information about the files on stdout if the options request it.
  virtual void Report() {}

  /// Draws the first frame, and prints statistics on stdout if the options request them. Throws
  /// ViewerError.
  virtual void Draw(vtkRenderWindow* window) = 0;

  /// Milliseconds until another frame of the same view would show more, or nothing.
  virtual std::optional<int> GetFrameDelay() { return std::nullopt; }

  /// Shows other values of the changed options without building the scene again. Returns false,
  /// without a change, if it must be built again. Throws ViewerError; the scene is then unchanged.
  bool Update(const ViewerOptions& options, const OptionNames& changed);

  /// Moves the camera to the view of the options.
  virtual void ResetView();

  /// Sets the width and height in pixels of the part of the window that the view fits into. This
  /// takes effect with the next ResetView(). Default: the size of the options.
  void SetViewSize(const std::array<int, 2>& size) { this->ViewSize = size; }

  //@{
  /// Azimuth and elevation in degrees of the first light, and of the camera as seen from its focal
  /// point. Nothing on a globe.
  std::optional<std::array<double, 2>> GetLight() const;
  std::optional<std::array<double, 2>> GetView();
  //@}

  /// The choices that the file offers.
  virtual SceneContent GetContent() { return {}; }

  /// Figures of the last frame. Builds are counted since the scene was made.
  virtual SceneFigures GetFigures() { return {}; }

  /// The patterns of the last frame, with the most segments first. Empty if the scene has none.
  /// This may read them back from the graphics card.
  virtual std::vector<PatternCount> GetPatternCounts() { return {}; }

  /// 0 if the file has no times.
  virtual int GetNumberOfTimeSteps() { return 0; }

  /// Reads and shows a step. Throws ViewerError.
  virtual void SetTimeStep(int) {}

  /// Warns of positions of a flight that are outside of the height map. Throws ViewerError if all
  /// are far away.
  virtual void CheckFlight(const std::vector<FlightPosition>&) {}

  /// Moves the camera of a height map to a position of a flight. Throws ViewerError.
  virtual void LookFrom(const FlightPosition&) {}

  /// Warns of pictures without terrain in a flight, and of pictures with a larger error than the
  /// options request. Throws ViewerError if no picture of a flight shows the terrain.
  virtual void CheckPictures() {}

protected:
  /// Adds the data that mappers and filters of the scene use to a program.
  virtual void AddDataCode(SceneCode& code) = 0;

  ViewerScene(const ViewerOptions& options, ViewerMessages& messages);

  /// The options that ApplyOptions() can change.
  virtual OptionNames GetUpdatedOptions();
  /// Shows the values of this->Options, of which some have changed. Returns false if the scene must
  /// be built again.
  virtual bool ApplyOptions(const OptionNames& changed);

  /// The unit is an empty string if unknown.
  void AddLegend(vtkScalarsToColors* table, const std::string& name, const std::string& unit,
    int numberOfLabels, const std::optional<double>& mark = {});
  /// Shows all points beside the legend, from the direction of the options or the default one.
  void FitView(vtkPoints* points, const ViewerDirection& defaultDirection);
  /// Sets the view of these bounds, with default lights or those of the options, for scenes without
  /// a vertical direction.
  void SetView(const double bounds[6]);
  /// Applies the zoom of the options.
  void Zoom();
  /// Adds lights. The first lamp takes the direction of the options, if given; the others keep
  /// their azimuths relative to it.
  void SetLights(std::vector<ViewerLamp> lamps);

  ViewerOptions Options; // including choices that a file makes if they are not set
  ViewerMessages& Messages;
  vtkNew<vtkRenderer> Renderer;
  std::unique_ptr<ViewerCamera> Camera; // moves the renderer's camera

private:
  std::unique_ptr<ViewerLegend> Legend;
  std::optional<std::array<double, 6>> ViewBounds; // of SetView()
  std::array<int, 2> ViewSize;
  int ViewAxis = 2;                    // upwards
  std::vector<ViewerLamp> Lamps;       // before the direction of the options is applied
  std::unique_ptr<PictureMarks> Ruler; // nullptr for none
  std::map<std::string, std::string> Changes;
};

#endif
