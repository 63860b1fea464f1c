// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   StudioPanel
 * @brief   the panel of the studio: groups of controls, figures and the last message
 */
#ifndef StudioPanel_h
#define StudioPanel_h

#include "Controls/Control.h"
#include "Panels/LayoutList.h"
#include "Panels/SceneTexts.h"
#include "Panels/TransferEditor.h"
#include "Scene/SceneContent.h"

#include <string>
#include <vector>

class EdgePattern;
class PanelRequests;

/// The input of the panel for one pass of ImGui.
struct PanelState
{
  const std::vector<Control>& Controls;
  const SceneContent& Content;
  const SceneFigures& Figures;
  const std::vector<PatternCount>& Patterns; // of the last frame with ShowsHistogram()
  const EdgePattern& Pattern;                // of the generator
  std::string Message;                       // the last error, or ""
  std::string Note;                          // what the last action did, or ""
  SceneTexts Texts;
  std::string KeptText; // the values that the user keeps, or ""
};

class StudioPanel
{
public:
  /// Draws the panel by ImGui and updates the layout.
  void Draw(const PanelState& state, PanelRequests& requests);
  const LayoutList& GetLayout() const { return this->Layout; }
  /// In pixels, or 0 while only the title is shown.
  int GetWidth() const { return this->Width; }
  /// Whether the histogram of patterns was open in the last pass.
  bool ShowsHistogram() const { return this->HasHistogram; }

  /// Opens the group of a control and scrolls to it in the next pass.
  void Reveal(const std::string& name) { this->Revealed = name; }

private:
  void DrawGroup(const std::string& group, const PanelState& state, PanelRequests& requests);
  void DrawControls(const std::string& group, const PanelState& state, PanelRequests& requests);
  /// Adds the last item, which opens a group, to the layout.
  void AddHeader(const std::string& group, bool isOpen);
  void DrawKeptText(const PanelState& state);
  void DrawFigures(const PanelState& state);
  void DrawPatterns(const PanelState& state);
  bool IsRevealed(const std::string& name) const;

  LayoutList Layout;
  TransferEditor Transfer;
  std::string Revealed;
  int Width = 0;
  bool HasHistogram = false;
};

#endif
