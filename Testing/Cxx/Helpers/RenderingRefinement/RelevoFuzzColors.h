// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Lookup tables, colour functions and textures, valid and hostile.
#ifndef RelevoFuzzColors_h
#define RelevoFuzzColors_h

#include "RelevoFuzz.h"

#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

namespace RelevoFuzz
{
// 0 to 1000 colours, linear or logarithmic, with any range.
vtkSmartPointer<vtkScalarsToColors> MakeLookupTable(Dice& dice);

vtkSmartPointer<vtkScalarsToColors> MakeColorFunction(Dice& dice);

vtkSmartPointer<vtkScalarsToColors> MakeTable(Dice& dice);

// 1 to 4 components, an image, a line of pixels or sometimes empty.
vtkSmartPointer<vtkTexture> MakeTexture(Dice& dice);
}

#endif
