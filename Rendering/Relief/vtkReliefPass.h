// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefPass
 * @brief   shows reliefs in place of what is opaque while the view moves
 *
 * While the window asks for at least 1 frame per second (vtkRenderWindow::DesiredUpdateRate, which
 * interactors raise as long as the mouse moves the camera) the renderer's opaque props are not
 * drawn but shown by vtkReliefMapper from captures of the last views: the cost of a frame does not
 * depend on them. Translucent props, volumes, lines and points (props that are not, in all parts,
 * surfaces) and props without bounds are drawn by the delegate as ever. Other frames are the
 * delegate's alone, to the bit.
 *
 * A capture sees a little more than the view, at one texel a pixel. Up to four are kept, which
 * complete one another. There is a new one, which takes as long as a frame of the props and a
 * little more,
 *
 * - when the predicted share of holes is more than MaximumHoleShare: where neighbouring texels move
 *   apart by so much that the surface behind them would be seen, in all of the captures, or where
 *   the view leaves what was captured;
 * - when the direction of view is farther than MaximumAngle from that of each capture;
 * - when a texel would be wider than two pixels;
 * - when a prop, its data, visibility or looks, or a light of the renderer changed: the others are
 *   dropped then.
 *
 * While the view moves, a new capture is made ahead of it, by steps as the last one: one, or up to
 * 8 that turn by at most a third of MaximumAngle. Frames then lie between two captures. A frame
 * that the captures do not show well enough then is drawn by the delegate. When three
 * captures in a row each served one frame alone, they only cost time: the delegate draws the next
 * 8 frames that need a capture, 16 after the next such capture, and so on up to 64.
 *
 * What comes into sight behind an outline with nothing beyond it is not predicted; MaximumAngle
 * bounds it. Colours are those of the captures, see vtkReliefCapture: a headlight stays where it
 * was.
 *
 * A prop with opaque and translucent parts is shown by reliefs and drawn by the delegate. With
 * nothing opaque in view the delegate draws all. A vtkHardwareSelector selects the props
 * themselves.
 *
 * vtkRenderer::SetPass() it, one for each renderer.
 *
 * @sa vtkReliefCapture, vtkReliefMapper
 */
#ifndef vtkReliefPass_h
#define vtkReliefPass_h

#include "RelevoRenderingReliefModule.h" // for export macro
#include "vtkRenderPass.h"

#include <memory> // for Internals

class RELEVORENDERINGRELIEF_EXPORT vtkReliefPass : public vtkRenderPass
{
public:
  static vtkReliefPass* New();
  vtkTypeMacro(vtkReliefPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * What draws still frames, and all that reliefs do not show: a pass with a camera, as a
   * vtkCameraPass or vtkRenderStepsPass. nullptr, the default, for a vtkRenderStepsPass: lights,
   * opaque, translucent, volumetric and overlay pass.
   */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  //@}

  //@{
  /**
   * From which share of holes on, of the pixels that show an opaque prop, there is a new capture; 0
   * to 1, default 0.005.
   */
  void SetMaximumHoleShare(double share);
  vtkGetMacro(MaximumHoleShare, double);
  //@}

  //@{
  /**
   * Degrees between the direction of view and that of the nearest capture from which on there is a
   * new one; 0 to 180, default 15.
   */
  void SetMaximumAngle(double angle);
  vtkGetMacro(MaximumAngle, double);
  //@}

  /// How many captures were made since the pass was.
  vtkIdType GetNumberOfCaptures();

  /// How many frames were shown by reliefs since the pass was made.
  vtkIdType GetNumberOfReliefFrames();

  /// The share of holes that is predicted for the last frame that showed reliefs; 0 before.
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
  bool Capture(const vtkRenderState* state);

  std::unique_ptr<vtkInternals> Internals;
};

#endif
