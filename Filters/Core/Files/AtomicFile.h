// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   AtomicFile
 * @brief   a file that replaces an old file only when it is complete
 *
 * All writers of Relevo use this class. It writes to a temporary file in the folder of the target.
 * Commit() renames it to the target:
 *
 *     AtomicFile file(fileName);
 *     file.Append(bytes); // or let a writer write to file.GetTemporaryName()
 *     if (!file.Commit())
 *     {
 *       vtkErrorMacro("Cannot write " << fileName << ": " << file.GetError());
 *     }
 *
 * Until then, and after any error, the old file does not change. The destructor, SIGINT, SIGTERM
 * and SIGHUP remove the temporary file. SIGKILL leaves it; IsTemporary() recognises its name.
 *
 * If the target is a symbolic link, the file that it points to is replaced. The new file gets the
 * permissions of the old one, and its owner if possible. Hard links to the old file keep the old
 * contents. Devices, pipes and /dev/stdout are not replaced: the complete contents are written to
 * them.
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

  /// Return why a file cannot be written, or "" if it can. Does not create a file.
  static std::string FindError(const std::string& fileName);
  /// Write a whole file. Returns the error, or "".
  static std::string Write(const std::string& fileName, std::string_view bytes);
  /// Whether a file of this name, without folder, may be one that SIGKILL left.
  static bool IsTemporary(const std::string& name);

  /// Return why the file cannot be written, as a text to follow a colon, or "" if there is no
  /// error.
  const std::string& GetError() const { return this->Error; }

  const std::string& GetFileName() const { return this->FileName; }

  /// Return the absolute path of the temporary file, which has the extension of the target. The
  /// file exists and is empty.
  const std::string& GetTemporaryName() const { return this->TemporaryName; }

  /// Append bytes to those written by this method before. Returns false after an error.
  bool Append(std::string_view bytes);

  /**
   * Abort because a writer failed or wrote an incomplete file. If the disk is full, this is the
   * error. Otherwise, the given reason is.
   */
  void Fail(const std::string& reason = "");

  /**
   * Flush the contents to the disk and close the temporary file. After this, Commit() can fail only
   * in renaming. Several files can therefore be finished first and then replaced together.
   */
  bool Finish();

  enum class OldFile
  {
    Replace,
    Keep ///< an error if the file exists
  };

  /// Finish the file and replace the target. Returns false after any error; the old file then
  /// remains.
  bool Commit(OldFile oldFile = OldFile::Replace);

private:
  void Open();
  void KeepAttributes();
  bool FailWithError(int error);
  bool CopyToDevice();
  void RemoveTemporary();

  std::string FileName;
  std::string Target; // FileName with symbolic links resolved
  std::string TemporaryName;
  std::string Error;
  TemporaryFiles::Entry* Entry = nullptr;
  int Descriptor = -1;
  bool IsDevice = false;
  bool IsFinished = false;
};
}

#endif
