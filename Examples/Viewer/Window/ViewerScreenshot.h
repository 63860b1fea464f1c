// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScreenshot
 * @brief   saves a picture of the scene to a new file with i
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
  /// Files are numbered and named after the input, in the current folder, and no file is
  /// overwritten. Their names are printed on standard output. Texts of the window are left out.
  /// Must live until the interactor has ended.
  ViewerScreenshot(vtkRenderWindowInteractor* interactor, ViewerFrames& frames,
    const std::string& input, const std::vector<vtkProp*>& words, ViewerMessages& messages);

private:
  void OnKey(vtkObject* caller, unsigned long event, void* data);
  void Write(vtkRenderWindow* window, const std::string& fileName);

  ViewerFrames& Frames;
  std::string Input;
  std::vector<vtkProp*> Words;
  ViewerMessages& Messages;
};

#endif
