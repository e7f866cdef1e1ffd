#include "tet_files.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace weft::mesh {
namespace {

// The bits of a value; the machines that run the tests are little-endian.
template <class T>
std::string raw(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::string decimal(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

/// Appends numbers as text or bytes.
class NumberWriter {
 public:
  NumberWriter(bool binary, bool big_endian) : binary_(binary), big_endian_(big_endian) {}
  template <class T>
  NumberWriter& add(T value) {
    if (!binary_) {
      text += decimal(static_cast<double>(value)) + " ";
      return *this;
    }
    std::string bytes = raw(value);
    if (big_endian_) std::reverse(bytes.begin(), bytes.end());
    text += bytes;
    return *this;
  }
  NumberWriter& integer(std::int64_t value) { return add(static_cast<std::int32_t>(value)); }
  NumberWriter& wide(std::int64_t value) { return add(value); }
  NumberWriter& end() {
    if (!binary_) text += "\n";
    return *this;
  }

  std::string text;

 private:
  bool binary_, big_endian_;
};

std::int64_t tag(const TetFile& file, std::size_t vertex) {
  return std::int64_t{file.first} + std::int64_t{file.step} * static_cast<std::int64_t>(vertex);
}

std::string format(const char* version, const TetFile& file) {
  return std::string("$MeshFormat\n") + version +
         (file.binary ? " 1 8\n" + raw(std::int32_t{1}) + "\n" : " 0 8\n") + "$EndMeshFormat\n";
}

// A node behind all others, so that numbers are not in order.
void add_point(NumberWriter& to, const Vec3f& x) {
  for (int axis = 0; axis < 3; ++axis) to.add(static_cast<double>(x[axis]));
}

}  // namespace

std::string msh_2(const TetMesh& mesh, const TetFile& file) {
  std::string text = format("2.2", file);
  if (file.with_others) text += "$PhysicalNames\n1\n3 7 \"a $Nodes body\"\n$EndPhysicalNames\n";
  NumberWriter nodes(file.binary, false);
  for (std::size_t i = mesh.positions.size(); i-- > 0;) {
    nodes.integer(tag(file, i));
    add_point(nodes, mesh.positions[i]);
    nodes.end();
  }
  text += "$Nodes\n" + std::to_string(mesh.positions.size()) + "\n" + nodes.text + "$EndNodes\n";

  NumberWriter elements(file.binary, false);
  std::size_t count = 0;
  const auto add = [&](std::int64_t type, const std::vector<std::uint32_t>& corners) {
    ++count;
    if (file.binary) elements.integer(type).integer(1).integer(2).integer(static_cast<std::int64_t>(count));
    if (!file.binary) elements.integer(static_cast<std::int64_t>(count)).integer(type).integer(2);
    elements.integer(7).integer(70);
    for (const std::uint32_t corner : corners) elements.integer(tag(file, corner));
    elements.end();
  };
  if (file.with_others) {
    add(15, {0});
    add(2, {0, 1, 2});
    add(5, {0, 1, 2, 3, 0, 1, 2, 3});
  }
  for (const Tet& tet : mesh.tets) add(4, {tet.begin(), tet.end()});
  if (file.with_others) add(11, {0, 1, 2, 3, 0, 1, 2, 3, 0, 1});
  text += "$Elements\n" + std::to_string(count) + "\n" + elements.text + "$EndElements\n";
  if (file.with_others) text += "$NodeData\n1\n\"x\"\n$EndNodeData\n";
  return text;
}

std::string msh_4(const TetMesh& mesh, const TetFile& file) {
  std::string text = format("4.1", file);
  if (file.with_others) text += "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 0 0\n$EndEntities\n";
  const auto total = static_cast<std::int64_t>(mesh.positions.size());
  const std::int64_t half = total / 2;
  NumberWriter nodes(file.binary, false);
  nodes.wide(file.with_others ? 3 : 2).wide(total).wide(1).wide(tag(file, mesh.positions.size())).end();
  const auto add_block = [&](std::int64_t begin, std::int64_t end, int dimension) {
    const bool parametric = dimension < 3;
    nodes.integer(dimension).integer(5).integer(parametric ? 1 : 0).wide(end - begin).end();
    for (std::int64_t i = begin; i < end; ++i) nodes.wide(tag(file, static_cast<std::size_t>(i))).end();
    for (std::int64_t i = begin; i < end; ++i) {
      add_point(nodes, mesh.positions[static_cast<std::size_t>(i)]);
      for (int k = 0; parametric && k < dimension; ++k) nodes.add(0.25);
      nodes.end();
    }
  };
  add_block(half, total, file.with_others ? 2 : 3);
  if (file.with_others) add_block(0, 0, 0);
  add_block(0, half, 3);
  text += "$Nodes\n" + nodes.text + "$EndNodes\n";

  NumberWriter elements(file.binary, false);
  const auto tets = static_cast<std::int64_t>(mesh.tets.size());
  elements.wide(file.with_others ? 2 : 1)
      .wide(tets + (file.with_others ? 2 : 0))
      .wide(1)
      .wide(tets + 2)
      .end();
  if (file.with_others) {
    elements.integer(2).integer(1).integer(2).wide(2).end();
    for (int i = 0; i < 2; ++i) {
      elements.wide(i);
      for (std::size_t corner = 0; corner < 3; ++corner) elements.wide(tag(file, corner));
      elements.end();
    }
  }
  elements.integer(3).integer(1).integer(4).wide(tets).end();
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    elements.wide(static_cast<std::int64_t>(t));
    for (const std::uint32_t corner : mesh.tets[t]) elements.wide(tag(file, corner));
    elements.end();
  }
  return text + "$Elements\n" + elements.text + "$EndElements\n";
}

namespace {

std::string vtk_begin(const char* version, const TetMesh& mesh, const TetFile& file) {
  std::string text = std::string("# vtk DataFile Version ") + version + "\na title of a $mesh\n" +
                     (file.binary ? "BINARY" : "ASCII") + "\nDATASET UNSTRUCTURED_GRID\n";
  if (file.with_others) {
    NumberWriter field(file.binary, true);
    field.add(0.5).add(1.5).end();
    text += "FIELD FieldData 1\ntime 1 2 double\n" + field.text + "\n";
  }
  NumberWriter points(file.binary, true);
  for (const Vec3f& x : mesh.positions) {
    if (file.is_double) add_point(points, x);
    if (!file.is_double) points.add(x.x).add(x.y).add(x.z);
    points.end();
  }
  return text + "POINTS " + std::to_string(mesh.positions.size()) +
         (file.is_double ? " double\n" : " float\n") + points.text + "\n";
}

// Cells of VTK with their types, tetrahedra and others between them.
std::vector<std::pair<int, std::vector<std::uint32_t>>> vtk_cells(const TetMesh& mesh, bool with_others) {
  std::vector<std::pair<int, std::vector<std::uint32_t>>> cells;
  if (with_others) cells.push_back({5, {0, 1, 2}});
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    cells.push_back({10, {mesh.tets[t].begin(), mesh.tets[t].end()}});
    if (with_others && t == 0) cells.push_back({14, {0, 1, 2, 3, 0}});
  }
  if (with_others) cells.push_back({1, {0}});
  return cells;
}

std::string vtk_types(const TetMesh& mesh, const TetFile& file) {
  NumberWriter types(file.binary, true);
  const auto cells = vtk_cells(mesh, file.with_others);
  for (const auto& [type, corners] : cells) types.integer(type).end();
  return "CELL_TYPES " + std::to_string(cells.size()) + "\n" + types.text + "\n" +
         (file.with_others ? "CELL_DATA 1\nSCALARS a int 1\nLOOKUP_TABLE default\n7\n" : "");
}

}  // namespace

std::string vtk_4(const TetMesh& mesh, const TetFile& file) {
  NumberWriter cells(file.binary, true);
  std::size_t count = 0, numbers = 0;
  for (const auto& [type, corners] : vtk_cells(mesh, file.with_others)) {
    ++count, numbers += 1 + corners.size();
    cells.integer(static_cast<std::int64_t>(corners.size()));
    for (const std::uint32_t corner : corners) cells.integer(corner);
    cells.end();
  }
  return vtk_begin("3.0", mesh, file) + "CELLS " + std::to_string(count) + " " + std::to_string(numbers) +
         "\n" + cells.text + "\n" + vtk_types(mesh, file);
}

std::string vtk_5(const TetMesh& mesh, const TetFile& file) {
  NumberWriter offsets(file.binary, true), numbers(file.binary, true);
  std::size_t count = 1, total = 0;
  offsets.wide(0);
  for (const auto& [type, corners] : vtk_cells(mesh, file.with_others)) {
    ++count, total += corners.size();
    offsets.wide(static_cast<std::int64_t>(total)).end();
    for (const std::uint32_t corner : corners) numbers.wide(corner);
    numbers.end();
  }
  return vtk_begin("5.1", mesh, file) + (file.with_others ? "METADATA\nINFORMATION 0\n\n" : "") + "CELLS " +
         std::to_string(count) + " " + std::to_string(total) + "\nOFFSETS vtktypeint64\n" + offsets.text +
         "\nCONNECTIVITY vtktypeint64\n" + numbers.text + "\n" + vtk_types(mesh, file);
}

std::string tetgen_node(const TetMesh& mesh, const TetFile& file) {
  std::string text =
      "# by a test\n\n" + std::to_string(mesh.positions.size()) + " 3 1 1  # three dimensions\n";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    text += "  " + std::to_string(file.first + i);
    for (int axis = 0; axis < 3; ++axis) text += " " + decimal(static_cast<double>(mesh.positions[i][axis]));
    text += " 0.5 1\n";
    if (i == 2) text += "\n# a comment\n";
  }
  return text;
}

std::string tetgen_ele(const TetMesh& mesh, const TetFile& file) {
  std::string text = std::to_string(mesh.tets.size()) + " " + std::to_string(file.corners) + " 1\r\n";
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    text += std::to_string(file.first + t);
    for (std::size_t k = 0; k < file.corners; ++k)
      text += " " + std::to_string(file.first + mesh.tets[t][k % 4]);
    text += " -1\r\n";
  }
  return text + "# the end\n";
}

std::vector<NamedTetFile> all_tet_files(const TetMesh& mesh) {
  std::vector<NamedTetFile> files;
  for (const bool binary : {false, true})
    for (const bool with_others : {false, true}) {
      TetFile file;
      file.binary = binary;
      file.with_others = with_others;
      file.is_double = with_others;
      file.first = with_others ? 17 : 1;
      file.step = with_others ? 1000 : 1;
      files.push_back({"a2.msh", msh_2(mesh, file), {}});
      files.push_back({"a4.msh", msh_4(mesh, file), {}});
      files.push_back({"a4.vtk", vtk_4(mesh, file), {}});
      files.push_back({"a5.vtk", vtk_5(mesh, file), {}});
      if (binary) continue;
      file.first = with_others ? 1 : 0;
      file.corners = with_others ? 10 : 4;
      files.push_back({"a.ele", tetgen_ele(mesh, file), tetgen_node(mesh, file)});
    }
  return files;
}

}  // namespace weft::mesh
