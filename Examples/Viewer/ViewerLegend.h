// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what the colours of levels, patterns and metrics mean
 */
#ifndef ViewerLegend_h
#define ViewerLegend_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAdaptiveRefinementMapper;
class vtkScalarBarActor;

/// For a picture of that height; nullptr where it would not fit.
vtkSmartPointer<vtkScalarBarActor> MakeLegend(
  vtkAdaptiveRefinementMapper* mapper, const std::string& title, int height);

#endif
