// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Pictures as a whole and in parts.
#ifndef RelevoPictures_h
#define RelevoPictures_h

#include "RelevoScene.h"

namespace RelevoPictures
{
// To the bit.
bool Equal(const RelevoPicture& a, const RelevoPicture& b);

// The part whose lower left pixel is (x, y).
RelevoPicture Crop(const RelevoPicture& picture, int x, int y, int width, int height);
}

#endif
