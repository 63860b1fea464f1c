// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   quality measures of a LIC picture
 */
#ifndef BenchmarkLICPicture_h
#define BenchmarkLICPicture_h

#include <vector>

struct FlowScene;

/// Mean and standard deviation of the grey values in [0, 1], then median and 95th percentile of the
/// angles between lines and field in degrees, if the scene has a direction. The picture, RGB bytes,
/// must be a view of FlowScene::LookAlongZ(). NaN if its size differs.
std::vector<double> GetPictureFigures(
  const FlowScene& scene, int width, int height, const std::vector<unsigned char>& picture);

#endif
