// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   lets C++ compile the GLSL files that the shaders include
 *
 * Include this header, then include a file of glsl/ inside namespace relevo, or inside a class of
 * it that provides what the file asks for. Private to the modules' own sources.
 */
#ifndef RefinementMathematics_h
#define RefinementMathematics_h

#define GLM_FORCE_SILENT_WARNINGS
#include <glm/glm.hpp>

/// Marks each function of a shared file: inline in C++, nothing in GLSL.
#define RELEVO_FUNCTION [[maybe_unused]] inline
/// Marks parameters that one of several functions of a name has no use for.
#define RELEVO_UNUSED [[maybe_unused]]
/// GLSL's guarantee against contraction; C++ has it from -ffp-contract=off.
#define precise
/// Uniforms of a file included inside a class are the class's members.
#define uniform

/// Where shared files are compiled: GLSL's types and functions are GLM's.
namespace relevo
{
using namespace glm;
}

#endif
