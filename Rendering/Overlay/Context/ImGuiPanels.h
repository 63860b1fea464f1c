// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ImGuiPanels
 * @brief   an ImGui context and the panels of its last pass
 *
 * A pass asks the program for its panels. ImGui needs several passes until the panels reflect an
 * event, for example to lay out a new window.
 */
#ifndef ImGuiPanels_h
#define ImGuiPanels_h

#include "Context/ImGuiFont.h"

#include <functional>

struct ImDrawData;
struct ImGuiContext;

namespace relevo
{
class ImGuiPanels
{
public:
  ImGuiPanels();
  ~ImGuiPanels();
  ImGuiPanels(const ImGuiPanels&) = delete;
  void operator=(const ImGuiPanels&) = delete;

  /// Makes a context current, and restores the previous one.
  class Current
  {
  public:
    explicit Current(ImGuiPanels& panels);
    ~Current();
    Current(const Current&) = delete;
    void operator=(const Current&) = delete;

  private:
    ImGuiContext* Previous;
  };

  ImGuiContext* GetContext() const { return this->Context; }

  /**
   * Call a function that describes the panels of a window of this size once, and then until they do
   * not change any more, at most 4 times. afterFirst() is called after ImGui has processed the
   * input and before the first call.
   */
  void Run(const int size[2], const std::function<void()>& describe,
    const std::function<void()>& afterInput = nullptr);
  bool IsRunning() const { return this->Running; }

  /// Return a number for what the panels of the last pass look like.
  size_t GetLook() const { return this->Look; }

  /// Return the panels of the last pass, or nullptr. The context must be current.
  ImDrawData* GetDrawData() const;

private:
  void Pass(const std::function<void()>& describe, const std::function<void()>& afterInput);
  void MeasureLook();

  ImGuiContext* Context;
  double Time = -1.0; // seconds, of the last pass
  size_t Look = 0;
  bool Running = false;
};
}

#endif
