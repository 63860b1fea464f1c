// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Files of Bézier patches (.bpt): the reader, the patches of its cells, and their refinement.
#include "RelevoFuzz.h"
#include "RelevoFuzzAssert.h"
#include "RelevoFuzzFolder.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkBezierPatchReader.h"
#include "vtkNew.h"
#include "vtkPatchSurface.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkUnstructuredGrid.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  static const RelevoFuzzFolder folder;
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkBezierPatchReader> reader;
  const std::string file =
    folder.Write("a.bpt", std::string(reinterpret_cast<const char*>(bytes), size));
  reader->CanReadFile(file.c_str());
  reader->SetFileName(file.c_str());
  vtkNew<vtkPatchSurfaceFilter> patches;
  patches->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(1);
  recipe->SetSurface(vtkNew<vtkPatchSurface>());
  vtkNew<vtkAdaptiveRefinementFilter> refined;
  refined->SetInputConnection(patches->GetOutputPort());
  refined->SetRefinement(recipe);
  refined->Update();
  FUZZ_ASSERT(RelevoFuzz::IsFinite(refined->GetOutput()));
  return 0;
}
