// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   blend modes with the values of vtkVolumeMapper
 *
 * Private to the modules.
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
