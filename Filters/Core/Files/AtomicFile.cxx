// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/AtomicFile.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <random>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace relevo
{
namespace
{
constexpr const char* TemporaryMark = ".part";

std::string Describe(int error)
{
  return std::generic_category().message(error);
}

struct WriteTarget
{
  std::string Error;
  std::string FileName; // absolute, without symbolic links
  bool IsDevice = false;
  bool IsThere = false;
};

fs::path GetFolder(const fs::path& file)
{
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// Links such as /dev/stdout point to open files, which cannot be replaced.
bool IsOpenFile(const fs::path& file)
{
  std::error_code unknown;
  const std::string folder = fs::canonical(GetFolder(file), unknown).string();
  return folder.compare(0, 6, "/proc/") == 0;
}

void FollowLinks(WriteTarget& target)
{
  constexpr int maximumLinks = 40; // the limit of Linux
  fs::path file = target.FileName;
  std::error_code unknown;
  for (int i = 0; i < maximumLinks; ++i)
  {
    if (IsOpenFile(file))
    {
      target.IsDevice = true;
      break;
    }
    if (!fs::is_symlink(fs::symlink_status(file, unknown)))
    {
      break;
    }
    file = GetFolder(file) / fs::read_symlink(file, unknown); // the link may be absolute
  }
  target.FileName = file.string();
}

// Returns why the target cannot be replaced or created, or "" if it can.
std::string FindTargetError(WriteTarget& target)
{
  const std::string folder = GetFolder(target.FileName).string();
  std::error_code unknown;
  if (!fs::is_directory(folder, unknown))
  {
    return "the folder " + folder + " does not exist";
  }
  struct stat status;
  target.IsThere = stat(target.FileName.c_str(), &status) == 0;
  if (!target.IsThere && errno != ENOENT)
  {
    return Describe(errno);
  }
  if (target.IsThere && S_ISDIR(status.st_mode))
  {
    return "it is a folder";
  }
  target.IsDevice = target.IsDevice || (target.IsThere && !S_ISREG(status.st_mode));
  if (target.IsThere && access(target.FileName.c_str(), W_OK) != 0)
  {
    return Describe(errno);
  }
  return target.IsDevice || access(folder.c_str(), W_OK | X_OK) == 0
    ? ""
    : Describe(errno) + " in the folder " + folder;
}

WriteTarget FindTarget(const std::string& fileName)
{
  WriteTarget target;
  if (fileName.empty())
  {
    target.Error = "the file name is empty";
    return target;
  }
  target.FileName = fileName;
  FollowLinks(target);
  target.Error = FindTargetError(target);
  std::error_code unknown;
  target.FileName = fs::absolute(target.FileName, unknown).string();
  return target;
}

std::string MakeTemporaryName(const std::string& fileName, const fs::path& folder)
{
  constexpr std::size_t longestStem = 60; // bytes; the name must fit into NAME_MAX
  constexpr std::size_t longestExtension = 20;
  const fs::path name = fs::path(fileName).filename();
  std::string stem = name.stem().string();
  std::string extension = name.extension().string();
  if (stem.size() > longestStem)
  {
    std::size_t end = longestStem;
    while (end > 0 && (stem[end] & 0xC0) == 0x80) // inside a UTF-8 character
    {
      --end;
    }
    stem.resize(end);
  }
  extension = extension.size() > longestExtension ? "" : extension;
  const char* letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::string mark;
  for (int i = 0; i < 8; ++i)
  {
    mark += letters[random() % 36];
  }
  return (folder / ("." + stem + "." + mark + TemporaryMark + extension)).string();
}

int WriteBytes(int descriptor, std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
    {
      return errno;
    }
    bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
  return 0;
}

// File systems that cannot synchronize return EINVAL or ENOTSUP.
int Synchronize(int descriptor)
{
  return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

// Never replaces a file.
int RenameToNew(const char* from, const char* to)
{
  if (link(from, to) == 0)
  {
    unlink(from);
    return 0;
  }
  if (errno == EEXIST || access(to, F_OK) == 0)
  {
    return EEXIST;
  }
  return std::rename(from, to) == 0 ? 0 : errno; // the file system has no hard links
}

// Flushes the file's new name to the disk. If this fails, the file itself is still complete.
void SynchronizeFolder(const std::string& fileName)
{
  const int folder = open(GetFolder(fileName).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0)
  {
    Synchronize(folder);
    close(folder);
  }
}
}

AtomicFile::AtomicFile(const std::string& fileName)
  : FileName(fileName)
{
  const WriteTarget target = FindTarget(fileName);
  this->Error = target.Error;
  this->Target = target.FileName;
  this->IsDevice = target.IsDevice;
  if (this->Error.empty())
  {
    this->Open();
  }
}

AtomicFile::~AtomicFile()
{
  this->RemoveTemporary();
}

std::string AtomicFile::FindError(const std::string& fileName)
{
  return FindTarget(fileName).Error;
}

std::string AtomicFile::Write(const std::string& fileName, std::string_view bytes)
{
  AtomicFile file(fileName);
  file.Append(bytes);
  file.Commit();
  return file.GetError();
}

bool AtomicFile::IsTemporary(const std::string& name)
{
  const std::string stem = fs::path(name).stem().string();
  return name.front() == '.' &&
    (fs::path(name).extension() == TemporaryMark || fs::path(stem).extension() == TemporaryMark);
}

void AtomicFile::Open()
{
  std::error_code error;
  const fs::path folder = this->IsDevice ? fs::temp_directory_path(error) : GetFolder(this->Target);
  if (error)
  {
    this->FailWithError(error.value());
    return;
  }
  do
  {
    this->RemoveTemporary();
    this->TemporaryName = MakeTemporaryName(this->FileName, folder);
    this->Entry = TemporaryFiles::Add(this->TemporaryName);
    this->Descriptor = open(this->TemporaryName.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC,
      this->IsDevice ? 0600 : 0666);
  } while (this->Descriptor < 0 && errno == EEXIST);
  if (this->Descriptor < 0)
  {
    this->FailWithError(errno);
  }
}

bool AtomicFile::Append(std::string_view bytes)
{
  const int error = this->Error.empty() ? WriteBytes(this->Descriptor, bytes) : 0;
  return error == 0 ? this->Error.empty() : this->FailWithError(error);
}

void AtomicFile::Fail(const std::string& reason)
{
  if (!this->Error.empty())
  {
    return;
  }
  // This is more than the free part of the last block of the file.
  const std::string bytes(1 << 16, '\0');
  const off_t end = lseek(this->Descriptor, 0, SEEK_END);
  const int error = end < 0 ? errno : WriteBytes(this->Descriptor, bytes);
  this->Error = error != 0 ? Describe(error)
    : reason.empty()       ? "the file is incomplete; the disk may be full"
                           : reason;
  this->RemoveTemporary();
}

bool AtomicFile::FailWithError(int error)
{
  this->Error = Describe(error);
  this->RemoveTemporary();
  return false;
}

void AtomicFile::KeepAttributes()
{
  struct stat old;
  struct stat made;
  if (this->IsDevice || stat(this->Target.c_str(), &old) != 0 ||
    fstat(this->Descriptor, &made) != 0)
  {
    return;
  }
  // Only root can change the owner of a file. Users can change its group to another of their
  // groups.
  const bool isOwned = old.st_uid == made.st_uid && old.st_gid == made.st_gid;
  if (!isOwned && fchown(this->Descriptor, old.st_uid, old.st_gid) != 0 &&
    fchown(this->Descriptor, static_cast<uid_t>(-1), old.st_gid) != 0)
  {
    errno = 0;
  }
  fchmod(this->Descriptor, old.st_mode & 0777);
}

bool AtomicFile::Finish()
{
  if (!this->Error.empty() || this->IsFinished)
  {
    return this->Error.empty();
  }
  struct stat written;
  struct stat made;
  if (stat(this->TemporaryName.c_str(), &written) != 0 || fstat(this->Descriptor, &made) != 0)
  {
    return this->FailWithError(errno);
  }
  if (written.st_ino != made.st_ino ||
    written.st_dev != made.st_dev) // a writer has replaced the file
  {
    close(this->Descriptor);
    this->Descriptor = open(this->TemporaryName.c_str(), O_RDWR | O_CLOEXEC);
    if (this->Descriptor < 0)
    {
      return this->FailWithError(errno);
    }
  }
  if (written.st_size == 0)
  {
    this->Fail("nothing was written");
    return false;
  }
  this->KeepAttributes();
  int error = Synchronize(this->Descriptor);
  const int closeError = close(this->Descriptor) == 0 ? 0 : errno;
  this->Descriptor = -1;
  error = error == 0 ? closeError : error;
  this->IsFinished = error == 0;
  return error == 0 || this->FailWithError(error);
}

bool AtomicFile::CopyToDevice()
{
  const int from = open(this->TemporaryName.c_str(), O_RDONLY | O_CLOEXEC);
  const int to =
    from < 0 ? -1 : open(this->Target.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY);
  int error = from < 0 || to < 0 ? errno : 0;
  std::vector<char> buffer(1 << 20);
  while (error == 0)
  {
    const ssize_t count = read(from, buffer.data(), buffer.size());
    error = count < 0 ? errno : WriteBytes(to, { buffer.data(), static_cast<std::size_t>(count) });
    if (count == 0)
    {
      break;
    }
  }
  if (to >= 0 && close(to) != 0 && error == 0)
  {
    error = errno;
  }
  if (from >= 0)
  {
    close(from);
  }
  return error == 0 || this->FailWithError(error);
}

bool AtomicFile::Commit(OldFile oldFile)
{
  if (!this->Finish())
  {
    return false;
  }
  if (this->IsDevice)
  {
    const bool isCopied = this->CopyToDevice();
    this->RemoveTemporary();
    return isCopied;
  }
  const char* from = this->TemporaryName.c_str();
  const char* to = this->Target.c_str();
  const int error = oldFile == OldFile::Keep ? RenameToNew(from, to)
    : std::rename(from, to) == 0             ? 0
                                             : errno;
  if (error != 0)
  {
    return this->FailWithError(error);
  }
  TemporaryFiles::Forget(this->Entry);
  this->Entry = nullptr;
  SynchronizeFolder(this->Target);
  return true;
}

void AtomicFile::RemoveTemporary()
{
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
    this->Descriptor = -1;
  }
  if (this->Entry)
  {
    unlink(this->TemporaryName.c_str());
    TemporaryFiles::Forget(this->Entry);
    this->Entry = nullptr;
  }
}
}
