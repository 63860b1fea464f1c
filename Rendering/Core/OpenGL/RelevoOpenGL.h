// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   includes the OpenGL functions of VTK's loader (GLEW, or glad from VTK 9.4 on)
 *
 * Both support OpenGL 4.5. A function that the context does not support is a null pointer.
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
