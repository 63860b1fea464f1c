// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   AtomicFile
 * @brief   a file that replaces an old one only when it is complete
 *
 * All writers of Relevo write through this class. The contents go into a temporary file in the
 * folder of the target, which Commit() renames onto the target:
 *
 *     AtomicFile file(fileName);
 *     file.Append(bytes); // or let a writer write into file.GetTemporaryName()
 *     if (!file.Commit())
 *     {
 *       vtkErrorMacro("Cannot write " << fileName << ": " << file.GetError());
 *     }
 *
 * Until then, and after any error, the old file stays as it was. The destructor, SIGINT, SIGTERM
 * and SIGHUP remove the temporary file; SIGKILL leaves it (IsTemporary() knows its name).
 *
 * A symbolic link stays, and the file it leads to is replaced. The new file has the permissions of
 * the old one, and its owner where that is allowed. A hard link to the old file keeps the old
 * contents. Devices, pipes and /dev/stdout are not replaced: they get the bytes of the complete
 * file.
 *
 * Private to the modules' own sources.
 */
#ifndef AtomicFile_h
#define AtomicFile_h

#include "Files/TemporaryFiles.h"
#include "RelevoFiltersCoreModule.h" // for export macro

#include <string>
#include <string_view>

namespace relevo
{
class RELEVOFILTERSCORE_EXPORT AtomicFile
{
public:
  explicit AtomicFile(const std::string& fileName);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  void operator=(const AtomicFile&) = delete;

  /// Why a file cannot be written, before the attempt; "" if it can. Makes no file.
  static std::string FindError(const std::string& fileName);
  /// Write a whole file; why that failed, or "".
  static std::string Write(const std::string& fileName, std::string_view bytes);
  /// Whether a file of this name, without folder, is one that SIGKILL has left.
  static bool IsTemporary(const std::string& name);

  /// Why the file cannot be written, in words that follow a colon; "" as long as it can.
  const std::string& GetError() const { return this->Error; }

  const std::string& GetFileName() const { return this->FileName; }

  /// The absolute path of the temporary file, with the extension of the target. It is there, and
  /// empty.
  const std::string& GetTemporaryName() const { return this->TemporaryName; }

  /// Write bytes behind those written by this method before; false after an error.
  bool Append(std::string_view bytes);

  /**
   * Give up, because a writer has failed or has left an incomplete file. The fault is that of the
   * disk if it takes no more bytes, else the given reason.
   */
  void Fail(const std::string& reason = "");

  /**
   * Bring the contents onto the disk, and close the temporary file. Commit() can only fail to
   * rename after this: several files can be finished first and then replaced together.
   */
  bool Finish();

  enum class OldFile
  {
    Replace,
    Keep ///< an error if there is one by now
  };

  /// Finish, and replace the target; false, and the old file stays, after any error.
  bool Commit(OldFile oldFile = OldFile::Replace);

private:
  void Open();
  void KeepAttributes();
  bool FailWithError(int error);
  bool CopyToDevice();
  void RemoveTemporary();

  std::string FileName;
  std::string Target; // FileName without symbolic links
  std::string TemporaryName;
  std::string Error;
  TemporaryFiles::Entry* Entry = nullptr;
  int Descriptor = -1;
  bool IsDevice = false;
  bool IsFinished = false;
};
}

#endif
