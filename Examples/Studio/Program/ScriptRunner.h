// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ScriptRunner
 * @brief   drives the studio by the lines of a script, with events of an interactor
 */
#ifndef ScriptRunner_h
#define ScriptRunner_h

#include "Driving/ScriptFile.h"
#include "Program/StudioPointer.h"

#include <functional>
#include <string>
#include <vector>

class Studio;
class vtkRenderWindowInteractor;

class ScriptRunner
{
public:
  ScriptRunner(Studio& studio, vtkRenderWindowInteractor* interactor);

  /// Runs a script to its end or to quit. Errors are written with the number of their line, and the
  /// next line follows. Returns the number of errors.
  int Run(const std::string& fileName);

private:
  void RunLine(const ScriptLine& line);
  void Click(const std::string& name);
  void Drag(const std::vector<double>& numbers);
  void SendKey(const std::string& name);
  void Wait();
  void Send(unsigned long event, double x, double y);
  /// Draws requested frames.
  void Flush();

  Studio& Driven;
  vtkRenderWindowInteractor* Interactor;
  StudioPointer Pointer;
  bool IsFrameRequested = false;
};

#endif
