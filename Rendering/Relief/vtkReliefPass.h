// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefPass
 * @brief   shows reliefs instead of opaque props while the view moves
 *
 * The pass shows reliefs while the window requests at least 1 frame per second
 * (vtkRenderWindow::DesiredUpdateRate, which interactors raise as long as the mouse moves the
 * camera). The renderer's opaque props are then not drawn: vtkReliefMapper shows captures of the
 * last views, so the time per frame does not depend on the props. The delegate draws translucent
 * props, volumes, props with lines or points, and props without bounds. It also draws all other
 * frames, which are bit-identical to its own.
 *
 * A capture covers slightly more than the view, with one texel per pixel. Up to four captures are
 * kept and complement one another. A new capture, which takes slightly longer than a frame of the
 * props, is made in these cases:
 *
 * - The predicted fraction of holes exceeds MaximumHoleShare. Holes appear where neighbouring
 *   texels move so far apart, in all captures, that the surface behind them would be visible, and
 *   where the view leaves the captured region.
 * - The view direction differs by more than MaximumAngle from that of each capture.
 * - A texel would be wider than two pixels.
 * - A prop, its data, visibility or appearance, or a light of the renderer has changed. The other
 *   captures are then dropped.
 *
 * While the view moves, captures are made ahead of it by extrapolating its last step: one step, or
 * up to 8 that rotate by at most a third of MaximumAngle. Frames then lie between two captures. If
 * the captures do not show a frame well enough, the delegate draws it. When three captures in a row
 * have each served a single frame, they only cost time: the delegate then draws the next 8 frames
 * that need a capture, 16 after the next such capture, and so on up to 64.
 *
 * Surfaces that appear behind a silhouette against the background cannot be predicted; MaximumAngle
 * limits the error. Colours are those of the captures, see vtkReliefCapture: a headlight stays at
 * its captured position.
 *
 * A prop with opaque and translucent parts is shown by reliefs and drawn by the delegate. If no
 * opaque prop is in view, the delegate draws everything. A vtkHardwareSelector selects the props
 * themselves.
 *
 * Several processes can draw one scene together, see SetController().
 *
 * Pass one instance to vtkRenderer::SetPass() of each renderer.
 *
 * @sa vtkReliefCapture, vtkReliefMapper
 */
#ifndef vtkReliefPass_h
#define vtkReliefPass_h

#include "RelevoRenderingReliefModule.h" // for export macro
#include "vtkRenderPass.h"

#include <memory> // for Internals

class vtkMultiProcessController;

class RELEVORENDERINGRELIEF_EXPORT vtkReliefPass : public vtkRenderPass
{
public:
  static vtkReliefPass* New();
  vtkTypeMacro(vtkReliefPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the pass that draws still frames and all props that reliefs do not show. It must set up the
   * camera, for example a vtkCameraPass or vtkRenderStepsPass. With nullptr (the default), a
   * vtkRenderStepsPass draws lights and the opaque, translucent, volumetric and overlay passes.
   */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  //@}

  //@{
  /**
   * Set the processes that draw one scene together, each with a part of its props, in renderers of
   * the same size with the same camera. Render() is then collective. The captures of all processes
   * are composited by depth, and process 0 draws the reliefs, so the delegate must composite the
   * images by depth. nullptr (the default) is one process.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  //@}

  //@{
  /**
   * Set the fraction of holes above which a new capture is made, relative to the pixels that show
   * an opaque prop; 0 to 1, default 0.005. A value out of range is an error and changes nothing.
   */
  void SetMaximumHoleShare(double share);
  vtkGetMacro(MaximumHoleShare, double);
  //@}

  //@{
  /**
   * Set the angle, in degrees, between the view direction and that of the nearest capture above
   * which a new capture is made; 0 to 180, default 15. A value out of range is an error and changes
   * nothing.
   */
  void SetMaximumAngle(double angle);
  vtkGetMacro(MaximumAngle, double);
  //@}

  /// Record that the view has stopped. Still frames that this pass draws record it, too.
  void StopMotion();

  /// Return the number of captures since the pass was created.
  vtkIdType GetNumberOfCaptures();

  /// Return the number of frames shown by reliefs since the pass was created.
  vtkIdType GetNumberOfReliefFrames();

  /// Return the predicted fraction of holes in the last frame that showed reliefs; 0 before the
  /// first.
  double GetHoleShare();

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkReliefPass();
  ~vtkReliefPass() override;

  vtkRenderPass* DelegatePass = nullptr;
  double MaximumHoleShare = 0.005;
  double MaximumAngle = 15.0;

private:
  vtkReliefPass(const vtkReliefPass&) = delete;
  void operator=(const vtkReliefPass&) = delete;

  class vtkInternals;

  void RenderDelegate(const vtkRenderState* state);
  bool UpdateReliefs(const vtkRenderState* state);

  std::unique_ptr<vtkInternals> Internals;
};

#endif
