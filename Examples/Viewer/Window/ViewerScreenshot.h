// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScreenshot
 * @brief   saves a picture of the scene into a new file with i
 */
#ifndef ViewerScreenshot_h
#define ViewerScreenshot_h

#include <string>
#include <vector>

class vtkObject;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class ViewerFrames;
class ViewerMessages;
class vtkProp;

class ViewerScreenshot
{
public:
  /// Files are named after the input, in the folder that the program was called from, and numbered:
  /// none is overwritten. Their names go to standard output. Props that are words of the window are
  /// not in the pictures. Is there until the interactor has ended.
  ViewerScreenshot(vtkRenderWindowInteractor* interactor, ViewerFrames& frames,
    const std::string& input, const std::vector<vtkProp*>& words, ViewerMessages& messages);

private:
  void OnKey(vtkObject* caller, unsigned long event, void* data);
  std::string FindName() const;
  void Write(vtkRenderWindow* window, const std::string& fileName);

  ViewerFrames& Frames;
  std::string Stem;
  std::vector<vtkProp*> Words;
  ViewerMessages& Messages;
};

#endif
