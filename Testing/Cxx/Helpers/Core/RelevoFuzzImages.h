// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random images, valid and hostile.
#ifndef RelevoFuzzImages_h
#define RelevoFuzzImages_h

#include "RelevoFuzz.h"

#include "vtkImageData.h"

namespace RelevoFuzz
{
// 0 to 16 points per side, mostly flat, in any plane, with arrays like those of meshes.
vtkSmartPointer<vtkImageData> MakeImage(Dice& dice);
}

#endif
