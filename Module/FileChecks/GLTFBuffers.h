// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the buffers of a glTF file
 */
#ifndef GLTFBuffers_h
#define GLTFBuffers_h

#include <string>
#include <vector>

struct GLTFBuffer
{
  std::string URI;          // empty for the binary chunk of a .glb file
  long long ByteLength = 0; // as declared
};

/**
 * Parses the JSON text of the array "buffers". Returns an empty list for invalid text. Buffers may
 * be embedded in the text, so strings may have megabytes.
 */
std::vector<GLTFBuffer> ParseGLTFBuffers(const std::string& text);

/**
 * Whether the chunks of a .glb file end where its header says. Otherwise VTK's reader does not end,
 * and takes all memory. True for other files.
 */
bool HasCompleteChunks(const std::string& fileName);

/**
 * Number of bytes in the binary chunk of a .glb file, 0 if there is none.
 */
long long GetGLBLength(const std::string& fileName);

#endif
