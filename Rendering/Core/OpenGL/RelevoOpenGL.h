// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the OpenGL entry points, by whichever loader this VTK has (GLEW, from 9.4 on glad)
 *
 * Both know OpenGL 4.5; a function that the context does not have is a null pointer.
 */
#ifndef RelevoOpenGL_h
#define RelevoOpenGL_h

#if defined(__has_include)
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif
#else
#include "vtk_glew.h"
#endif

#endif
