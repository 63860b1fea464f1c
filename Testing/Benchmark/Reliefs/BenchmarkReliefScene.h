// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkReliefScene
 * @brief   a coloured ring with bumps, of any number of triangles, and captures of it
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
  /// At least so many triangles, with normals and colours of points.
  explicit BenchmarkReliefScene(double triangles);
  ~BenchmarkReliefScene();

  vtkPolyData* GetMesh() const { return this->Mesh; }
  vtkSmartPointer<vtkPolyDataMapper> MakeMapper() const;

  /// Lights the view with a lamp that stands still, and looks at the ring.
  void SetUp(BenchmarkView& view) const;

  /// Four reliefs of size x size texels, in perspective, from the view and from 20 degrees to its
  /// left, 20 and 40 to its right; the camera stays where it is.
  vtkSmartPointer<vtkMultiBlockDataSet> Capture(BenchmarkView& view, int size) const;

private:
  vtkSmartPointer<vtkPolyData> Mesh;
};

/// Four parallel reliefs of size x size texels, wavy, all valid, made without a window.
vtkSmartPointer<vtkMultiBlockDataSet> MakeWavyReliefs(int size);

/// The reliefs of a data set.
std::vector<vtkSmartPointer<vtkImageData>> GetReliefs(vtkMultiBlockDataSet* reliefs);

#endif
