// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks of mesh files before VTK's readers read them. The first byte chooses the format.
#include "FileEnd.h"
#include "FileError.h"
#include "GLTFCheck.h"
#include "RelevoFuzz.h"
#include "RelevoFuzzFolder.h"

#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  static const RelevoFuzzFolder folder;
  static const std::vector<std::string> formats = { ".ply", ".obj", ".gltf", ".glb", ".stl", ".ex2",
    ".vtp", ".vtu", ".pvtu" };
  vtkObject::GlobalWarningDisplayOff();
  RelevoFuzz::Dice dice(bytes, size);
  const std::string extension = dice.Choose(formats);
  const std::string file = folder.Write("a" + extension, dice.TakeBytes());
  try
  {
    CheckFileEnd(file, [](const std::string&) {});
    if (extension == ".gltf" || extension == ".glb")
    {
      CheckGLTF(file);
    }
  }
  catch (const FileError&)
  {
    return 0; // the only exception of damaged files
  }
  return 0;
}
