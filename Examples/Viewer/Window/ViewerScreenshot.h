// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScreenshot
 * @brief   what the window shows, into a new file with i
 */
#ifndef ViewerScreenshot_h
#define ViewerScreenshot_h

#include <string>

class vtkObject;
class vtkRenderWindowInteractor;
class ViewerMessages;

class ViewerScreenshot
{
public:
  /// Files are named after the input, in the folder that the program was called from, and numbered:
  /// none is overwritten. Their names go to standard output. Is there until the interactor has
  /// ended.
  ViewerScreenshot(
    vtkRenderWindowInteractor* interactor, const std::string& input, ViewerMessages& messages);

private:
  void OnKey(vtkObject* caller, unsigned long event, void* data);
  std::string FindName() const;

  std::string Stem;
  ViewerMessages& Messages;
};

#endif
