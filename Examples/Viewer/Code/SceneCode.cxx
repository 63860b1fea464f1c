// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/SceneCode.h"

#include "vtkDataSet.h"
#include "vtkXMLDataObjectWriter.h"
#include "vtkXMLWriter.h"

#include <filesystem>

//------------------------------------------------------------------------------
SceneCode::SceneCode(const std::string& folder, const std::string& prefix)
  : Folder(folder.empty() ? "." : folder)
  , Prefix(prefix)
{
}

//------------------------------------------------------------------------------
CodeValue SceneCode::GetFile(const std::string& fileName) const
{
  std::error_code error;
  const auto relative =
    std::filesystem::absolute(fileName, error)
      .lexically_relative(std::filesystem::absolute(this->Folder, error).lexically_normal());
  return CodeValue::File(relative.empty() ? fileName : relative.generic_string());
}

//------------------------------------------------------------------------------
std::string SceneCode::AddData(vtkDataSet* data, const std::string& name)
{
  const auto writer = vtkSmartPointer<vtkXMLWriter>::Take(
    vtkXMLDataObjectWriter::NewWriter(data->GetDataObjectType()));
  const std::string fileName =
    this->Prefix + "-" + this->MakeName(name) + "." + writer->GetDefaultFileExtension();
  this->Data[fileName] = data;
  return fileName;
}

//------------------------------------------------------------------------------
void SceneCode::Note(const std::string& text)
{
  CodeStatement statement;
  statement.Text = text;
  this->Statements.push_back(statement);
}

//------------------------------------------------------------------------------
std::string SceneCode::MakeName(const std::string& name)
{
  const int number = ++this->Names[name];
  return number == 1 ? name : name + std::to_string(number);
}

//------------------------------------------------------------------------------
std::string SceneCode::New(const std::string& className, const std::string& name)
{
  CodeStatement statement;
  statement.Type = CodeStatement::Kind::New;
  statement.Class = className;
  statement.Object = this->MakeName(name);
  this->Classes.insert(className);
  this->Statements.push_back(statement);
  return statement.Object;
}

//------------------------------------------------------------------------------
std::string SceneCode::Get(const std::string& className, const std::string& name,
  const std::string& object, const std::string& method)
{
  CodeStatement statement;
  statement.Type = CodeStatement::Kind::Get;
  statement.Class = className;
  statement.Object = this->MakeName(name);
  statement.Source = object;
  statement.Method = method;
  this->Classes.insert(className);
  this->Statements.push_back(statement);
  return statement.Object;
}

//------------------------------------------------------------------------------
void SceneCode::Call(const std::string& object, const std::string& method, const Values& arguments)
{
  CodeStatement statement;
  statement.Type = CodeStatement::Kind::Call;
  statement.Object = object;
  statement.Method = method;
  statement.Arguments = arguments;
  for (const CodeValue& value : arguments)
  {
    if (value.Type == CodeValue::Kind::Constant)
    {
      this->Classes.insert(value.Text);
    }
  }
  this->Statements.push_back(statement);
}

//------------------------------------------------------------------------------
void SceneCode::Rows(const std::string& object, const std::string& method,
  const std::vector<std::vector<double>>& rows)
{
  CodeStatement statement;
  statement.Type = CodeStatement::Kind::Rows;
  statement.Object = object;
  statement.Method = method;
  statement.Rows = rows;
  this->Statements.push_back(statement);
}

//------------------------------------------------------------------------------
void SceneCode::CallFunction(
  const std::string& name, const CodeFunction& function, const Values& arguments)
{
  this->Functions[name] = function;
  this->Classes.insert(function.Classes.begin(), function.Classes.end());
  this->Call("", name, arguments);
}

//------------------------------------------------------------------------------
void SceneCode::Remember(vtkObjectBase* object, const CodeValue& value)
{
  this->Known.insert_or_assign(object, value);
}

//------------------------------------------------------------------------------
std::optional<CodeValue> SceneCode::Find(vtkObjectBase* object) const
{
  const auto known = this->Known.find(object);
  return known == this->Known.end() ? std::nullopt : std::optional<CodeValue>(known->second);
}
