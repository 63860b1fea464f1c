// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the visible point of a surface in a pixel
 */
#ifndef DrawnPoint_h
#define DrawnPoint_h

class vtkRenderer;

/// Finds the visible point in a pixel from its depth, which includes refinement and displacement
/// and costs reading one pixel. Returns false for the background.
bool GetDrawnPoint(vtkRenderer* renderer, const int pixel[2], double point[3]);

#endif
