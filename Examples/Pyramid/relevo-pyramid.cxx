// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   copies a height raster into a file with overviews
 */
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkTerrainPyramidWriter.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <unistd.h>

namespace
{
enum ExitCode
{
  Success = 0,
  BadInput = 1,
  BadUsage = 2
};

const char* const Usage =
  "Usage: relevo-pyramid IN OUT [options]\n"
  "\n"
  "Copy the first band of the raster IN, any that GDAL reads, into the tiled BigTIFF OUT with\n"
  "overviews. Samples, georeference, no-data value, scale, offset and unit are kept. Then make "
  "the\n"
  "index OUT.relevo-index, so that terrains are drawn without a delay. An interrupted run is\n"
  "resumed by the next one with the same arguments.\n"
  "\n"
  "Options:\n"
  "  --compression deflate|zstd|lzw|none\n"
  "                         lossless compression (default deflate)\n"
  "  --no-index             do not make the index; the first program that opens OUT makes it\n"
  "  --help                 print this text and exit\n"
  "  --version              print the version of Relevo and exit\n"
  "\n"
  "Exit code: 0 for success, 1 for bad input or output, 2 for wrong arguments.\n";

volatile std::sig_atomic_t IsInterrupted = 0;

void Interrupt(int)
{
  IsInterrupted = 1;
}

int Fail(ExitCode code, const std::string& message)
{
  std::cerr << "relevo-pyramid: error: " << message << std::endl;
  return code;
}

void ShowProgress(vtkObject* caller, unsigned long, void*, void* data)
{
  auto* writer = static_cast<vtkTerrainPyramidWriter*>(caller);
  const bool isIndex = writer->GetStep() == vtkTerrainPyramidWriter::INDEX;
  static int shown = -1;
  const int percent = static_cast<int>(std::floor(100.0 * *static_cast<double*>(data)));
  if (percent != shown && isatty(STDERR_FILENO))
  {
    shown = percent;
    std::cerr << (isIndex ? "\rindexing " : "\rwriting ") << percent << " % " << std::flush;
  }
  if (IsInterrupted)
  {
    writer->AbortExecuteOn();
  }
}

int Write(const std::string& input, const std::string& output, int compression, bool hasIndex)
{
  std::signal(SIGINT, &Interrupt);
  std::signal(SIGTERM, &Interrupt);
  vtkNew<vtkTerrainPyramidWriter> writer;
  vtkNew<vtkCallbackCommand> progress;
  progress->SetCallback(&ShowProgress);
  writer->AddObserver(vtkCommand::ProgressEvent, progress);
  writer->GlobalWarningDisplayOff();
  writer->SetInputFileName(input.c_str());
  writer->SetFileName(output.c_str());
  writer->SetCompression(compression);
  writer->SetWriteIndex(hasIndex);
  const bool isDone = writer->Write();
  if (isatty(STDERR_FILENO))
  {
    std::cerr << "\r               \r" << std::flush;
  }
  if (isDone)
  {
    return Success;
  }
  const std::string error = writer->GetErrorMessage();
  return Fail(BadInput,
    error.empty() ? "interrupted; the same command goes on from where it stopped" : error);
}
}

int main(int argc, char* argv[])
{
  const std::map<std::string, int> compressions = { { "none", vtkTerrainPyramidWriter::NONE },
    { "deflate", vtkTerrainPyramidWriter::DEFLATE }, { "lzw", vtkTerrainPyramidWriter::LZW },
    { "zstd", vtkTerrainPyramidWriter::ZSTD } };
  const std::string option = "--compression";
  int compression = vtkTerrainPyramidWriter::DEFLATE;
  bool hasIndex = true;
  std::vector<std::string> names;
  bool isOption = true;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const bool isJoined = argument.rfind(option + "=", 0) == 0;
    if (isOption && argument == "--help")
    {
      std::cout << Usage;
      return Success;
    }
    if (isOption && argument == "--version")
    {
      std::cout << "relevo-pyramid " << RELEVO_VERSION << std::endl;
      return Success;
    }
    if (isOption && (argument == option || isJoined))
    {
      const std::string value =
        isJoined ? argument.substr(option.size() + 1) : (i + 1 < argc ? argv[++i] : "");
      if (compressions.count(value) == 0)
      {
        return Fail(BadUsage,
          "--compression must be deflate, zstd, lzw or none, got '" + value +
            "' (see relevo-pyramid --help)");
      }
      compression = compressions.at(value);
    }
    else if (isOption && argument == "--no-index")
    {
      hasIndex = false;
    }
    else if (isOption && argument == "--")
    {
      isOption = false;
    }
    else if (isOption && argument.size() > 1 && argument[0] == '-')
    {
      return Fail(BadUsage, "unknown option " + argument + " (see relevo-pyramid --help)");
    }
    else
    {
      names.push_back(argument);
    }
  }
  if (names.size() != 2)
  {
    return Fail(
      BadUsage, "give the raster to read and the file to write (see relevo-pyramid --help)");
  }
  return Write(names[0], names[1], compression, hasIndex);
}
