#include "mesh/ply.hpp"

#include <cassert>
#include <cfloat>
#include <cmath>
#include <optional>

#include "mesh/gzip.hpp"
#include "mesh/little_endian.hpp"
#include "mesh/ply_values.hpp"
#include "mesh/polygon.hpp"

namespace weft::mesh {
namespace {

/// Where the wanted values stand in the rows of the two elements that matter.
struct Layout {
  std::uint64_t vertex_count = 0;
  std::size_t axis_of[64] = {};  // vertex property -> 0, 1, 2; 3 for others
  std::size_t indices = 0;       // face property
};

const PlyElement* find_element(const PlyHeader& header, std::string_view name) {
  for (const PlyElement& element : header.elements)
    if (element.name == name) return &element;
  return nullptr;
}

Result<std::size_t> find_property(const PlyElement& element, std::string_view name,
                                  std::string_view other_name) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (element.properties[i].name != name && element.properties[i].name != other_name) continue;
    if (found)
      return input_error("Element %s has two properties %s.", element.name.c_str(),
                         std::string(name).c_str());
    found = i;
  }
  if (!found)
    return input_error("Element %s has no property %s.", element.name.c_str(), std::string(name).c_str());
  return *found;
}

Result<Layout> find_layout(const PlyHeader& header) {
  const PlyElement* vertex = find_element(header, "vertex");
  const PlyElement* face = find_element(header, "face");
  if (vertex == nullptr || face == nullptr)
    return input_error("The header has no element %s.", vertex == nullptr ? "vertex" : "face");
  Layout layout;
  layout.vertex_count = vertex->count;
  for (std::size_t& axis : layout.axis_of) axis = 3;
  static constexpr std::string_view kAxes[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    WEFT_TRY(index, find_property(*vertex, kAxes[axis], kAxes[axis]));
    if (vertex->properties[index].is_list)
      return input_error("Property %s of element vertex is a list.", std::string(kAxes[axis]).c_str());
    layout.axis_of[index] = axis;
  }
  WEFT_TRY(indices, find_property(*face, "vertex_indices", "vertex_index"));
  const PlyProperty& list = face->properties[indices];
  if (!list.is_list || !is_integer(list.type))
    return input_error("Property %s of element face is not a list of integers.", list.name.c_str());
  layout.indices = indices;
  return layout;
}

Error end_error(const std::string& place) {
  return input_error("The file ends after %s, before its data are complete.", place.c_str());
}

template <class Values>
Result<std::uint64_t> read_list_size(Values& values, const PlyProperty& property) {
  WEFT_TRY(size, values.read(property.count_type));
  const auto most = static_cast<double>(values.remaining() / values.least_size(property.type));
  if (size < 0.0 || size > most)
    return input_error(
        "The list \"%s\" at %s has the size %.0f, which is not in 0 to %.0f, all that the file can hold.",
        quoted(property.name).c_str(), values.place().c_str(), size, most);
  return static_cast<std::uint64_t>(size);
}

template <class Values>
Result<void> skip_property(Values& values, const PlyProperty& property) {
  std::uint64_t count = 1;
  if (property.is_list) {
    WEFT_TRY(size, read_list_size(values, property));
    count = size;
  }
  if (!values.skip(property.type, count)) return end_error(values.place());
  return {};
}

// No row count is believed that the bytes left cannot hold.
template <class Values>
Result<void> check_count(const Values& values, const PlyElement& element) {
  std::uint64_t row_size = 0;
  for (const PlyProperty& property : element.properties)
    row_size += values.least_size(property.is_list ? property.count_type : property.type);
  if (row_size == 0 || element.count <= values.remaining() / row_size) return {};  // a row may be empty
  return input_error("Element \"%s\" has %llu rows, but the file can hold at most %llu.",
                     quoted(element.name).c_str(), static_cast<unsigned long long>(element.count),
                     static_cast<unsigned long long>(values.remaining() / row_size));
}

template <class Values>
Result<void> skip_element(Values& values, const PlyElement& element) {
  if (element.properties.empty()) return {};  // however many rows, they take no space
  for (std::uint64_t row = 0; row < element.count; ++row)
    for (const PlyProperty& property : element.properties) WEFT_CHECK(skip_property(values, property));
  return {};
}

template <class Values>
Result<void> read_vertices(Values& values, const PlyElement& element, const Layout& layout,
                           TriangleMesh& mesh) {
  mesh.positions.resize(static_cast<std::size_t>(element.count));
  for (Vec3f& position : mesh.positions) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (layout.axis_of[i] == 3) {
        WEFT_CHECK(skip_property(values, property));
        continue;
      }
      WEFT_TRY(value, values.read(property.type));
      if (!(std::abs(value) <= static_cast<double>(FLT_MAX)))
        return input_error(
            "The coordinate %g at %s is not finite in single precision, where the largest is %.8e.", value,
            values.place().c_str(), static_cast<double>(FLT_MAX));
      position[static_cast<int>(layout.axis_of[i])] = static_cast<float>(value);
    }
  }
  return {};
}

// A pass of its own over its own copy of the values, so that the triangles are allocated once.
template <class Values>
Result<std::uint64_t> count_triangles(Values values, const PlyElement& element, const Layout& layout) {
  std::uint64_t triangles = 0;
  for (std::uint64_t row = 0; row < element.count; ++row)
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (i != layout.indices) {
        WEFT_CHECK(skip_property(values, property));
        continue;
      }
      WEFT_TRY(size, read_list_size(values, property));
      if (size < 3)
        return input_error("The face at %s has %d corners, fewer than 3.", values.place().c_str(),
                           static_cast<int>(size));
      if (!values.skip(property.type, size)) return end_error(values.place());
      triangles += fan_size(size);
    }
  return triangles;
}

template <class Values>
Result<void> read_faces(Values& values, const PlyElement& element, const Layout& layout, TriangleMesh& mesh) {
  WEFT_TRY(triangle_count, count_triangles(values, element, layout));
  mesh.triangles.reserve(static_cast<std::size_t>(triangle_count));
  for (std::uint64_t row = 0; row < element.count; ++row)
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (i != layout.indices) {
        WEFT_CHECK(skip_property(values, property));
        continue;
      }
      WEFT_TRY(size, read_list_size(values, property));
      PolygonFan fan(mesh.triangles);
      for (std::uint64_t corner = 0; corner < size; ++corner) {
        WEFT_TRY(vertex, values.read(property.type));
        if (vertex < 0.0 || vertex >= static_cast<double>(layout.vertex_count))
          return input_error("The face at %s names vertex %.0f, but the mesh has %llu vertices, from 0.",
                             values.place().c_str(), vertex,
                             static_cast<unsigned long long>(layout.vertex_count));
        fan.add(static_cast<std::uint32_t>(vertex));
      }
    }
  return {};
}

template <class Values>
Result<TriangleMesh> read_data(Values values, const PlyHeader& header, const Layout& layout) {
  TriangleMesh mesh;
  for (const PlyElement& element : header.elements) {
    WEFT_CHECK(check_count(values, element));
    if (element.name == "vertex")
      WEFT_CHECK(read_vertices(values, element, layout, mesh));
    else if (element.name == "face")
      WEFT_CHECK(read_faces(values, element, layout, mesh));
    else
      WEFT_CHECK(skip_element(values, element));
  }
  WEFT_CHECK(check_mesh(mesh));
  return mesh;
}

}  // namespace

Result<TriangleMesh> read_ply(std::span<const std::byte> bytes) {
  if (is_gzip(bytes)) {
    WEFT_TRY(unpacked, gunzip(bytes));
    if (is_gzip(unpacked)) return input_error("The gzip data hold gzip data again, not a PLY file.");
    return read_ply(unpacked);
  }
  WEFT_TRY(header, read_ply_header(bytes));
  WEFT_TRY(layout, find_layout(header));
  if (header.format == PlyFormat::Text) return read_data(PlyTextValues(bytes, header), header, layout);
  return read_data(PlyBinaryValues(bytes, header), header, layout);
}

std::string ply_begin(const std::string& comment) {
  assert(comment.find_first_of("\r\n") == std::string::npos);
  return "ply\nformat binary_little_endian 1.0\n" + (comment.empty() ? "" : "comment " + comment + "\n");
}

std::vector<std::byte> write_ply(const TriangleMesh& mesh, const std::string& comment,
                                 const VertexAttributes& attributes) {
  assert(check_mesh(mesh));
  std::string header = ply_begin(comment) + "element vertex " + std::to_string(mesh.positions.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\n";
  if (!attributes.normals.empty()) header += "property float nx\nproperty float ny\nproperty float nz\n";
  if (!attributes.texture.empty()) header += "property float s\nproperty float t\n";
  header += "element face " + std::to_string(mesh.triangles.size()) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
  std::vector<std::byte> bytes;
  bytes.reserve(header.size() + 32 * mesh.positions.size() + 13 * mesh.triangles.size());
  for (const char c : header) bytes.push_back(static_cast<std::byte>(c));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, mesh.positions[v][axis]);
    if (!attributes.normals.empty())
      for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, attributes.normals[v][axis]);
    if (!attributes.texture.empty())
      for (const float coordinate : attributes.texture[v]) append_little_endian(bytes, coordinate);
  }
  for (const Triangle& triangle : mesh.triangles) {
    bytes.push_back(std::byte{3});
    for (const std::uint32_t vertex : triangle) append_little_endian(bytes, vertex);
  }
  return bytes;
}

}  // namespace weft::mesh
