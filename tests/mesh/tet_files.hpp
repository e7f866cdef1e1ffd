// Tetrahedral meshes in the formats of other programs, as the tests write them.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// What a file of one format may differ in.
struct TetFile {
  bool binary = false;
  bool is_double = true;      // points of VTK
  bool with_others = true;    // elements, sections and fields that no mesh needs
  std::uint32_t first = 1;    // number of the first node, for Gmsh and TetGen
  std::uint32_t step = 1;     // from a node's number to the next, for Gmsh
  std::uint32_t corners = 4;  // nodes that TetGen gives a tetrahedron
};

std::string msh_2(const TetMesh& mesh, const TetFile& file);
std::string msh_4(const TetMesh& mesh, const TetFile& file);
std::string vtk_4(const TetMesh& mesh, const TetFile& file);
std::string vtk_5(const TetMesh& mesh, const TetFile& file);
std::string tetgen_ele(const TetMesh& mesh, const TetFile& file);
std::string tetgen_node(const TetMesh& mesh, const TetFile& file);

/// One of each format, version and form, with the name that says the format; for an .ele with its .node.
struct NamedTetFile {
  std::string name, bytes, nodes;
};
std::vector<NamedTetFile> all_tet_files(const TetMesh& mesh);

}  // namespace weft::mesh
