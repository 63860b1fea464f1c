// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   arrays as bytes that compress well
 *
 * Each component is stored separately. Integers are differences to the value before, modulo a power
 * of two. The first bytes of all values come first, which are the lowest, then the second bytes,
 * and so on.
 */
#ifndef ArrayPacking_h
#define ArrayPacking_h

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

class vtkDataArray;

namespace relevo
{
/// Append numbers, or remove as many as there are values. There must be enough bytes.
void PackNumbers(const std::vector<std::uint64_t>& values, int bits, std::string& bytes);
void UnpackNumbers(std::string_view& bytes, int bits, std::vector<std::uint64_t>& values);

/// Whether a VTK type is float or double.
bool IsFloating(int type);

/// Whether arrays of a VTK type can be packed.
bool IsPackedType(int type);

/**
 * Return the lowest number of bits in which all values fit: 8, 11 or 16 for shorts. With 11 bits,
 * a byte has the highest three bits of two values. All other types have all their bits.
 */
int FindBits(vtkDataArray* array);

/// The number of bytes of a packed array. Throws std::bad_alloc if it is too large for memory.
std::uint64_t GetPackedSize(int type, int bits, std::uint64_t components, std::uint64_t tuples);

std::string PackArray(vtkDataArray* array, int bits);

/// Fill an array of standard memory layout from bytes of the right size.
void UnpackArray(std::string_view bytes, int bits, vtkDataArray* array);
}

#endif
