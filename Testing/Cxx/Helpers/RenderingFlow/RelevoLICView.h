// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A scene drawn with its LIC alone, with its colours alone, and with both.
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
  // What becomes of a colour of the surface and the LIC there.
  using Formula = std::function<Color(const Color& color, double lic)>;

  RelevoLICView();

  // The actor whose LIC is looked at.
  vtkActor* Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr);

  // Along the z axis without perspective, at what is up to `scale` away from it in x and y.
  void LookDown(double scale, int pixels);

  RelevoPicture Draw();

  RelevoPicture DrawColors();

  // Grey; red where it is masked.
  RelevoPicture DrawLIC();

  // Draw the view, and compare with what the formulae make of LIC and colours.
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
