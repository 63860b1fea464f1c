// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A folder for the files that a fuzz target writes for each input.
#ifndef RelevoFuzzFolder_h
#define RelevoFuzzFolder_h

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include <unistd.h>

class RelevoFuzzFolder
{
public:
  RelevoFuzzFolder()
  {
    const std::filesystem::path memory = "/dev/shm";
    this->Path =
      (std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path()) /
      ("relevo-fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directories(this->Path);
  }
  ~RelevoFuzzFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }
  RelevoFuzzFolder(const RelevoFuzzFolder&) = delete;
  void operator=(const RelevoFuzzFolder&) = delete;

  std::string GetPath() const { return this->Path.string(); }
  std::string GetFile(const std::string& name) const { return (this->Path / name).string(); }

  // Writes a file and returns its path.
  std::string Write(const std::string& name, const std::string& bytes) const
  {
    const std::string file = this->GetFile(name);
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }

private:
  std::filesystem::path Path;
};

#endif
