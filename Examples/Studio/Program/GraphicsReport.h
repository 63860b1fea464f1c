// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   describes the graphics card
 */
#ifndef GraphicsReport_h
#define GraphicsReport_h

#include <string>

/// JSON of versions, the driver that draws without a display, its limits and extensions. Throws
/// ViewerError without OpenGL.
std::string MakeGraphicsReport(const std::string& version);

#endif
