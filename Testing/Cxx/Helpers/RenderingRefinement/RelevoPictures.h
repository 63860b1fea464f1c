// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares and crops pictures.
#ifndef RelevoPictures_h
#define RelevoPictures_h

#include "RelevoScene.h"

namespace RelevoPictures
{
// Compares bit for bit.
bool Equal(const RelevoPicture& a, const RelevoPicture& b);

// The part whose lower left pixel is (x, y).
RelevoPicture Crop(const RelevoPicture& picture, int x, int y, int width, int height);
}

#endif
