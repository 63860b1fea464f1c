// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/GLBWriter.h"

#include "Files/AtomicFile.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace
{
// Numbers of glTF and of OpenGL.
constexpr std::uint32_t GLBMagic = 0x46546C67; // "glTF"
constexpr std::uint32_t JSONChunk = 0x4E4F534A;
constexpr std::uint32_t BinaryChunk = 0x004E4942;
constexpr int Floats = 5126;
constexpr int UnsignedInts = 5125;
constexpr int VertexBuffer = 34962;
constexpr int IndexBuffer = 34963;
constexpr int LinearFilter = 9729;
constexpr int LinearMipmapLinear = 9987;
constexpr int ClampToEdge = 33071;

constexpr std::size_t GLBAlignment = 4;
constexpr std::uint64_t LargestGLB = std::numeric_limits<std::uint32_t>::max();

template <typename Number>
void AppendNumber(std::string& bytes, Number number)
{
  char copy[sizeof(number)];
  std::memcpy(copy, &number, sizeof(number)); // glTF is little-endian, as all platforms of VTK
  bytes.append(copy, sizeof(number));
}

class GLBFile
{
public:
  explicit GLBFile(const ExportedMesh& source)
    : Source(source)
  {
  }

  // Returns an error message, or an empty string.
  std::string Build(const std::function<void(double)>& progress)
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(this->Source.Mesh);
    triangles->PassVertsOff();
    triangles->PassLinesOff();
    vtkNew<vtkPolyDataNormals> normals; // keeps those of the mesh
    normals->SetInputConnection(triangles->GetOutputPort());
    normals->SplittingOff();
    normals->ConsistencyOff();
    const bool hasNormals = this->Source.Mesh->GetPointData()->GetNormals() != nullptr;
    if (hasNormals)
    {
      triangles->Update();
    }
    else
    {
      normals->Update();
    }
    this->Mesh = hasNormals ? triangles->GetOutput() : normals->GetOutput();
    if (this->Mesh->GetNumberOfPolys() == 0)
    {
      return "the mesh has no triangles";
    }
    const std::uint64_t floats = 8 * static_cast<std::uint64_t>(this->Mesh->GetNumberOfPoints());
    const std::uint64_t indices = 3 * static_cast<std::uint64_t>(this->Mesh->GetNumberOfPolys());
    if (4 * (floats + indices) > LargestGLB)
    {
      return "it would have more than 4 GiB, the limit of the format; use a larger --tolerance";
    }
    progress(0.2);
    Json::Value primitive(Json::objectValue);
    Json::Value& attributes = primitive["attributes"];
    attributes["POSITION"] = this->AddPositions();
    attributes["NORMAL"] = this->AddVectors(this->Mesh->GetPointData()->GetNormals(), 3, "VEC3");
    if (vtkDataArray* coordinates = this->Mesh->GetPointData()->GetTCoords())
    {
      attributes["TEXCOORD_0"] = this->AddTextureCoordinates(coordinates);
    }
    primitive["indices"] = this->AddIndices();
    progress(0.5);
    primitive["material"] = 0;
    primitive["mode"] = 4; // triangles
    this->Root["meshes"][0]["primitives"][0] = primitive;
    this->AddMaterial();
    this->AddNode();
    progress(0.8);
    return "";
  }

  std::string Write(const std::string& fileName)
  {
    this->Root["asset"]["version"] = "2.0";
    this->Root["asset"]["generator"] = "relevo-view";
    this->Root["buffers"][0]["byteLength"] = static_cast<Json::UInt64>(this->Bytes.size());
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "";
    std::string text = Json::writeString(builder, this->Root);
    text.resize((text.size() + GLBAlignment - 1) / GLBAlignment * GLBAlignment, ' ');
    const std::uint64_t length = 28 + std::uint64_t(text.size()) + this->Bytes.size();
    if (length > LargestGLB)
    {
      return "it would have more than 4 GiB, the limit of the format";
    }
    std::string header;
    AppendNumber(header, GLBMagic);
    AppendNumber(header, std::uint32_t(2));
    AppendNumber(header, static_cast<std::uint32_t>(length));
    AppendNumber(header, static_cast<std::uint32_t>(text.size()));
    AppendNumber(header, JSONChunk);
    std::string middle;
    AppendNumber(middle, static_cast<std::uint32_t>(this->Bytes.size()));
    AppendNumber(middle, BinaryChunk);
    relevo::AtomicFile file(fileName);
    file.Append(header) && file.Append(text) && file.Append(middle) && file.Append(this->Bytes);
    file.Commit();
    return file.GetError();
  }

private:
  // Returns the number of the view of the bytes that were appended since `begin`.
  int AddView(std::size_t begin, int target)
  {
    Json::Value view(Json::objectValue);
    view["buffer"] = 0;
    view["byteOffset"] = static_cast<Json::UInt64>(begin);
    view["byteLength"] = static_cast<Json::UInt64>(this->Bytes.size() - begin);
    if (target != 0)
    {
      view["target"] = target;
    }
    this->Bytes.resize((this->Bytes.size() + GLBAlignment - 1) / GLBAlignment * GLBAlignment, '\0');
    Json::Value& views = this->Root["bufferViews"];
    views.append(view);
    return static_cast<int>(views.size()) - 1;
  }

  int AddAccessor(Json::Value accessor, int view, int component, vtkIdType count, const char* type)
  {
    accessor["bufferView"] = view;
    accessor["componentType"] = component;
    accessor["count"] = static_cast<Json::Int64>(count);
    accessor["type"] = type;
    Json::Value& accessors = this->Root["accessors"];
    accessors.append(accessor);
    return static_cast<int>(accessors.size()) - 1;
  }

  int AddPositions()
  {
    const std::size_t begin = this->Bytes.size();
    const vtkIdType count = this->Mesh->GetNumberOfPoints();
    std::array<float, 3> low;
    std::array<float, 3> high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (vtkIdType i = 0; i < count; ++i)
    {
      double point[3];
      this->Mesh->GetPoint(i, point);
      for (int axis = 0; axis < 3; ++axis)
      {
        const float position = static_cast<float>(point[axis] - this->Source.Origin[axis]);
        low[axis] = std::min(low[axis], position);
        high[axis] = std::max(high[axis], position);
        AppendNumber(this->Bytes, position);
      }
    }
    Json::Value accessor(Json::objectValue);
    for (int axis = 0; axis < 3; ++axis)
    {
      accessor["min"].append(low[axis]);
      accessor["max"].append(high[axis]);
    }
    return this->AddAccessor(accessor, this->AddView(begin, VertexBuffer), Floats, count, "VEC3");
  }

  int AddVectors(vtkDataArray* values, int components, const char* type)
  {
    const std::size_t begin = this->Bytes.size();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        AppendNumber(this->Bytes, static_cast<float>(values->GetComponent(i, c)));
      }
    }
    return this->AddAccessor(Json::objectValue, this->AddView(begin, VertexBuffer), Floats,
      values->GetNumberOfTuples(), type);
  }

  // v points down in glTF.
  int AddTextureCoordinates(vtkDataArray* values)
  {
    const std::size_t begin = this->Bytes.size();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      AppendNumber(this->Bytes, static_cast<float>(values->GetComponent(i, 0)));
      AppendNumber(this->Bytes, static_cast<float>(1.0 - values->GetComponent(i, 1)));
    }
    return this->AddAccessor(Json::objectValue, this->AddView(begin, VertexBuffer), Floats,
      values->GetNumberOfTuples(), "VEC2");
  }

  int AddIndices()
  {
    const std::size_t begin = this->Bytes.size();
    vtkCellArray* polygons = this->Mesh->GetPolys();
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
    {
      polygons->GetCellAtId(cell, ids);
      for (vtkIdType i = 0; i < 3; ++i)
      {
        AppendNumber(this->Bytes, static_cast<std::uint32_t>(ids->GetId(i)));
      }
    }
    return this->AddAccessor(Json::objectValue, this->AddView(begin, IndexBuffer), UnsignedInts,
      3 * polygons->GetNumberOfCells(), "SCALAR");
  }

  void AddMaterial()
  {
    Json::Value& surface = this->Root["materials"][0]["pbrMetallicRoughness"];
    surface["metallicFactor"] = 0.0;
    surface["roughnessFactor"] = 1.0;
    if (!this->Source.Picture)
    {
      return;
    }
    surface["baseColorTexture"]["index"] = 0;
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(this->Source.Picture);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* png = writer->GetResult();
    const std::size_t begin = this->Bytes.size();
    this->Bytes.append(reinterpret_cast<const char*>(png->GetPointer(0)),
      static_cast<std::size_t>(png->GetNumberOfValues()));
    this->Root["images"][0]["bufferView"] = this->AddView(begin, 0);
    this->Root["images"][0]["mimeType"] = "image/png";
    Json::Value& sampler = this->Root["samplers"][0];
    sampler["magFilter"] = LinearFilter;
    sampler["minFilter"] = LinearMipmapLinear;
    sampler["wrapS"] = ClampToEdge;
    sampler["wrapT"] = ClampToEdge;
    this->Root["textures"][0]["sampler"] = 0;
    this->Root["textures"][0]["source"] = 0;
  }

  // Axes are cycled so that the up axis becomes y.
  void AddNode()
  {
    Json::Value node(Json::objectValue);
    node["mesh"] = 0;
    node["name"] = "relevo-view";
    for (const std::string& comment : this->Source.Comments)
    {
      node["extras"]["comments"].append(comment);
    }
    const int up = this->Source.UpAxis;
    double rows[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
    if (up == 2) // (x, z, -y)
    {
      std::swap(rows[1], rows[2]);
      rows[2][1] = -1.0;
    }
    else if (up == 0) // (-y, x, z)
    {
      std::swap(rows[0], rows[1]);
      rows[0][1] = -1.0;
    }
    const std::array<double, 3>& origin = this->Source.Origin;
    Json::Value& matrix = node["matrix"]; // column by column
    for (int column = 0; column < 4; ++column)
    {
      for (const auto& row : rows)
      {
        matrix.append(
          column < 3 ? row[column] : row[0] * origin[0] + row[1] * origin[1] + row[2] * origin[2]);
      }
      matrix.append(column < 3 ? 0.0 : 1.0);
    }
    this->Root["nodes"][0] = node;
    this->Root["scenes"][0]["nodes"][0] = 0;
    this->Root["scene"] = 0;
  }

  const ExportedMesh& Source;
  vtkSmartPointer<vtkPolyData> Mesh;
  Json::Value Root{ Json::objectValue };
  std::string Bytes; // of the binary chunk
};
}

//------------------------------------------------------------------------------
std::string WriteGLB(const ExportedMesh& mesh, const std::string& fileName,
  const std::function<void(double)>& progress)
{
  GLBFile file(mesh);
  const std::string error = file.Build(progress);
  return error.empty() ? file.Write(fileName) : error;
}
