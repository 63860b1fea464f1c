// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Lookup tables, colour functions and textures, good and hostile.
#ifndef RelevoFuzzColors_h
#define RelevoFuzzColors_h

#include "RelevoFuzz.h"

#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

namespace RelevoFuzz
{
// Of 0 to 1000 colours, linear or logarithmic, of any range.
vtkSmartPointer<vtkScalarsToColors> MakeLookupTable(Dice& dice);

vtkSmartPointer<vtkScalarsToColors> MakeColorFunction(Dice& dice);

vtkSmartPointer<vtkScalarsToColors> MakeTable(Dice& dice);

// Of 1 to 4 components, flat or a line of pixels, at times none.
vtkSmartPointer<vtkTexture> MakeTexture(Dice& dice);
}

#endif
