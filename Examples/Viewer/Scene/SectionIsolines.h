// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SectionIsolines
 * @brief   isolines of a point array on the section of a cut
 */
#ifndef SectionIsolines_h
#define SectionIsolines_h

#include "vtkNew.h"

#include <string>

class vtkActor;
class vtkAlgorithmOutput;
class vtkArrayQuantityFilter;
class vtkContourFilter;
class vtkPolyDataMapper;
class vtkRenderer;

class SectionIsolines
{
public:
  /// Adds the lines to a renderer. They follow the section.
  SectionIsolines(vtkAlgorithmOutput* section, vtkRenderer* renderer);
  ~SectionIsolines();

  /// Draws the multiples of a spacing in a range of an array of points, or of the lengths of
  /// vectors.
  void Set(const std::string& array, bool isVector, double spacing, const double range[2]);

  /// Moves the lines in front of the section.
  void SetOffset(double offset[3]);

private:
  vtkNew<vtkArrayQuantityFilter> Lengths; // of vectors
  vtkNew<vtkContourFilter> Contours;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

#endif
