// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the numbers of edges, samples and levels of a micro-mesh as bytes
 *
 * The numbers of MicroMeshFaces and MicroMeshEdges are nearly those that follow from the triangles:
 * edges are numbered in the order of the triangles, and samples in the order of edges and faces.
 * Bytes are the differences to these. All numbers can be packed, also invalid ones.
 */
#ifndef NumberPrediction_h
#define NumberPrediction_h

#include "Files/TrianglePacking.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace relevo
{
using EdgeNumbers = std::array<int, 2>; // the first sample and the level
using FaceNumbers = std::array<int, 5>; // three edges, the first sample and the level

/// The size of the bytes of an array.
constexpr std::size_t SizeOfPackedNumber = 4;

std::string PackEdgeNumbers(const std::vector<EdgeNumbers>& edges);
std::string PackFaceNumbers(const std::vector<FaceNumbers>& faces,
  const std::vector<PackedTriangle>& triangles, const std::vector<EdgeNumbers>& edges);

/// Fill the numbers, from bytes of the right size. There must be as many faces as triangles.
void UnpackEdgeNumbers(std::string_view bytes, std::vector<EdgeNumbers>& edges);
void UnpackFaceNumbers(std::string_view bytes, const std::vector<PackedTriangle>& triangles,
  const std::vector<EdgeNumbers>& edges, std::vector<FaceNumbers>& faces);
}

#endif
