// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerMessages
 * @brief   errors, warnings and progress of VTK objects, as messages of a command-line program
 */
#ifndef ViewerMessages_h
#define ViewerMessages_h

#include "FileError.h"
#include "Text/ViewerProgress.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkObject;

using ViewerError = FileError;

class ViewerMessages
{
public:
  /// From now on, VTK objects without observers print nothing.
  ViewerMessages();

  /**
   * Collects the errors of an object and shows its warnings, each once.
   */
  void Observe(vtkObject* object);

  /**
   * Also shows the object's progress, with its progress text if it has one.
   */
  void Observe(vtkObject* object, const std::string& work);

  /**
   * Shows only the progress of an object. The caller collects its errors.
   */
  void ObserveProgress(vtkObject* object, const std::string& work);

  /**
   * Throws the errors of an object as ViewerError at once.
   */
  void ThrowErrorsOf(vtkObject* object);

  /**
   * Replaces a term of VTK's messages, such as "input 0", by the user's name for it from now on.
   */
  void Name(const std::string& words, const std::string& name);
  std::string Rename(std::string text) const;

  /**
   * Throws ViewerError with the first error since the last check.
   */
  void Check();

  //@{
  /**
   * Call these before and after files are read. The second also throws for the first error of an
   * object without observers: VTK's readers ignore errors of their helpers.
   */
  void StartReading();
  void CheckReading();
  //@}

  /**
   * Shows a warning once. Until ShowWarnings() is called, warnings are stored, because the program
   * prints only one line if an error follows.
   */
  void Warn(const std::string& text);
  void ShowWarnings();

  /**
   * Stores a note about a file, less than a warning, which ShowNotes() prints on stdout.
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
  std::set<std::string> Warnings; // shown or stored
  ViewerProgress Progress;
};

#endif
