// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random images, good and hostile.
#ifndef RelevoFuzzImages_h
#define RelevoFuzzImages_h

#include "RelevoFuzz.h"

#include "vtkImageData.h"

namespace RelevoFuzz
{
// Of 0 to 16 points a side, mostly flat, in any plane, with arrays as a mesh has them.
vtkSmartPointer<vtkImageData> MakeImage(Dice& dice);
}

#endif
