// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes JPEG and PNG files to memory, without classes of VTK, in any thread
 */
#ifndef PictureFormats_h
#define PictureFormats_h

#include "Pictures/Picture.h"

#include <atomic>
#include <vector>

namespace relevo
{
/// Returns a JPEG file, or nothing if the library reports an error.
std::vector<unsigned char> WriteJPEG(const RawPicture& picture, int quality);

/// Returns a PNG file, or nothing if the library reports an error or `isCancelled` becomes true.
std::vector<unsigned char> WritePNG(
  const RawPicture& picture, const std::atomic<bool>& isCancelled);
}

#endif
