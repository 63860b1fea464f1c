// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what colours mean
 */
#ifndef ViewerLegend_h
#define ViewerLegend_h

#include "vtkSmartPointer.h"

#include <string>

class vtkScalarBarActor;
class vtkScalarsToColors;

/// For a picture of that size; nullptr where it would not fit. Labels are numbers of the table's
/// range, or its annotations where it has an indexed lookup.
vtkSmartPointer<vtkScalarBarActor> MakeLegend(
  vtkScalarsToColors* table, const std::string& title, int numberOfLabels, const int size[2]);

#endif
