// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what is shown of a ray, by vtkVolumeMapper's numbers
 *
 * Private to the modules' own sources.
 */
#ifndef BlendMode_h
#define BlendMode_h

namespace relevo
{
enum class BlendMode
{
  Composite,
  Maximum,
  Minimum,
  Average,
  Additive,
  IsoSurface
};
}

#endif
