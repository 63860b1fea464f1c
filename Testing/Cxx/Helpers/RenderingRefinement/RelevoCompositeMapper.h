// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK's mapper of composite polydata with block attributes, whose name depends on the release.
#ifndef RelevoCompositeMapper_h
#define RelevoCompositeMapper_h

#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using RelevoCompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using RelevoCompositeMapper = vtkCompositePolyDataMapper2;
#endif

#endif
