// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TimeSteps
 * @brief   the file of a scene, with the time step that is shown, and a label with its time
 */
#ifndef TimeSteps_h
#define TimeSteps_h

#include "Files/ResultFile.h"
#include "Files/StepFilter.h"

#include "vtkNew.h"

#include <functional>
#include <string>

class ViewerMessages;
class vtkRenderer;
class vtkTextActor;
struct ViewerOptions;

class TimeSteps
{
public:
  /// Opens the file at the time of the options. Throws ViewerError. Notes which step of several is
  /// shown. The label is shown with the legend.
  TimeSteps(const ViewerOptions& options, vtkRenderer* renderer, ViewerMessages& messages);
  ~TimeSteps();

  ResultFile& GetFile() { return this->File; }
  StepFilter& GetFilter() { return this->Filter; }

  /// 0 for a file without times.
  int GetNumber() const { return static_cast<int>(this->File.GetTimes().size()); }
  int GetStep() const { return this->Step; }
  void SetStep(int step);

  /// Handles a key of the window: < calls show() with the step before, > with the next one. Returns
  /// the option that repeats the change, or "". If a step cannot be shown, writes an error and
  /// shows the old one.
  std::string Change(char key, const std::function<void(int)>& show);

  /// The time of the step as the option that shows it.
  std::string GetOption() const;

private:
  ResultFile File;
  StepFilter Filter;
  int Step;
  vtkNew<vtkTextActor> Label;
};

#endif
