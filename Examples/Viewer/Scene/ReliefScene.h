// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefScene
 * @brief   the reliefs of a folder
 */
#ifndef ReliefScene_h
#define ReliefScene_h

#include "Scene/ViewerScene.h"

#include "vtkSmartPointer.h"

class vtkActor;

class ReliefScene : public ViewerScene
{
public:
  /// Reads the files. Throws ViewerError.
  ReliefScene(const ViewerOptions& options, ViewerMessages& messages);
  ~ReliefScene() override;

  std::string Describe(const double[3], double) override { return ""; }
  void Draw(vtkRenderWindow* window) override;

private:
  void AddDataCode(SceneCode& code) override;

  vtkSmartPointer<vtkActor> Actor;
};

#endif
