// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   figures of a picture of grey LIC
 */
#ifndef BenchmarkLICPicture_h
#define BenchmarkLICPicture_h

#include <vector>

struct FlowScene;

/// Mean and standard deviation of the grey, in [0, 1], then median and 95th percentile of the
/// angles between the lines and the field, in degrees, where the scene has a direction. The
/// picture, RGB bytes, is seen as FlowScene::LookAlongZ() shows it; NaN where it is not of that
/// size.
std::vector<double> GetPictureFigures(
  const FlowScene& scene, int width, int height, const std::vector<unsigned char>& picture);

#endif
