// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FrameRequests
 * @brief   collects requests of frames while events are handled
 *
 * Interactor styles draw a frame for each event. While an object of this class exists, the
 * interactor only records that a frame is requested. A program that draws by itself (EnableRender
 * off) keeps doing so.
 */
#ifndef FrameRequests_h
#define FrameRequests_h

class vtkObject;
class vtkRenderWindowInteractor;

namespace relevo
{
class FrameRequests
{
public:
  explicit FrameRequests(vtkRenderWindowInteractor* interactor);
  ~FrameRequests();
  FrameRequests(const FrameRequests&) = delete;
  FrameRequests& operator=(const FrameRequests&) = delete;

  /// Whether a frame has to be drawn.
  bool IsRequested() const { return this->Requested && this->WasEnabled; }

private:
  void OnRender() { this->Requested = true; }

  vtkRenderWindowInteractor* Interactor;
  bool WasEnabled;
  bool Requested = false;
  unsigned long Observer;
};
}

#endif
