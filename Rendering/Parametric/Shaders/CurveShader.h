// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how VTK's shaders become those of curves
 *
 * Private to the module.
 */
#ifndef CurveShader_h
#define CurveShader_h

#include "Changes/Dependencies.h"
#include "Shaders/ShaderText.h"

#include <map>
#include <string>

namespace relevo
{
/// What curves are coloured by.
enum class CurveColoring
{
  ACTOR,
  CELLS,              // a colour for each curve
  POINTS,             // colours of points, by the curve's basis
  VALUES,             // values by the curve's basis, looked up at the ends of segments
  VALUES_OF_FRAGMENTS // and interpolated between them before they are looked up
};

/// What shaders of curves differ in.
struct CurveShaderOptions
{
  int Sides = 1;  // 1: lines, 2: ribbons, else tubes
  int Degree = 0; // of all curves; 0 where they differ
  bool IsRational = false;
  bool HasRadii = false; // not of lines
  bool IsTessellated = false;
  bool HasCells = false; // a selection asks for cells
  CurveColoring Coloring = CurveColoring::ACTOR;

  Dependencies GetKey() const;
};

/// Rings of vertices that a curve has beside those at the ends of its segments.
int GetMoreRings(int sides);

/// Before VTK puts its text into the templates. `ownFragments`: see HasOwnFragments().
void PrepareCurveShaders(const CurveShaderOptions& options, bool ownFragments,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Afterwards.
void FinishCurveShaders(const CurveShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// The tessellation control shader, without its version.
std::string GetCurveControlShader(const CurveShaderOptions& options);
}

#endif
