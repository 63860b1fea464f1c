// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Example of a dense mesh: encodes it within a tolerance, writes it to a file, reads the file and
 * returns a mesh with an error that is chosen later. Prints the numbers of triangles.
 */
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkMicroMeshErrorDepthTagMetric.h"
#include "vtkMicroMeshFilter.h"
#include "vtkMicroMeshReader.h"
#include "vtkMicroMeshSurface.h"
#include "vtkMicroMeshWriter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSuperquadricSource.h"

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkSuperquadricSource> scan; // stands for a scan
  scan->ToroidalOn();
  scan->SetPhiRoundness(0.6);
  scan->SetThetaResolution(64);
  scan->SetPhiResolution(64);

  vtkNew<vtkMicroMeshFilter> encode;
  encode->SetInputConnection(scan->GetOutputPort());
  encode->SetTolerance(0.005); // a length
  vtkNew<vtkMicroMeshWriter> writer;
  writer->SetInputConnection(encode->GetOutputPort());
  writer->SetFileName("scan.rmm");
  if (writer->Write() != 1)
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkMicroMeshReader> reader;
  reader->SetFileName("scan.rmm");
  vtkNew<vtkMicroMeshErrorDepthTagMetric> metric;
  metric->SetMaximumError(0.01); // a length; in a mapper, use SetScreenSpaceError()
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(vtkNew<vtkMicroMeshSurface>());
  recipe->SetMetric(metric);
  recipe->SetLevelRuleToPerEdge();
  recipe->SetMaximumLevel(encode->GetMaximumLevel());
  vtkNew<vtkAdaptiveRefinementFilter> refine;
  refine->SetInputConnection(reader->GetOutputPort());
  refine->SetRefinement(recipe);
  refine->Update();

  const vtkIdType input = vtkPolyData::SafeDownCast(encode->GetInput())->GetNumberOfCells();
  const vtkIdType result = refine->GetOutput()->GetNumberOfPolys();
  std::cout << input << " cells, " << encode->GetOutput()->GetNumberOfPolys()
            << " coarse faces within " << encode->GetError() << ", " << result
            << " triangles within " << encode->GetError() + metric->GetMaximumError() << "\n";
  return encode->GetError() <= encode->GetTolerance() && result > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
