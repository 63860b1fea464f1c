// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GLTFCheck.h"

#include "FileError.h"
#include "GLTFBuffers.h"

#include "vtkGLTFDocumentLoader.h"
#include "vtkNew.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <string>
#include <vector>

namespace
{
using Loader = vtkGLTFDocumentLoader;

class GLTFChecker
{
public:
  explicit GLTFChecker(Loader::Model& model)
    : Model(model)
  {
  }

  void Check()
  {
    this->CheckBuffers();
    this->CheckViews();
    this->CheckAccessors();
    this->CheckMeshes();
    this->CheckAnimations();
    this->CheckSkins();
    this->CheckNodes();
  }

private:
  static void Require(bool condition, const std::string& error)
  {
    if (!condition)
    {
      throw FileError(error);
    }
  }

  template <typename Index, typename Item>
  static bool IsIn(Index index, const std::vector<Item>& items)
  {
    return index >= 0 && static_cast<std::size_t>(index) < items.size();
  }

  void CheckAccessor(long long index, const std::string& user)
  {
    Require(IsIn(index, this->Model.Accessors),
      user + " refers to accessor " + std::to_string(index) + ", but there are " +
        std::to_string(this->Model.Accessors.size()));
    // VTK would write sparse values to the file's indices without checking these.
    Require(!this->Model.Accessors[index].IsSparse,
      user + " refers to accessor " + std::to_string(index) +
        ", which is sparse; sparse accessors are not supported");
  }

  void CheckBuffers()
  {
    this->Buffers = ParseGLTFBuffers(this->Model.BufferMetaData);
    const auto folder = std::filesystem::path(this->Model.FileName).parent_path();
    for (std::size_t i = 0; i < this->Buffers.size(); ++i)
    {
      GLTFBuffer& buffer = this->Buffers[i];
      if (buffer.URI.empty())
      {
        // Only the first buffer may use the binary chunk.
        buffer.ByteLength = i == 0 ? GetGLBLength(this->Model.FileName) : 0;
      }
      else if (buffer.URI.find("data:") != 0)
      {
        std::error_code unknown;
        Require(std::filesystem::is_regular_file(folder / buffer.URI, unknown),
          "its file " + buffer.URI + " does not exist");
        Require(static_cast<long long>(std::filesystem::file_size(folder / buffer.URI, unknown)) >=
            buffer.ByteLength,
          "its file " + buffer.URI + " is truncated");
      }
    }
  }

  void CheckViews()
  {
    for (std::size_t i = 0; i < this->Model.BufferViews.size(); ++i)
    {
      const Loader::BufferView& view = this->Model.BufferViews[i];
      const std::string name = "buffer view " + std::to_string(i);
      Require(IsIn(view.Buffer, this->Buffers),
        name + " refers to buffer " + std::to_string(view.Buffer) + ", but there are " +
          std::to_string(this->Buffers.size()));
      Require(view.ByteOffset >= 0 && view.ByteLength >= 0 && view.ByteStride >= 0 &&
          static_cast<long long>(view.ByteOffset) + view.ByteLength <=
            this->Buffers[view.Buffer].ByteLength,
        name + " is longer than its buffer");
    }
  }

  void CheckAccessors()
  {
    for (std::size_t i = 0; i < this->Model.Accessors.size(); ++i)
    {
      const Loader::Accessor& accessor = this->Model.Accessors[i];
      const std::string name = "accessor " + std::to_string(i);
      if (accessor.BufferView < 0)
      {
        continue; // contains zeros
      }
      Require(IsIn(accessor.BufferView, this->Model.BufferViews),
        name + " refers to buffer view " + std::to_string(accessor.BufferView) +
          ", but there are " + std::to_string(this->Model.BufferViews.size()));
      const Loader::BufferView& view = this->Model.BufferViews[accessor.BufferView];
      const long long element =
        static_cast<long long>(accessor.NumberOfComponents) * GetSize(accessor.ComponentTypeValue);
      const long long step = view.ByteStride > 0 ? view.ByteStride : element;
      Require(accessor.Count > 0 && accessor.ByteOffset >= 0 &&
          accessor.ByteOffset + (accessor.Count - 1) * step + element <= view.ByteLength,
        name + " is longer than its buffer view");
    }
  }

  static int GetSize(Loader::ComponentType type)
  {
    switch (type)
    {
      case Loader::ComponentType::BYTE:
      case Loader::ComponentType::UNSIGNED_BYTE:
        return 1;
      case Loader::ComponentType::SHORT:
      case Loader::ComponentType::UNSIGNED_SHORT:
        return 2;
      default:
        return 4;
    }
  }

  void CheckMeshes()
  {
    for (const Loader::Mesh& mesh : this->Model.Meshes)
    {
      for (const Loader::Primitive& primitive : mesh.Primitives)
      {
        Require(primitive.AttributeIndices.count("POSITION") > 0, "a primitive has no points");
        const long long points = primitive.AttributeIndices.at("POSITION");
        this->CheckAccessor(points, "POSITION");
        const int count = this->Model.Accessors[points].Count;
        this->CheckAttributes(primitive.AttributeIndices, count);
        for (const Loader::MorphTarget& target : primitive.Targets)
        {
          this->CheckAttributes(target.AttributeIndices, count);
        }
        if (primitive.IndicesId >= 0)
        {
          this->CheckAccessor(primitive.IndicesId, "a primitive");
          Require(this->Model.Accessors[primitive.IndicesId].BufferView >= 0,
            "the indices of a primitive have no buffer view");
        }
      }
    }
  }

  void CheckAttributes(const std::map<std::string, int>& attributes, int numberOfPoints)
  {
    for (const auto& attribute : attributes)
    {
      this->CheckAccessor(attribute.second, attribute.first);
      const int count = this->Model.Accessors[attribute.second].Count;
      Require(count == numberOfPoints,
        attribute.first + " has " + std::to_string(count) + " values, but there are " +
          std::to_string(numberOfPoints) + " points");
    }
  }

  void CheckAnimations()
  {
    for (const Loader::Animation& animation : this->Model.Animations)
    {
      for (const Loader::Animation::Sampler& sampler : animation.Samplers)
      {
        this->CheckAccessor(sampler.Input, "an animation");
        this->CheckAccessor(sampler.Output, "an animation");
      }
    }
  }

  void CheckSkins()
  {
    for (const Loader::Skin& skin : this->Model.Skins)
    {
      for (int joint : skin.Joints)
      {
        Require(IsIn(joint, this->Model.Nodes), "a skin refers to a node that does not exist");
      }
      if (skin.InverseBindMatricesAccessorId >= 0)
      {
        this->CheckAccessor(skin.InverseBindMatricesAccessorId, "a skin");
      }
    }
  }

  // Nodes form trees: no node has two parents or is its own ancestor.
  void CheckNodes()
  {
    std::vector<bool> isVisited(this->Model.Nodes.size(), false);
    std::vector<int> open;
    for (const Loader::Scene& scene : this->Model.Scenes)
    {
      std::fill(isVisited.begin(), isVisited.end(), false);
      open.assign(scene.Nodes.begin(), scene.Nodes.end());
      while (!open.empty())
      {
        const int index = open.back();
        open.pop_back();
        Require(IsIn(index, this->Model.Nodes),
          "the scene refers to node " + std::to_string(index) + ", which does not exist");
        const Loader::Node& node = this->Model.Nodes[index];
        Require(!isVisited[index], "node " + std::to_string(index) + " has two parents");
        isVisited[index] = true;
        Require(node.Mesh < 0 || IsIn(node.Mesh, this->Model.Meshes),
          "node " + std::to_string(index) + " has a mesh that does not exist");
        Require(node.Skin < 0 || IsIn(node.Skin, this->Model.Skins),
          "node " + std::to_string(index) + " has a skin that does not exist");
        open.insert(open.end(), node.Children.begin(), node.Children.end());
      }
    }
  }

  Loader::Model& Model;
  std::vector<GLTFBuffer> Buffers;
};

// Whether VTK's reader accepts the file. It throws exceptions of its JSON library if the text is
// not an object.
bool IsLoaded(Loader* loader, const std::string& fileName)
{
  try
  {
    return loader->LoadModelMetaDataFromFile(fileName);
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    return false;
  }
}
}

//------------------------------------------------------------------------------
void CheckGLTF(const std::string& fileName)
{
  vtkNew<Loader> loader;
  if (!HasCompleteChunks(fileName) || !IsLoaded(loader, fileName))
  {
    throw FileError("it is not a glTF scene, or it is truncated");
  }
  GLTFChecker(*loader->GetInternalModel()).Check();
}
