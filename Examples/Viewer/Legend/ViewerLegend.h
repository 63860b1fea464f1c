// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerLegend
 * @brief   explains the colours, in the upper left corner of a picture
 *
 * The legend is laid out again when the picture's size or the colours change. A long title is
 * wrapped, or set in smaller letters.
 */
#ifndef ViewerLegend_h
#define ViewerLegend_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class SceneCode;
class vtkActor2D;
class vtkObject;
class vtkPolyData;
class vtkProp;
class vtkRenderer;
class vtkScalarsToColors;
class vtkTextActor;
class vtkTextProperty;

class ViewerLegend
{
public:
  /// Labels are numbers of the table's range, or its annotations if it uses indexed lookup.
  /// The mark is labelled, too, and labels between the ends make room for it.
  ViewerLegend(vtkRenderer* renderer, vtkScalarsToColors* table, const std::string& title,
    int numberOfLabels, const std::optional<double>& mark);
  ~ViewerLegend();
  ViewerLegend(const ViewerLegend&) = delete;
  void operator=(const ViewerLegend&) = delete;

  /// Width and height in pixels of the corner that the legend covers in a picture of this size; 0
  /// if there is no room for it.
  std::array<int, 2> GetCorner(const int size[2]);

  /// Adds a prop of the legend, as in the last frame, to the program of a scene. The code must know
  /// the table. Returns false for other props.
  bool AddCode(SceneCode& code, vtkProp* prop) const;

private:
  struct Row // a label beside its position on the bar
  {
    double Position; // 0 to 1, upwards
    std::string Text;
  };
  void OnStart(vtkObject* caller, unsigned long event, void* data);
  void LayOut(const int size[2]);
  void SetTitle(const int size[2], int margin);
  int GetBarHeight(int available) const;
  std::vector<Row> GetRows(int barHeight);
  void AddMark(std::vector<Row>& rows, int barHeight);
  int GetWidth(vtkTextProperty* property, const std::string& text);
  void DrawGround(const int size[2]);
  void DrawBar(int left, int bottom, int height);
  void GetColor(double position, double color[3]);
  bool IsLogarithmic() const;
  /// Colours of values below and above the range, or nullptr if they are those of its ends.
  const double* GetBelowColor() const;
  const double* GetAboveColor() const;
  vtkSmartPointer<vtkTextActor> AddText();

  vtkRenderer* Renderer;
  vtkSmartPointer<vtkScalarsToColors> Table;
  std::string Name;
  int NumberOfLabels;
  std::optional<double> Mark;
  int Size[2] = { 0, 0 };
  vtkMTimeType TableTime = 0;
  std::array<int, 2> Corner = { { 0, 0 } };
  std::array<int, 3> Place = { { 0, 0, 0 } }; // of the bar: left, bottom, height
  vtkNew<vtkPolyData> GroundShape;
  vtkNew<vtkActor2D> Ground; // background that keeps the text readable
  vtkNew<vtkPolyData> BarShape;
  vtkNew<vtkActor2D> Bar;
  vtkSmartPointer<vtkTextActor> Title;
  std::vector<vtkSmartPointer<vtkTextActor>> Labels;
  unsigned long Tag;
};

#endif
