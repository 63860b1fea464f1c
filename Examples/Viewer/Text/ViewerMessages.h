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

class vtkObject;

/// Bad input or output: what is wrong with it.
struct ViewerError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

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
   * Throw the errors of an object as ViewerError where they happen.
   */
  void ThrowErrorsOf(vtkObject* object);

  /**
   * Throws ViewerError with the first error since the last check.
   */
  void Check();

private:
  void ShowWarning(const std::string& text);

  std::string FirstError;
  std::set<std::string> Warnings; // shown
  ViewerProgress Progress;
};

#endif
