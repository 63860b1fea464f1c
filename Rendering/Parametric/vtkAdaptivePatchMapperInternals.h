// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a vtkAdaptivePatchMapper keeps
 *
 * Private to the mapper's own sources.
 */
#ifndef vtkAdaptivePatchMapperInternals_h
#define vtkAdaptivePatchMapperInternals_h

#include "Buffers/PatchScalars.h"
#include "Changes/Dependencies.h"
#include "vtkAdaptivePatchMapper.h"
#include "vtkNew.h"
#include "vtkPatchSurfaceFilter.h"

#include <string>

class vtkDataArray;

struct vtkAdaptivePatchMapper::vtkInternals
{
  relevo::PatchScalars Scalars;
  relevo::Dependencies FieldDependencies;
  std::string FieldProblem; // said last
  std::string LineProblem;  // the same of isolines

  // Of an input that is a grid.
  vtkNew<vtkPatchSurfaceFilter> Filter;
  relevo::Dependencies GridDependencies;

  bool IsSurface = false; // of the actor that is drawn

  /// What fragments show of patches.
  struct Shown
  {
    bool Colors = false;
    bool Isolines = false;
    bool Edges = false;

    bool Any() const { return this->Colors || this->Edges; }
    bool HasLines() const { return this->Isolines || this->Edges; }
  };
  Shown Shows; // by the shaders that are being written

  /// The scalars of points that VTK colours by; nullptr for none.
  static vtkDataArray* GetScalars(vtkAdaptivePatchMapper* mapper);
  static bool AreColors(vtkAdaptivePatchMapper* mapper, vtkDataArray* scalars);
  std::string DescribeMisfit(vtkAdaptivePatchMapper* mapper, vtkDataArray* scalars);
  /// Why there are no isolines; empty where there are some, or none are wanted.
  static std::string DescribeMissingIsolines(vtkAdaptivePatchMapper* mapper);
  std::string GetFragmentFunctions() const;
};

#endif
