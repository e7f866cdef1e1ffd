#include "mesh/read_tet_mesh.hpp"

#include "base/file.hpp"
#include "mesh/gzip.hpp"
#include "mesh/msh.hpp"
#include "mesh/tetgen.hpp"
#include "mesh/text_cursor.hpp"
#include "mesh/vtk.hpp"

namespace weft::mesh {
namespace {

constexpr std::string_view kEle = ".ele", kMsh = ".msh", kVtk = ".vtk", kNode = ".node";

bool has_end(std::string_view name, std::string_view end) {
  return name.size() > end.size() && same_word(name.substr(name.size() - end.size()), end);
}

Result<TetMesh> read_tets_of(std::span<const std::byte> bytes, const std::string& name,
                             std::span<const std::byte> nodes) {
  if (has_end(name, kMsh)) return read_msh(bytes);
  if (has_end(name, kVtk)) return read_vtk(bytes);
  if (has_end(name, kEle)) return read_tetgen(bytes, nodes);
  return input_error("The name does not end in .msh, .vtk or .ele.");
}

Result<TetMesh> read_tets_of(const std::string& path) {
  if (!has_end(path, kMsh) && !has_end(path, kVtk) && !has_end(path, kEle)) return read_tets_of({}, path, {});
  WEFT_TRY(bytes, read_file(path, kMaxMeshBytes));
  const std::string beside = nodes_beside(path);
  if (beside.empty()) return read_tets_of(bytes, path, {});
  WEFT_TRY(nodes, read_file(beside, kMaxMeshBytes));
  return read_tets_of(bytes, path, nodes);
}

Result<TetMesh> with_name(Result<TetMesh> mesh, const std::string& name) {
  if (!mesh) return mesh.error().while_doing("reading mesh " + name);
  return mesh;
}

}  // namespace

bool names_tet_mesh(const std::string& name) {
  for (const std::string_view end : {kMsh, kVtk, kEle, kNode})
    if (has_end(name, end)) return true;
  return false;
}

std::string nodes_beside(const std::string& name) {
  if (!has_end(name, kEle)) return {};
  // In the capitals of the name, as file systems may tell them apart.
  return name.substr(0, name.size() - 3) + (name.back() == 'E' ? "NODE" : "node");
}

Result<TetMesh> read_tet_mesh(const std::string& path) { return with_name(read_tets_of(path), path); }

Result<TetMesh> read_tet_mesh(std::span<const std::byte> bytes, const std::string& name,
                              std::span<const std::byte> nodes) {
  return with_name(read_tets_of(bytes, name, nodes), name);
}

}  // namespace weft::mesh
