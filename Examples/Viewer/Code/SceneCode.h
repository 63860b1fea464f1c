// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneCode
 * @brief   the statements of a program that draws a scene, in no particular language
 *
 * PythonCode and CxxCode write them as a Python script and as C++.
 */
#ifndef SceneCode_h
#define SceneCode_h

#include "Code/CodeValue.h"

#include "vtkSmartPointer.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

class vtkDataSet;
class vtkObjectBase;

struct CodeStatement
{
  enum class Kind
  {
    Note, // a comment
    New,  // a new object of a class
    Get,  // a variable for the result of a method
    Call, // of a method, or of a function if there is no object
    Rows  // calls of a method with each row of numbers
  };

  Kind Type = Kind::Note;
  std::string Text;  // of the comment
  std::string Class; // of the variable
  std::string Object;
  std::string Source; // the object of the method in Get
  std::string Method;
  std::vector<CodeValue> Arguments = {};
  std::vector<std::vector<double>> Rows = {};
};

/// A function that the statements call.
struct CodeFunction
{
  std::string Python;
  std::string Cxx;
  std::set<std::string> Classes = {};
};

class SceneCode
{
public:
  using Values = std::vector<CodeValue>;

  /// The program will be in this folder. Files that it needs have this prefix.
  SceneCode(const std::string& folder, const std::string& prefix);

  void Note(const std::string& text);
  /// Makes a variable for a new object. Its name is unique.
  std::string New(const std::string& className, const std::string& name);
  /// Makes a variable for the result of a method.
  std::string Get(const std::string& className, const std::string& name, const std::string& object,
    const std::string& method);
  void Call(const std::string& object, const std::string& method, const Values& arguments = {});
  void Rows(const std::string& object, const std::string& method,
    const std::vector<std::vector<double>>& rows);
  /// Calls a function, named as in C++.
  void CallFunction(const std::string& name, const CodeFunction& function, const Values& arguments);

  /// The name of a file, relative to the folder of the program if it exists.
  CodeValue GetFile(const std::string& fileName) const;
  /// A data set that must be written beside the program. Returns the name of its file.
  std::string AddData(vtkDataSet* data, const std::string& name);
  const std::map<std::string, vtkSmartPointer<vtkDataSet>>& GetData() const { return this->Data; }

  //@{
  /// The value that stands for an object of the scene, such as an output port for a mesh.
  void Remember(vtkObjectBase* object, const CodeValue& value);
  std::optional<CodeValue> Find(vtkObjectBase* object) const;
  //@}

  const std::vector<CodeStatement>& GetStatements() const { return this->Statements; }
  const std::map<std::string, CodeFunction>& GetFunctions() const { return this->Functions; }
  /// The classes of VTK and Relevo that occur.
  const std::set<std::string>& GetClasses() const { return this->Classes; }

private:
  std::string MakeName(const std::string& name);

  std::string Folder;
  std::string Prefix;
  std::vector<CodeStatement> Statements;
  std::map<std::string, CodeFunction> Functions;
  std::set<std::string> Classes;
  std::map<std::string, int> Names;
  std::map<vtkObjectBase*, CodeValue> Known;
  std::map<std::string, vtkSmartPointer<vtkDataSet>> Data; // by the names of files
};

#endif
