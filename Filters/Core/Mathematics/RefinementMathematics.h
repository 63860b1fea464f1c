// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   compiles the GLSL files of the shaders as C++
 *
 * Include this header, then include a file from glsl/ in namespace relevo, or in a class of it that
 * provides the functions that the file needs.
 */
#ifndef RefinementMathematics_h
#define RefinementMathematics_h

#define GLM_FORCE_SILENT_WARNINGS
#include <glm/glm.hpp>

/// Marks each function of a shared file: inline in C++, nothing in GLSL.
#define RELEVO_FUNCTION [[maybe_unused]] inline
/// Marks parameters that one of several overloads does not use.
#define RELEVO_UNUSED [[maybe_unused]]
/// Prevents contraction in GLSL. In C++, -ffp-contract=off does.
#define precise
/// Uniforms of a file that is included in a class become members.
#define uniform

/// Shared files use GLSL's types and functions, which GLM provides.
namespace relevo
{
using namespace glm;
}

#endif
