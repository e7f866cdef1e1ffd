#include "mesh_files.hpp"

#include <zlib.h>

#include <cmath>
#include <cstdio>
#include <cstring>

namespace weft::mesh {
namespace {

constexpr PlyType kTypes[] = {PlyType::Int8,  PlyType::Uint8,  PlyType::Int16,   PlyType::Uint16,
                              PlyType::Int32, PlyType::Uint32, PlyType::Float32, PlyType::Float64};
constexpr const char* kNames[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                     {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                     {"float", "float32"}, {"double", "float64"}};

std::string bits_of(float value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }

std::string exact(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

}  // namespace

TriangleMesh cube() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 2, 1},
           {0, 3, 2},
           {4, 5, 6},
           {4, 6, 7},
           {0, 1, 5},
           {0, 5, 4},
           {2, 3, 7},
           {2, 7, 6},
           {1, 2, 6},
           {1, 6, 5},
           {3, 0, 4},
           {3, 4, 7}}};
}

TriangleMesh random_mesh(Random& random) {
  TriangleMesh mesh;
  mesh.positions.resize(1 + random.below(50));
  for (Vec3f& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) do {
        const std::uint32_t bits = random.next();
        std::memcpy(&p[axis], &bits, sizeof bits);
      } while (!std::isfinite(p[axis]));
  mesh.triangles.resize(1 + random.below(60));
  for (Triangle& t : mesh.triangles)
    for (auto& vertex : t) vertex = random.below(static_cast<std::uint32_t>(mesh.positions.size()));
  return mesh;
}

bool same_bits(const TriangleMesh& a, const TriangleMesh& b) {
  return a.triangles == b.triangles && a.positions.size() == b.positions.size() &&
         std::memcmp(a.positions.data(), b.positions.data(), a.positions.size() * sizeof(Vec3f)) == 0;
}

std::string gzip(std::string_view text) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string text_stl(const TriangleMesh& mesh) {
  std::string text = "solid a cube\n";
  for (const Triangle& t : mesh.triangles) {
    text += "  facet normal nan 0 1\n    outer loop\n";
    for (const auto vertex : t) {
      text += "      vertex";
      for (int axis = 0; axis < 3; ++axis)
        text += ' ' + exact(static_cast<double>(mesh.positions[vertex][axis]));
      text += '\n';
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a cube\n";
}

std::string binary_stl(const TriangleMesh& mesh, std::string_view header) {
  std::string text(header);
  text.resize(80);
  text += ply_value(PlyFormat::BinaryLittle, PlyType::Uint32, static_cast<double>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    text += std::string(12, '\0');
    for (const auto vertex : t)
      for (int axis = 0; axis < 3; ++axis) text += bits_of(mesh.positions[vertex][axis]);
    text += "ab";
  }
  return text;
}

std::string glb_file(std::string json, std::string binary) {
  const auto word = [](std::size_t value) {
    return ply_value(PlyFormat::BinaryLittle, PlyType::Uint32, static_cast<double>(value));
  };
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  return "glTF" + word(2) + word(12 + 8 + json.size() + 8 + binary.size()) + word(json.size()) + "JSON" +
         json + word(binary.size()) + std::string("BIN\0", 4) + binary;
}

std::string elaborate_glb() {
  std::string binary;
  for (const Vec3f& p : cube().positions) {
    for (int axis = 0; axis < 3; ++axis) binary += bits_of(2 * p[axis]);
    binary += "abcd";  // a colour, as it were
  }
  for (const Triangle& t : cube().triangles)
    for (const auto vertex : t) binary += static_cast<char>(vertex);
  return glb_file(
      R"({"asset": {"version": "2.0", "generator": "a test"}, "scene": 1, "extensionsUsed": ["KHR_x"],
    "extensionsRequired": ["KHR_materials_unlit"],
    "scenes": [{"name": "empty"}, {"nodes": [2]}],
    "nodes": [{"mesh": 0, "scale": [0.5, 0.5, 0.5]}, {"camera": 0},
              {"children": [1, 0], "translation": [0, 0, 0], "rotation": [0, 0, 0, 1]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 1, "COLOR_0": 2}, "indices": 0, "mode": 4}]}],
    "accessors": [{"bufferView": 1, "componentType": 5121, "count": 36, "type": "SCALAR"},
                  {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 128, "byteStride": 16},
                    {"buffer": 0, "byteOffset": 128, "byteLength": 36}],
    "buffers": [{"byteLength": 164}]})",
      binary);
}

std::string text_off(const TriangleMesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.positions.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3f& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) text += exact(static_cast<double>(p[axis])) + " ";
    text += '\n';
  }
  for (const Triangle& t : mesh.triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  return text;
}

std::string ply_value(PlyFormat format, PlyType type, double value) {
  if (format == PlyFormat::Text) return exact(value) + " ";
  std::string bytes;
  if (type == PlyType::Float32) {
    bytes = bits_of(static_cast<float>(value));
  } else if (type == PlyType::Float64) {
    bytes = std::string(reinterpret_cast<const char*>(&value), sizeof value);
  } else {
    const auto integer = static_cast<std::int64_t>(value);
    bytes = std::string(reinterpret_cast<const char*>(&integer), size_of(type));
  }
  return format == PlyFormat::BinaryBig ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string elaborate_ply(PlyFormat format, const TriangleMesh& mesh, std::uint32_t seed) {
  Random random(seed);
  const auto name_of = [&](PlyType type) {
    return std::string(kNames[static_cast<int>(type)][random.below(2)]);
  };
  struct Property {
    PlyType type;
    int role;  // 0 to 2: axis; 3: indices; 4: a number; 5: a list
  };
  std::string header = "ply\nformat ";
  header += format == PlyFormat::Text           ? "ascii 1.0\n"
            : format == PlyFormat::BinaryLittle ? "binary_little_endian 1.0\n"
                                                : "binary_big_endian 1.0\n";
  header += "comment element vertex 7\nobj_info x y\n";
  std::string data;
  const auto add_element = [&](const std::string& name, std::size_t rows, std::vector<int> roles) {
    header += "element " + name + " " + std::to_string(rows) + "\n";
    std::vector<Property> properties;
    for (std::size_t i = 0; i <= roles.size(); ++i) {
      for (std::uint32_t more = random.below(3); more > 0; --more)
        properties.push_back({kTypes[random.below(8)], 4 + static_cast<int>(random.below(2))});
      if (i == roles.size()) break;
      const bool is_index = roles[i] == 3;
      properties.push_back({is_index ? kTypes[random.below(6)] : kTypes[6 + random.below(2)], roles[i]});
    }
    for (std::size_t i = 0; i < properties.size(); ++i) {
      const auto [type, role] = properties[i];
      header += "property " +
                std::string(role == 3 || role == 5 ? "list " + name_of(PlyType::Uint8) + " " : "") +
                name_of(type) + " " +
                (role < 3    ? std::string(1, "xyz"[role])
                 : role == 3 ? "vertex_index"
                             : "p" + std::to_string(i)) +
                "\n";
    }
    for (std::size_t row = 0; row < rows; ++row)
      for (const auto& [type, role] : properties) {
        if (role < 3) {
          data += ply_value(format, type, static_cast<double>(mesh.positions[row][role]));
        } else if (role == 3) {
          data += ply_value(format, PlyType::Uint8, 3);
          for (const auto vertex : mesh.triangles[row]) data += ply_value(format, type, vertex);
        } else {
          const std::uint32_t count = role == 4 ? 1 : random.below(4);
          if (role == 5) data += ply_value(format, PlyType::Uint8, count);
          for (std::uint32_t i = 0; i < count; ++i) data += ply_value(format, type, random.below(100));
        }
        if (format == PlyFormat::Text && random.below(3) == 0) data += "\n";
      }
  };
  std::vector<int> axes = {0, 1, 2};
  std::swap(axes[0], axes[random.below(3)]);
  add_element("material", random.below(5), {});
  if (random.below(2) == 0) {
    add_element("vertex", mesh.positions.size(), axes);
    add_element("edge", random.below(5), {});
    add_element("face", mesh.triangles.size(), {3});
  } else {
    add_element("face", mesh.triangles.size(), {3});
    add_element("vertex", mesh.positions.size(), axes);
  }
  return header + "end_header\n" + data;
}

std::string changed(std::string bytes, std::span<const std::string_view> tokens, Random& random) {
  for (std::uint32_t count = 1 + random.below(4); count > 0 && !bytes.empty(); --count) {
    const auto at = random.below(static_cast<std::uint32_t>(bytes.size()));
    const std::size_t size = 1 + random.below(random.below(4) == 0 ? 200 : 4);
    switch (random.below(7)) {
      case 0:
        bytes[at] = static_cast<char>(random.next());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
        break;
      case 2:
        bytes.erase(at, size);
        break;
      case 3:
        bytes.insert(at, bytes.substr(random.below(static_cast<std::uint32_t>(bytes.size())), size));
        break;
      case 4:
        bytes.insert(at, tokens[random.below(static_cast<std::uint32_t>(tokens.size()))]);
        break;
      case 5:
        bytes.replace(at, std::min(size, bytes.size() - at),
                      tokens[random.below(static_cast<std::uint32_t>(tokens.size()))]);
        break;
      default:
        if (random.below(8) == 0) bytes.resize(at);
    }
  }
  return bytes;
}

}  // namespace weft::mesh
