// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkReliefScene
 * @brief   a coloured ring with bumps and any number of triangles, and captures of it
 */
#ifndef BenchmarkReliefScene_h
#define BenchmarkReliefScene_h

#include "vtkSmartPointer.h"

#include <vector>

class BenchmarkView;
class vtkImageData;
class vtkMultiBlockDataSet;
class vtkPolyData;
class vtkPolyDataMapper;

class BenchmarkReliefScene
{
public:
  /// Has at least this many triangles, with point normals and colours.
  explicit BenchmarkReliefScene(double triangles);
  ~BenchmarkReliefScene();

  vtkPolyData* GetMesh() const { return this->Mesh; }
  vtkSmartPointer<vtkPolyDataMapper> MakeMapper() const;

  /// Adds a fixed light to the view, and looks at the ring.
  void SetUp(BenchmarkView& view) const;

  /// Four perspective reliefs of size x size texels, from the view, from 20 degrees to its left,
  /// and from 20 and 40 to its right. The camera is restored.
  vtkSmartPointer<vtkMultiBlockDataSet> Capture(BenchmarkView& view, int size) const;

private:
  vtkSmartPointer<vtkPolyData> Mesh;
};

/// Four parallel reliefs of size x size valid texels with waves, created without a window.
vtkSmartPointer<vtkMultiBlockDataSet> MakeWavyReliefs(int size);

/// The reliefs of a data set.
std::vector<vtkSmartPointer<vtkImageData>> GetReliefs(vtkMultiBlockDataSet* reliefs);

#endif
