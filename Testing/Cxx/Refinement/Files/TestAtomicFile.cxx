// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that a file always has either its old or its complete new content, after errors, signals
// and races and for links. Permissions are kept.
#include "Files/AtomicFile.h"
#include "Files/WriteFile.h"
#include "RelevoCheck.h"
#include "RelevoFiles.h"

#include "vtkImageData.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataWriter.h"

#include <csignal>
#include <filesystem>
#include <functional>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
using relevo::AtomicFile;

const std::string Old = "old";
const std::string New(100000, 'n');

int CountFiles(const std::string& folder)
{
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

mode_t GetMode(const std::string& fileName)
{
  struct stat status = {};
  stat(fileName.c_str(), &status);
  return status.st_mode & 07777;
}

// Exit status of a child process that runs `work`.
int RunChild(const std::function<void()>& work)
{
  const pid_t child = fork();
  if (child == 0)
  {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

void TestReplace(RelevoCheck& check, const std::string& folder)
{
  const std::string name = folder + "/a.txt";
  const mode_t mask = umask(022);
  CHECK(AtomicFile::FindError(name).empty() && CountFiles(folder) == 0);
  CHECK(AtomicFile::Write(name, Old).empty());
  CHECK_EQUAL(RelevoReadFile(name), Old);
  CHECK_EQUAL(GetMode(name), 0644);
  CHECK_EQUAL(CountFiles(folder), 1);
  chmod(name.c_str(), 0600);
  {
    AtomicFile file(name);
    CHECK(file.Append(New.substr(0, 7)) && RelevoReadFile(name) == Old);
    const fs::path temporary = file.GetTemporaryName();
    CHECK(temporary.extension() == ".txt" && AtomicFile::IsTemporary(temporary.filename()));
    CHECK_EQUAL(fs::file_size(temporary), 7);
    CHECK(file.Append(New.substr(7)) && file.Finish() && RelevoReadFile(name) == Old);
    CHECK(file.Commit() && RelevoReadFile(name) == New && GetMode(name) == 0600);
  }
  CHECK(CountFiles(folder) == 1 && !AtomicFile::IsTemporary("a.txt"));
  {
    AtomicFile file(name); // discarded without Commit()
    file.Append("x");
  }
  CHECK_EQUAL(RelevoReadFile(name), New);
  CHECK_EQUAL(CountFiles(folder), 1);
  CHECK_EQUAL(AtomicFile::Write(name, ""), "nothing was written");
  CHECK_EQUAL(RelevoReadFile(name), New);
  const std::string longName = folder + "/" + std::string(240, 'l') + ".txt";
  CHECK(AtomicFile::Write(longName, Old).empty() && RelevoReadFile(longName) == Old);
  umask(mask);
}

void TestKeep(RelevoCheck& check, const std::string& folder)
{
  const std::string name = folder + "/new.txt";
  AtomicFile first(name);
  AtomicFile second(name);
  CHECK(first.Append("1") && second.Append("2"));
  CHECK(first.Commit(AtomicFile::OldFile::Keep));
  CHECK(!second.Commit(AtomicFile::OldFile::Keep) && second.GetError() == "File exists");
  CHECK_EQUAL(RelevoReadFile(name), "1");
  CHECK_EQUAL(CountFiles(folder), 1);
}

void TestLinks(RelevoCheck& check, const std::string& folder)
{
  RelevoMakeFolder(folder + "/inside");
  const std::string file = folder + "/inside/file";
  const std::string link = folder + "/link";
  fs::create_symlink("inside/file", link); // dangling link
  fs::create_symlink("link", folder + "/chain");
  for (const std::string& name : { link, folder + "/chain" })
  {
    CHECK_CASE(name);
    CHECK(AtomicFile::Write(name, name).empty());
    CHECK(fs::is_symlink(name) && !fs::is_symlink(file) && RelevoReadFile(file) == name);
  }
  CHECK_EQUAL(CountFiles(folder), 3);
  CHECK_EQUAL(CountFiles(folder + "/inside"), 1);
  fs::create_symlink("circle", folder + "/circle");
  CHECK_NOT_EQUAL(
    AtomicFile::Write(folder + "/circle", Old).find("ymbolic links"), std::string::npos);
  fs::create_symlink("nowhere/file", folder + "/broken");
  CHECK_EQUAL(AtomicFile::Write(folder + "/broken", Old).find("the folder "), 0);
}

void TestErrors(RelevoCheck& check, const std::string& folder)
{
  CHECK_EQUAL(AtomicFile::Write("", Old), "the file name is empty");
  CHECK_EQUAL(AtomicFile::Write(folder, Old), "it is a folder");
  RelevoWriteFile(folder + "/file", Old);
  CHECK_EQUAL(
    AtomicFile::Write(folder + "/file/x", Old), "the folder " + folder + "/file does not exist");
  CHECK_EQUAL(AtomicFile::Write(folder + "/" + std::string(300, 'x'), Old), "File name too long");
  AtomicFile file(folder + "/file");
  CHECK(file.Append(New));
  fs::remove(file.GetTemporaryName()); // as some of VTK's writers do on a full disk
  CHECK(!file.Commit() && file.GetError() == "No such file or directory");
  CHECK_EQUAL(RelevoReadFile(folder + "/file"), Old);
  if (geteuid() == 0)
  {
    return; // this user may write everywhere
  }
  chmod((folder + "/file").c_str(), 0400);
  CHECK_EQUAL(AtomicFile::Write(folder + "/file", New), "Permission denied");
  chmod((folder + "/file").c_str(), 0600);
  chmod(folder.c_str(), 0500);
  CHECK_EQUAL(
    AtomicFile::Write(folder + "/file", New), "Permission denied in the folder " + folder);
  CHECK_EQUAL(RelevoReadFile(folder + "/file"), Old);
  chmod(folder.c_str(), 0700);
}

void TestDevices(RelevoCheck& check, const std::string& folder)
{
  if (fs::exists("/dev/full"))
  {
    CHECK_EQUAL(AtomicFile::Write("/dev/full", Old), "No space left on device");
    CHECK(fs::is_character_file("/dev/full"));
  }
  CHECK(AtomicFile::Write("/dev/null", Old).empty() && fs::is_character_file("/dev/null"));
  const std::string pipe = folder + "/pipe";
  mkfifo(pipe.c_str(), 0600);
  std::string read;
  std::thread reader([&]() { read = RelevoReadFile(pipe); });
  const std::string error = AtomicFile::Write(pipe, New);
  reader.join();
  CHECK(error.empty() && read == New && fs::is_fifo(pipe));

  // The target of a redirected standard output is not replaced.
  const std::string name = folder + "/output";
  RunChild(
    [&]()
    {
      if (std::freopen(name.c_str(), "w", stdout))
      {
        std::puts("before");
        std::fflush(stdout);
        AtomicFile::Write("/dev/stdout", "bytes\n");
      }
    });
  const std::string output = RelevoReadFile(name);
  CHECK_EQUAL(output, "before\nbytes\n");
}

// Writes files beyond the process's size limit. The signal for this does not end the process.
void TestFullDisk(RelevoCheck& check, const std::string& folder)
{
  const std::string names[] = { folder + "/a.bin", folder + "/a.png", folder + "/a.vti" };
  for (const std::string& name : names)
  {
    RelevoWriteFile(name, Old);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(200, 200, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  unsigned int random = 1; // random bytes, which do not compress
  for (int i = 0; i < 3 * 200 * 200; ++i)
  {
    random = 1664525u * random + 1013904223u;
    bytes[i] = static_cast<unsigned char>(random >> 24);
  }
  vtkNew<vtkPNGWriter> png;
  png->SetInputData(image);
  vtkNew<vtkXMLImageDataWriter> xml;
  xml->SetInputData(image);
  const std::function<std::string()> writes[] = { [&]()
    { return AtomicFile::Write(names[0], New); },
    [&]()
    {
      AtomicFile file(names[1]);
      relevo::WritePNG(file, png.Get());
      file.Commit();
      return file.GetError();
    },
    [&]() { return relevo::WriteFile(names[2], xml.Get(), relevo::IsWholeXML); } };
  for (int i = 0; i < 3; ++i)
  {
    for (rlim_t limit : { 1, 1000, 4096, 20000 }) // the limit may also fall into the last buffer
    {
      const int status = RunChild(
        [&]()
        {
          const rlimit most = { limit, limit };
          setrlimit(RLIMIT_FSIZE, &most);
          _exit(writes[i]() == "File too large" ? 7 : 8);
        });
      CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 7);
      CHECK_EQUAL(RelevoReadFile(names[i]), Old);
      CHECK_EQUAL(CountFiles(folder), 3);
    }
    CHECK(writes[i]().empty() && fs::file_size(names[i]) > 20000);
  }
  CHECK(relevo::IsWholeXML(names[2]) && !relevo::IsWholeXML(folder + "/none"));
  RelevoWriteFile(names[2], RelevoReadFile(names[2]).substr(0, 9000));
  CHECK(!relevo::IsWholeXML(names[2]));
}

void TestSignals(RelevoCheck& check, const std::string& folder)
{
  const std::string name = folder + "/a.txt";
  RelevoWriteFile(name, Old);
  for (int signal : { SIGINT, SIGTERM, SIGHUP, SIGKILL })
  {
    CHECK_CASE(signal);
    const int status = RunChild(
      [&]()
      {
        AtomicFile other(name);
        AtomicFile file(name);
        file.Append(New);
        other.Append(New);
        other.Finish();
        raise(signal);
      });
    CHECK(WIFSIGNALED(status) && WTERMSIG(status) == signal);
    CHECK_EQUAL(RelevoReadFile(name), Old);
    CHECK_EQUAL(CountFiles(folder), (signal == SIGKILL ? 3 : 1));
  }
  for (const fs::directory_entry& file : fs::directory_iterator(folder))
  {
    CHECK(file.path() == name || AtomicFile::IsTemporary(file.path().filename()));
  }
}

// The application's signal handlers are called, and the default handlers are restored.
void TestHandlers(RelevoCheck& check, const std::string& folder)
{
  const std::string name = folder + "/a.txt";
  static volatile sig_atomic_t calls = 0;
  std::signal(SIGTERM, [](int) { calls = calls + 1; });
  std::signal(SIGHUP, SIG_IGN);
  {
    AtomicFile file(name);
    file.Append(New);
    raise(SIGTERM);
    raise(SIGHUP);
    CHECK(calls == 1 && file.Commit() && RelevoReadFile(name) == New);
  }
  CHECK(std::signal(SIGTERM, SIG_DFL) != SIG_DFL && std::signal(SIGHUP, SIG_DFL) == SIG_IGN);
  CHECK_EQUAL(std::signal(SIGINT, SIG_DFL), SIG_DFL);
  // A child process that ends does not remove its parent's files.
  AtomicFile file(name);
  file.Append(Old);
  const int status = RunChild([]() { raise(SIGTERM); });
  CHECK(WIFSIGNALED(status) && file.Commit() && RelevoReadFile(name) == Old);
}
}

int TestAtomicFile(int argc, char* argv[])
{
  RelevoCheck check;
  const std::string folder = RelevoMakeFolder(argc, argv, "AtomicFile");
  const auto run = [&](const char* name, void (*test)(RelevoCheck&, const std::string&))
  {
    RelevoMakeFolder(folder + "/" + name);
    test(check, folder + "/" + name);
  };
  run("Replace", TestReplace);
  run("Keep", TestKeep);
  run("Links", TestLinks);
  run("Faults", TestErrors);
  run("Devices", TestDevices);
  run("FullDisk", TestFullDisk);
  run("Signals", TestSignals);
  run("Handlers", TestHandlers);
  return check.GetResult();
}
