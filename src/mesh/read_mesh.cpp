#include "mesh/read_mesh.hpp"

#include "base/file.hpp"
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
  } kReaders[] = {
      {".obj", read_obj}, {".off", read_off}, {".stl", read_stl}, {".ply", read_ply}, {".ply.gz", read_ply}};
  for (const auto& row : kReaders)
    if (path.size() > row.end.size() && same_word(path.substr(path.size() - row.end.size()), row.end))
      return row.reader;
  return nullptr;
}

Result<TriangleMesh> read(const std::string& path) {
  const Reader reader = find_reader(path);
  if (reader == nullptr) return input_error("The name does not end in .obj, .off, .stl, .ply or .ply.gz.");
  WEFT_TRY(bytes, read_file(path, kMaxMeshBytes));
  return reader(bytes);
}

}  // namespace

Result<TriangleMesh> read_mesh(const std::string& path) {
  auto mesh = read(path);
  if (!mesh) return mesh.error().while_doing("reading mesh " + path);
  return mesh;
}

}  // namespace weft::mesh
