#include "mesh/read_mesh.hpp"

#include "base/file.hpp"
#include "mesh/glb.hpp"
#include "mesh/gzip.hpp"
#include "mesh/obj.hpp"
#include "mesh/off.hpp"
#include "mesh/ply.hpp"
#include "mesh/stl.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

using Reader = Result<TriangleMesh> (*)(std::span<const std::byte>);

Reader find_reader(std::string_view path) {
  static constexpr struct {
    std::string_view end;
    Reader reader;
  } kReaders[] = {{".obj", read_obj}, {".off", read_off},    {".stl", read_stl},
                  {".ply", read_ply}, {".ply.gz", read_ply}, {".glb", read_glb}};
  for (const auto& row : kReaders)
    if (path.size() > row.end.size() && same_word(path.substr(path.size() - row.end.size()), row.end))
      return row.reader;
  return nullptr;
}

Result<TriangleMesh> read(std::span<const std::byte> bytes, const std::string& name) {
  const Reader reader = find_reader(name);
  if (reader == nullptr)
    return input_error("The name does not end in .glb, .obj, .off, .stl, .ply or .ply.gz.");
  return reader(bytes);
}

Result<TriangleMesh> read(const std::string& path) {
  if (find_reader(path) == nullptr) return read({}, path);  // whatever the file holds
  WEFT_TRY(bytes, read_file(path, kMaxMeshBytes));
  return read(bytes, path);
}

Result<AnimatedMesh> read_animated(std::span<const std::byte> bytes, const std::string& name) {
  if (find_reader(name) != read_glb) return input_error("Only GLB files have animations.");
  return AnimatedMesh::read(bytes);
}

Result<AnimatedMesh> read_animated(const std::string& path) {
  if (find_reader(path) != read_glb) return read_animated({}, path);
  WEFT_TRY(bytes, read_file(path, kMaxMeshBytes));
  return read_animated(bytes, path);
}

template <class Mesh>
Result<Mesh> named(Result<Mesh> mesh, const std::string& name) {
  if (!mesh) return mesh.error().while_doing("reading mesh " + name);
  return mesh;
}

}  // namespace

Result<TriangleMesh> read_mesh(const std::string& path) { return named(read(path), path); }

Result<TriangleMesh> read_mesh(std::span<const std::byte> bytes, const std::string& name) {
  return named(read(bytes, name), name);
}

Result<AnimatedMesh> read_animated_mesh(const std::string& path) { return named(read_animated(path), path); }

Result<AnimatedMesh> read_animated_mesh(std::span<const std::byte> bytes, const std::string& name) {
  return named(read_animated(bytes, name), name);
}

}  // namespace weft::mesh
