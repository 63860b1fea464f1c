// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Database/ReliefSet.h"

#include "Data/Reliefs.h"
#include "Database/CSVFile.h"
#include "Database/ReliefFile.h"
#include "Database/ReliefTable.h"
#include "Files/TemporaryFiles.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

namespace fs = std::filesystem;

namespace relevo
{
namespace
{
constexpr const char* FilePrefix = "relief_";

// Returns a name such as "relief_0000.vti".
std::string MakeFileName(std::size_t number, const std::string& extension)
{
  std::string digits = std::to_string(number);
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  return FilePrefix + digits + extension;
}

// Returns the number in the name of a database file, or -1 for other files.
long FindNumber(const fs::path& name)
{
  const std::string stem = name.stem().string();
  const std::string extension = name.extension().string();
  const std::size_t prefix = std::string(FilePrefix).size();
  const std::string digits = stem.size() > prefix ? stem.substr(prefix) : "";
  const bool isOurs = stem.compare(0, prefix, FilePrefix) == 0 && digits.size() >= 4 &&
    digits.size() <= 9 && (extension == ".vti" || extension == ".png") &&
    std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c); });
  return isOurs ? std::stol(digits) : -1;
}

// Whether the table was written by vtkReliefDatabaseWriter or contains a relief.
bool IsDatabase(const std::string& folder)
{
  const ReliefTable table(folder);
  std::ifstream file(table.GetFileName(), std::ios::binary);
  const std::string heading = "name,projection,columns,rows,valid,";
  std::string begin(heading.size(), ' ');
  std::error_code unknown;
  if (fs::is_regular_file(table.GetFileName(), unknown) &&
    file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == heading)
  {
    return true;
  }
  for (std::size_t row = 0; row < table.GetNumberOfRows(); ++row)
  {
    std::string error;
    const std::string relief = table.FindFile(row, error);
    if (error.empty() && ReadReliefFile(relief, error))
    {
      return true;
    }
  }
  return false;
}

// Returns a file that is not a leftover of an interrupted write, preferably the table, or "".
std::string FindForeignFile(const std::string& folder)
{
  std::error_code unknown;
  std::string found;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, unknown))
  {
    const std::string name = file.path().filename().string();
    if (!AtomicFile::IsTemporary(name) && found != DatabaseTable &&
      (found.empty() || name < found || name == DatabaseTable))
    {
      found = name;
    }
  }
  return found;
}

// Returns the first of `count` consecutive free numbers: 0, or a number that is large enough for
// Renumber() to start from 0 when the old files have been removed.
std::size_t FindFreeNumbers(const fs::path& folder, std::size_t count)
{
  long highest = -1;
  bool areFirstFree = true;
  std::error_code unknown;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, unknown))
  {
    const long number = FindNumber(file.path().filename());
    highest = std::max(highest, number);
    areFirstFree = areFirstFree && (number < 0 || number >= static_cast<long>(count));
  }
  return areFirstFree ? 0 : std::max(static_cast<std::size_t>(highest + 1), count);
}
}

ReliefSet::ReliefSet(const std::string& folder, std::size_t maximumReliefs, bool hasPictures)
  : Folder(folder)
  , Extensions(
      hasPictures ? std::vector<std::string>{ ".vti", ".png" } : std::vector<std::string>{ ".vti" })
{
  std::error_code error;
  this->IsFolderNew = fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error))
  {
    this->Error = "The folder " + folder + " cannot be created.";
    return;
  }
  const std::string foreign = FindForeignFile(folder);
  if (!foreign.empty() && !IsDatabase(folder))
  {
    this->Error = "The folder " + folder + " cannot be written. It holds " + foreign +
      ", which does not belong to a relief database. Choose another folder.";
  }
  this->FirstNumber = FindFreeNumbers(folder, maximumReliefs);
}

ReliefSet::~ReliefSet()
{
  this->Files.clear();
  if (this->IsFolderNew)
  {
    std::error_code isNotEmpty;
    fs::remove(this->Folder, isNotEmpty);
  }
}

fs::path ReliefSet::GetPath(std::size_t number, const std::string& extension) const
{
  return this->Folder / MakeFileName(number, extension);
}

bool ReliefSet::Add(const ReliefBlock& block)
{
  for (const std::string& extension : this->Extensions)
  {
    const std::string path =
      this->GetPath(this->FirstNumber + this->Reliefs.size(), extension).string();
    this->Files.emplace_back(path);
    AtomicFile& file = this->Files.back();
    const bool isWritten = extension == ".vti" ? WriteReliefFile(block.Data, file)
                                               : WriteReliefPicture(block.Data, file);
    if (!isWritten || !file.Finish())
    {
      this->Error = "The file " + path + " cannot be written: " + file.GetError() + ".";
      return false;
    }
  }
  this->Reliefs.push_back(GetReliefParameters(block));
  return true;
}

std::string ReliefSet::FormatTable(std::size_t firstNumber) const
{
  std::vector<ReliefParameters> reliefs = this->Reliefs;
  for (std::size_t i = 0; i < reliefs.size(); ++i)
  {
    reliefs[i].emplace_back(FileColumn, MakeFileName(firstNumber + i, ".vti"));
    if (this->Extensions.size() > 1)
    {
      reliefs[i].emplace_back(
        std::string(FileColumn) + "_image", MakeFileName(firstNumber + i, ".png"));
    }
  }
  std::string text;
  for (const std::vector<std::string>& row : MakeTable(reliefs))
  {
    text += FormatCSV(row);
  }
  return text;
}

void ReliefSet::RemoveFiles(std::size_t firstNumber)
{
  std::error_code unknown;
  for (std::size_t i = 0; i < this->Reliefs.size(); ++i)
  {
    for (const std::string& extension : this->Extensions)
    {
      fs::remove(this->GetPath(firstNumber + i, extension), unknown);
    }
  }
}

bool ReliefSet::Commit()
{
  const std::string tableName = (this->Folder / DatabaseTable).string();
  AtomicFile table(tableName);
  table.Append(this->FormatTable(this->FirstNumber));
  if (table.Finish() && !this->RenameFiles())
  {
    return false;
  }
  if (!table.GetError().empty() || !table.Commit())
  {
    this->Error = "The file " + tableName + " cannot be written: " + table.GetError() + ".";
    this->RemoveFiles(this->FirstNumber);
    return false;
  }
  this->IsFolderNew = false;
  this->RemoveOldFiles();
  this->Renumber();
  return true;
}

// Renames all files or none. A signal handler removes renamed files meanwhile.
bool ReliefSet::RenameFiles()
{
  std::vector<std::string> names;
  std::vector<TemporaryFiles::Entry*> entries;
  for (AtomicFile& file : this->Files)
  {
    if (!file.Commit(AtomicFile::OldFile::Keep))
    {
      this->Error =
        "The file " + file.GetFileName() + " cannot be written: " + file.GetError() + ".";
      break;
    }
    names.push_back(file.GetFileName());
    entries.push_back(TemporaryFiles::Add(names.back()));
  }
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    std::error_code unknown;
    if (!this->Error.empty())
    {
      fs::remove(names[i], unknown);
    }
    TemporaryFiles::Forget(entries[i]);
  }
  return this->Error.empty();
}

void ReliefSet::RemoveOldFiles()
{
  std::error_code unknown;
  std::vector<fs::path> old;
  for (const fs::directory_entry& file : fs::directory_iterator(this->Folder, unknown))
  {
    const long number = FindNumber(file.path().filename());
    const long place = number - static_cast<long>(this->FirstNumber);
    const bool isNew = place >= 0 && place < static_cast<long>(this->Reliefs.size());
    if (number >= 0 && !isNew && file.is_regular_file(unknown))
    {
      old.push_back(file.path());
    }
  }
  for (const fs::path& path : old)
  {
    fs::remove(path, unknown);
  }
}

bool ReliefSet::LinkFiles(std::size_t to)
{
  std::error_code error;
  for (std::size_t i = 0; i < this->Reliefs.size(); ++i)
  {
    for (const std::string& extension : this->Extensions)
    {
      fs::create_hard_link(
        this->GetPath(this->FirstNumber + i, extension), this->GetPath(to + i, extension), error);
      if (error)
      {
        return false;
      }
    }
  }
  return true;
}

// Renumbers the reliefs from 0 if the file system has hard links, so that files have their new
// names before the table refers to them.
void ReliefSet::Renumber()
{
  if (this->FirstNumber == 0 || FindFreeNumbers(this->Folder, this->Reliefs.size()) != 0)
  {
    return;
  }
  const std::string table = (this->Folder / DatabaseTable).string();
  const bool isDone = this->LinkFiles(0) && AtomicFile::Write(table, this->FormatTable(0)).empty();
  this->RemoveFiles(isDone ? this->FirstNumber : 0);
}
}
