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
  std::string URI;          // empty for the binary part of a .glb file
  long long ByteLength = 0; // declared
};

/**
 * From the text of the array "buffers", JSON; empty where it is not. Pictures and coordinates may
 * be in it, so that strings are megabytes long.
 */
std::vector<GLTFBuffer> ParseGLTFBuffers(const std::string& text);

/**
 * The bytes of the binary part of a .glb file; 0 where there is none.
 */
long long GetGLBLength(const std::string& fileName);

#endif
