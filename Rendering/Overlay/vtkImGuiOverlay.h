// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImGuiOverlay
 * @brief   panels of Dear ImGui in a render window
 *
 * Draws user interfaces of Dear ImGui over the scene, into the frame of any render window, on or
 * off the screen. A callback describes the panels by calls of ImGui:
 *
 * @code
 * vtkNew<vtkImGuiOverlay> overlay;
 * overlay->SetRenderWindow(window);
 * overlay->SetCallback(
 *   [&]
 *   {
 *     ImGui::Begin("Sphere");
 *     if (ImGui::SliderInt("resolution", &resolution, 3, 64))
 *     {
 *       sphere->SetThetaResolution(resolution);
 *     }
 *     ImGui::End();
 *   });
 * interactor->Start();
 * @endcode
 *
 * Programs include imgui.h and link Relevo::RenderingOverlay, which contains ImGui.
 *
 * Mouse and keys are shared with the interactor of the window: events over a panel go to ImGui and
 * not to the interactor style or other observers. All others reach the scene as if there were no
 * panels. Panels can also be used by keys alone: Ctrl+Tab enters them, the arrows move between
 * controls, Space or Enter changes one, and Escape leaves it.
 *
 * The callback is called after each event of the interactor and before each frame, several times
 * until the panels do not change any more. It must not render, and it must not throw. If an event
 * has changed the panels, the overlay calls the interactor's Render(); without changes, no frame is
 * drawn. A callback that changes only the scene calls RequestFrame().
 *
 * A frame that only the panels need does not draw the scene: it repeats the pixels of the last
 * frame. This applies if nothing but the overlay requests the frame, and if no renderer, camera,
 * light, prop, mapper or pipeline of a mapper has changed, as GetMTime() reports. If the callback
 * changes something else, call RequestFrame(), or RepeatsSceneOff(). Renderers whose scene is
 * repeated invoke no events.
 *
 * The overlay draws in a renderer of its own, above the window's other layers. OpenGL's state is
 * restored, and the pixels and depths of the scene outside of the panels do not change. In pictures
 * that vtkWindowToImageFilter magnifies, the panels are magnified too.
 *
 * Sizes follow the DPI of the window, see SetScale(). Each overlay has its own ImGui context, so
 * windows are independent. Files such as imgui.ini are not read or written.
 *
 * @sa vtkRenderWindowInteractor
 */
#ifndef vtkImGuiOverlay_h
#define vtkImGuiOverlay_h

#include "RelevoRenderingOverlayModule.h" // for export macro
#include "vtkCommand.h"                   // for event numbers
#include "vtkObject.h"

#include <functional> // for the callback
#include <memory>     // for Internals
#include <string>     // for file names

struct ImGuiContext;
class vtkRenderer;
class vtkRenderWindow;
class vtkRenderWindowInteractor;

class RELEVORENDERINGOVERLAY_EXPORT vtkImGuiOverlay : public vtkObject
{
public:
  static vtkImGuiOverlay* New();
  vtkTypeMacro(vtkImGuiOverlay, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The event that asks observers for panels. The context is current during the event.
  enum Events
  {
    PanelsEvent = vtkCommand::UserEvent + 3901
  };

  //@{
  /**
   * Set the window in which panels are drawn. The overlay removes its renderer from the previous
   * window. The window is not referenced, and it may be destroyed before the overlay. Default:
   * none.
   */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  //@}

  //@{
  /**
   * Set the interactor whose events panels receive. Default: nullptr, which takes the interactor
   * of the window at each frame. The interactor is not referenced.
   */
  void SetInteractor(vtkRenderWindowInteractor* interactor);
  vtkRenderWindowInteractor* GetInteractor();
  //@}

  /**
   * Set a function that describes the panels by calls of ImGui. It is called in addition to
   * observers of PanelsEvent. The context of this overlay is then current.
   */
  void SetCallback(std::function<void()> callback);

  //@{
  /// Show or hide the panels. Hidden panels receive no events. Default: on.
  void SetVisibility(bool visibility);
  bool GetVisibility();
  vtkBooleanMacro(Visibility, bool);
  //@}

  //@{
  /// Set whether frames that only the panels need repeat the scene of the last frame. Default: on.
  void SetRepeatsScene(bool repeats);
  bool GetRepeatsScene();
  vtkBooleanMacro(RepeatsScene, bool);
  //@}

  //@{
  /**
   * Set the factor for all sizes, 0 or from 0.25 to 8. Other values are an error. Default: 0, which
   * takes the window's DPI divided by 72. GetScaleInUse() returns the factor of the last frame.
   */
  void SetScale(double scale);
  double GetScale();
  double GetScaleInUse();
  //@}

  //@{
  /**
   * Set a font file (.ttf, .otf) instead of ImGui's font, and the size of the font in pixels before
   * scaling, from 6 to 96. Default: no file, 13. If the file cannot be read, an ErrorEvent reports
   * it and ImGui's font is used.
   */
  void SetFontFileName(const char* fileName);
  const char* GetFontFileName();
  void SetFontSize(double pixels);
  double GetFontSize();
  //@}

  /**
   * Call the callback now, as before a frame. Return whether the panels have changed since the last
   * frame, or RequestFrame() was called. Without a window, nothing happens.
   */
  bool Update();

  /**
   * Call the callback now, and the interactor's Render() if the panels have changed, for example
   * because of a timer. The frame repeats the scene if it can. Return whether they have changed.
   * Without a window and an interactor, nothing happens.
   */
  bool Refresh();

  /// Call the interactor's Render() after the current event even if the panels do not change. The
  /// next frame draws the scene.
  void RequestFrame();

  //@{
  /// Return whether ImGui uses the mouse or the keys at the moment.
  bool GetCapturesMouse();
  bool GetCapturesKeyboard();
  //@}

  /// Return the number of frames in which panels were drawn.
  vtkIdType GetNumberOfFrames();

  /// Return the number of frames that repeated the scene of the frame before.
  vtkIdType GetNumberOfRepeatedFrames();

  /// Return ImGui's context, for example to load styles.
  ImGuiContext* GetContext();

  /// Return the renderer that draws the panels.
  vtkRenderer* GetRenderer();

protected:
  vtkImGuiOverlay();
  ~vtkImGuiOverlay() override;

private:
  vtkImGuiOverlay(const vtkImGuiOverlay&) = delete;
  void operator=(const vtkImGuiOverlay&) = delete;

  class Internals;
  std::unique_ptr<Internals> Data;
};

#endif
