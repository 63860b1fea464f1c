// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the displacements of a micro-mesh as bytes
 *
 * Displacements are stored level by level. The prediction of a displacement is the mean of the two
 * points of the lower level beside it. Bytes are the differences, with the sign in the lowest bit.
 */
#ifndef SamplePrediction_h
#define SamplePrediction_h

#include "Data/MicroMesh.h"

#include <string>
#include <string_view>

namespace relevo
{
/// The size of the bytes per sample.
constexpr std::size_t SizeOfPackedSample = 2;

std::string PackSamples(const MicroMesh& mesh);

/// Fill the samples of a mesh with valid edges and faces, from bytes of the right size.
void UnpackSamples(std::string_view bytes, MicroMesh& mesh);
}

#endif
