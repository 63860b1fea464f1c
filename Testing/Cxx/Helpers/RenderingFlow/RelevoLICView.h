// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A scene drawn with its LIC only, its colours only, and both.
#ifndef RelevoLICView_h
#define RelevoLICView_h

#include "RelevoLICVectors.h"

#include <array>
#include <functional>
#include <memory>
#include <string>

struct RelevoLICView
{
  using Color = std::array<double, 3>;
  // Combines a colour of the surface with the LIC.
  using Formula = std::function<Color(const Color& color, double lic)>;

  RelevoLICView();

  // Returns the actor whose LIC is tested.
  vtkActor* Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr);

  // Looks along the z axis in parallel projection at coordinates up to `scale`.
  void LookDown(double scale, int pixels);

  RelevoPicture Draw();

  RelevoPicture DrawColors();

  // Grey values; masked pixels are red.
  RelevoPicture DrawLIC();

  // Draws the view and compares it with the formula applied to LIC and colours.
  bool Compare(RelevoComparison& comparison, const std::string& name,
    const RelevoTolerance& tolerance, const Formula& formula, const Formula& ofMasked = nullptr);

  static Color At(const RelevoPicture& picture, size_t pixel);

  static bool IsMasked(const Color& lic) { return lic[0] != lic[1]; }

  static Color Mix(const Color& a, const Color& b, double share);

  std::shared_ptr<RelevoScene> Scene;
  vtkActor* Actor = nullptr;
  vtkAdaptiveLICMapper* Mapper = nullptr;
};

#endif
