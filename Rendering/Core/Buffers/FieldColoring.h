// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how fragments get colours from scalars that a surface evaluates at every pixel
 */
#ifndef FieldColoring_h
#define FieldColoring_h

namespace relevo
{
enum class FieldColoring
{
  NONE,    // there are no coefficients
  TABLE,   // the value is mapped by a lookup table
  TEXTURE, // the value becomes VTK's texture coordinate in the table
  COLORS   // the values are colours
};
}

#endif
