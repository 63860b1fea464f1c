// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SceneFactory.h"

#include "Options/ViewerOptions.h"
#include "Scene/ContactScene.h"
#include "Scene/MeshScene.h"
#include "Scene/PyramidScene.h"
#include "Scene/ReliefScene.h"
#include "Scene/TerrainScene.h"
#include "Scene/VolumeScene.h"

namespace
{
std::unique_ptr<ViewerScene> Open(const ViewerOptions& options, ViewerMessages& messages)
{
  if (options.IsDatabase)
  {
    return std::make_unique<ReliefScene>(options, messages);
  }
  if (!options.Against.empty())
  {
    return std::make_unique<ContactScene>(options, messages);
  }
  if (options.IsVolume)
  {
    return std::make_unique<VolumeScene>(options, messages);
  }
  if (options.IsMesh)
  {
    return std::make_unique<MeshScene>(options, messages);
  }
  if (options.IsTiled)
  {
    if (std::unique_ptr<ViewerScene> scene = PyramidScene::Open(options, messages))
    {
      return scene;
    }
  }
  return std::make_unique<TerrainScene>(options, messages);
}
}

//------------------------------------------------------------------------------
std::unique_ptr<ViewerScene> MakeScene(const ViewerOptions& options, ViewerMessages& messages)
{
  std::unique_ptr<ViewerScene> scene = Open(options, messages);
  if (options.Ruler)
  {
    const std::vector<double>& ends = *options.Ruler;
    scene->ShowRuler({ { ends[0], ends[1], ends[2] } }, { { ends[3], ends[4], ends[5] } });
  }
  return scene;
}
