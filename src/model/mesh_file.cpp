#include "model/mesh_file.hpp"

#include "mesh/glb.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"

namespace weft {

Result<std::vector<std::byte>> mesh_file(const DrawnMesh& drawn, std::string_view format) {
  if (format == "ply") return mesh::write_ply(drawn.shape, {}, drawn.attributes);
  if (format == "glb") return mesh::write_glb(drawn.shape, drawn.attributes);
  if (format == "obj") return mesh::write_obj(drawn.shape, drawn.attributes);
  return input_error("The format %s is not known; there are obj, ply and glb.", std::string(format).c_str());
}

}  // namespace weft
