// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   changes VTK's shaders into shaders of curves
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
/// The source of the curves' colours.
enum class CurveColoring
{
  ACTOR,
  CELLS,              // a colour for each curve
  POINTS,             // colours of points, evaluated with the curve's basis
  VALUES,             // values evaluated with the curve's basis, mapped at the ends of segments
  VALUES_OF_FRAGMENTS // the same, interpolated between the ends before they are mapped
};

/// The options of shaders of curves.
struct CurveShaderOptions
{
  int Sides = 1;  // 1: lines, 2: ribbons, more: tubes
  int Degree = 0; // of all curves; 0 if they differ
  bool IsRational = false;
  bool HasRadii = false; // false for lines
  bool IsTessellated = false;
  bool HasCells = false; // a selection asks for cells
  CurveColoring Coloring = CurveColoring::ACTOR;

  Dependencies GetKey() const;
};

/// Return the number of rings of vertices in addition to those at the ends of a curve's segments.
int GetMoreRings(int sides);

/// Change the templates before VTK does. `ownFragments`: see HasOwnFragments().
void PrepareCurveShaders(const CurveShaderOptions& options, bool ownFragments,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Change the shaders after VTK.
void FinishCurveShaders(const CurveShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing);

/// Return the tessellation control shader, without its version.
std::string GetCurveControlShader(const CurveShaderOptions& options);
}

#endif
