// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerMessages
 * @brief   errors, warnings and progress of VTK objects, as a command-line program tells them
 */
#ifndef ViewerMessages_h
#define ViewerMessages_h

#include "Text/ViewerProgress.h"

#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

class vtkObject;

/// Bad input or output: what is wrong with it.
struct ViewerError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Of files that are too large, or say that they are.
constexpr const char* NoMemory =
  "not enough memory; the file is damaged, or too large for this machine";

class ViewerMessages
{
public:
  /// VTK's objects that nobody observes say nothing from here on.
  ViewerMessages();

  /**
   * Collect the errors of an object and pass its warnings on, each once.
   */
  void Observe(vtkObject* object);

  /**
   * As above, and show how far the object's work is, in its own words where it has some.
   */
  void Observe(vtkObject* object, const std::string& work);

  /**
   * Show the progress of an object alone, whose errors the caller collects.
   */
  void ObserveProgress(vtkObject* object, const std::string& work);

  /**
   * Throw the errors of an object as ViewerError where they happen.
   */
  void ThrowErrorsOf(vtkObject* object);

  /**
   * Of messages from here on: the user's name for what VTK's objects call otherwise, as "input 0".
   */
  void Name(const std::string& words, const std::string& name);

  /**
   * Throws ViewerError with the first error since the last check.
   */
  void Check();

  //@{
  /**
   * Before and after files are read: the second throws also for the first error of an object that
   * nobody observes. VTK's readers have helpers whose errors they pass over.
   */
  void StartReading();
  void CheckReading();
  //@}

  /**
   * Shows a warning, once. Until ShowWarnings() is called it is kept: it is of no use before an
   * error, which is the one line that the program ends with.
   */
  void Warn(const std::string& text);
  void ShowWarnings();

  /**
   * Keeps a note about a file, less than a warning, until ShowNotes() prints it on stdout.
   */
  void Tell(const std::string& text);
  void ShowNotes();

private:
  /// The text of a VTK object's message.
  std::string TakeText(const void* callData) const;

  bool ShowsWarnings = false;
  std::vector<std::string> WaitingWarnings;
  std::string FirstError;
  std::vector<std::string> Notes;
  std::vector<std::pair<std::string, std::string>> Names;
  std::set<std::string> Warnings; // shown or kept
  ViewerProgress Progress;
};

#endif
