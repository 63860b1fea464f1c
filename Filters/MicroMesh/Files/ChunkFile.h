// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the container of .rmm files: a header, and compressed chunks with checksums
 *
 * Numbers are little-endian and without signs. The header has 32 bytes:
 *
 * - 8 bytes: 0x89, "RMM", carriage return, line feed, 0x1A, line feed. A transfer as text changes
 *   them.
 * - 4 bytes: the version of the format, 2.
 * - 4 bytes: the number of chunks.
 * - 8 bytes: the size of the file.
 * - 4 bytes: 0.
 * - 4 bytes: the CRC-32 of the bytes before.
 *
 * A chunk has 8 bytes with its size, 8 bytes with its compressed size, the data in zlib's format,
 * and 4 bytes with the CRC-32 of all of this.
 */
#ifndef ChunkFile_h
#define ChunkFile_h

#include "RelevoFiltersMicroMeshModule.h" // for export macro

#include <string>
#include <string_view>
#include <vector>

namespace relevo
{
/// Return a file with these chunks.
RELEVOFILTERSMICROMESH_EXPORT std::string PackChunks(const std::vector<std::string>& chunks);

/// Read the chunks of a file. Returns the error without a full stop, or "".
std::string UnpackChunks(std::string_view file, std::vector<std::string>& chunks);

/// Whether a file begins like one with chunks. Its version may be newer.
bool AreChunks(std::string_view file);
}

#endif
