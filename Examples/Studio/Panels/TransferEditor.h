// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TransferEditor
 * @brief   edits the nodes of a transfer function over the histogram of the values
 */
#ifndef TransferEditor_h
#define TransferEditor_h

#include "Controls/Control.h"
#include "Panels/ControlWidget.h"
#include "Scene/SceneContent.h"

#include <cstddef>
#include <string>
#include <vector>

class TransferEditor
{
public:
  /// Draws the editor below the control.
  void Draw(const Control& control, const SceneContent& content, LayoutList& layout,
    PanelRequests& requests);

private:
  void DrawCurve(const SceneContent& content, LayoutList& layout, PanelRequests& requests);
  void DrawNode(LayoutList& layout, PanelRequests& requests);
  void Send(PanelRequests& requests, bool isContinued);

  std::vector<TransferNode> Nodes;
  double Range[2] = { 0.0, 1.0 };
  std::size_t Chosen = 0;
};

#endif
