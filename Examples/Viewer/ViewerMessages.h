// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerMessages
 * @brief   errors, warnings and progress of VTK objects, as a command-line program tells them
 */
#ifndef ViewerMessages_h
#define ViewerMessages_h

#include <chrono>
#include <stdexcept>
#include <string>

class vtkAlgorithm;
class vtkObject;

/// Bad input or output: what is wrong with it.
struct ViewerError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class ViewerMessages
{
public:
  /**
   * Collect the errors of an object and pass its warnings on.
   */
  void Observe(vtkObject* object);

  /**
   * As above, and show the progress of an algorithm under a name, where a person is watching.
   */
  void Observe(vtkAlgorithm* algorithm, const std::string& name);

  /**
   * Throw the errors of an object as ViewerError where they happen.
   */
  void ThrowErrorsOf(vtkObject* object);

  /**
   * Throws ViewerError with the first error since the last check.
   */
  void Check();

private:
  void ShowProgress(const std::string& name, double share);

  std::string FirstError;
  std::chrono::steady_clock::time_point LastProgress;
};

#endif
