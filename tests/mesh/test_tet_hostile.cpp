#include <doctest/doctest.h>

#include <algorithm>

#include "allocation_meter.hpp"
#include "base/random.hpp"
#include "mesh/check_tets.hpp"
#include "mesh/read_tet_mesh.hpp"
#include "mesh_files.hpp"
#include "tet_files.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

// Memory follows the bytes that are there: a tetrahedron takes at least 10 of text. With its faces, which are sorted to
// be compared, and a list that doubles as it grows it takes 96. (Measured at most 8.5 bytes for one of the file.)
constexpr std::size_t kTetGrowth = 10;
constexpr std::size_t kTetConstant = std::size_t{1} << 20U;  // bytes

// The fault in the answer to arbitrary bytes; empty if none.
std::string fault_of(const NamedTetFile& file, bool must_fail = false) {
  const AllocationMeter meter;
  const auto mesh = read_tet_mesh(bytes_of(file.bytes), file.name, bytes_of(file.nodes));
  const std::size_t peak = meter.peak();
  if (peak > kTetGrowth * (file.bytes.size() + file.nodes.size()) + kTetConstant)
    return "allocates " + std::to_string(peak);
  if (mesh) {
    TetMesh same = *mesh;
    if (must_fail) return "is read";
    return check_tets(same) && same.tets == mesh->tets && same.positions.size() == mesh->positions.size()
               ? ""
               : "a bad mesh passes";
  }
  if (mesh.error().kind != ErrorKind::Input) return "is another kind of error";
  const std::string& message = mesh.error().message;
  if (message.size() < 30 || message.size() > 400 || message.back() != '.')
    return "has the message " + message;
  for (const char c : message)
    if (c < ' ' || c > '~') return "has a character in its message that does not print";
  return {};
}

TetMesh small() { return block({2, 1, 1}, {1, 1, 1}); }

std::string mutated_tets(std::string bytes, Random& random) {
  static constexpr std::string_view kTokens[] = {
      "-1", "1e999",     "nan", "4294967295", "0",         "9223372036854775807", "#",
      "\n", " ",         "$",   "$Nodes\n",   "$EndNodes", "\xff\xff\xff\xff",    "CELLS 1 1\n",
      "4",  "METADATA\n"};
  return changed(std::move(bytes), kTokens, random);
}

std::string replaced_in(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string many(std::string_view text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace

TEST_CASE("a tetrahedral mesh file cut off anywhere is read whole or an input error") {
  for (const NamedTetFile& whole : all_tet_files(small())) {
    std::size_t accepted = 0;
    for (std::size_t size = 0; size < whole.bytes.size(); ++size) {
      NamedTetFile file = whole;
      file.bytes.resize(size);
      INFO(file.name << " cut off at " << size);
      REQUIRE(fault_of(file) == "");
      accepted += read_tet_mesh(bytes_of(file.bytes), file.name, bytes_of(file.nodes)) ? 1 : 0;
      // Only what comes after the tetrahedra may be missing, or the last digit of a number.
      if (size < whole.bytes.size() / 2) CHECK(accepted == 0);
    }
    for (std::size_t size = 0; size < whole.nodes.size(); ++size) {
      NamedTetFile file = whole;
      file.nodes.resize(size);
      REQUIRE(fault_of(file) == "");
    }
  }
}

TEST_CASE("bytes changed at random in tetrahedral mesh files break nothing and cost no more memory") {
  const std::vector<NamedTetFile> files = all_tet_files(small());
  for (std::uint32_t which = 0; which < files.size(); ++which) {
    Random random(100 + which);
    int accepted = 0;
    constexpr int kChanges = 1500;
    for (int i = 0; i < kChanges; ++i) {
      NamedTetFile file = files[which];
      if (file.nodes.empty() || random.below(2) == 0)
        file.bytes = mutated_tets(file.bytes, random);
      else
        file.nodes = mutated_tets(file.nodes, random);
      if (const std::string fault = fault_of(file); !fault.empty()) {
        INFO(file.name << ": change " << i << " of file " << which);
        FAIL(fault);
      }
      accepted += read_tet_mesh(bytes_of(file.bytes), file.name, bytes_of(file.nodes)) ? 1 : 0;
    }
    INFO(files[which].name << ", file " << which << ": " << accepted << " of " << kChanges << " are read");
    CHECK(accepted > kChanges / 100);  // some changes do no harm: not all end at the first byte
    CHECK(accepted < kChanges * 9 / 10);
  }
}

TEST_CASE("hostile counts and sizes in tetrahedral mesh files are input errors that cost no memory") {
  TetFile text, bytes;
  text.with_others = bytes.with_others = false;
  bytes.binary = true;
  const TetMesh mesh = small();
  const auto msh = [](std::string content) { return NamedTetFile{"a.msh", std::move(content), {}}; };
  const auto vtk = [](std::string content) { return NamedTetFile{"a.vtk", std::move(content), {}}; };
  const std::string head = "# vtk DataFile Version 4.2\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  const std::string node = tetgen_node(mesh, text), ele = tetgen_ele(mesh, text);
  const std::string most = "9223372036854775807", large = "4000000000";
  const std::string wide(7, '\xff');
  const std::vector<NamedTetFile> hostile = {
      msh(replaced_in(msh_2(mesh, text), "$Nodes\n12", "$Nodes\n" + large)),
      msh(replaced_in(msh_2(mesh, text), "$Nodes\n12", "$Nodes\n" + most)),
      msh(replaced_in(msh_2(mesh, bytes), "$Nodes\n12", "$Nodes\n" + large)),
      msh(replaced_in(msh_2(mesh, text), "$Elements\n10", "$Elements\n" + most)),
      msh(replaced_in(msh_2(mesh, bytes), "$Elements\n10", "$Elements\n" + large)),
      msh(replaced_in(msh_2(mesh, text), "1 4 2 7", "1 4 " + most + " 7")),
      msh(replaced_in(msh_2(mesh, text), "1 4 2 7", "1 4 -2 7")),
      msh(replaced_in(msh_4(mesh, text), "2 12 1", "2 " + most + " 1")),
      msh(replaced_in(msh_4(mesh, text), "2 12 1", most + " 12 1")),
      msh(replaced_in(msh_4(mesh, text), "3 5 0 6", "3 5 0 " + most)),
      msh(replaced_in(msh_4(mesh, text), "3 5 0 6", "3 5 0 -6")),
      msh(replaced_in(msh_4(mesh, text), "3 5 0 6", most + " 5 1 6")),
      msh(replaced_in(msh_4(mesh, text), "3 1 4 10", "3 1 4 " + most)),
      msh(replaced_in(msh_4(mesh, text), "3 1 4 10", "3 1 4 -10")),
      msh(replaced_in(msh_4(mesh, bytes), "$Nodes\n\2", "$Nodes\n" + wide)),
      msh(replaced_in(msh_4(mesh, bytes), "$Elements\n\1", "$Elements\n" + wide)),
      msh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + many("$A\n", 300'000)),
      msh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + many("$A\n$EndA\n", 100'000)),
      msh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$" + std::string(3'000'000, 'A')),
      msh("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n" + most + " 0 0 0\n" + many("0 0 0 0\n", 100'000)),
      msh(std::string(100'000, '\0')),
      vtk(head + "POINTS " + large + " float\n0 0 0\n"),
      vtk(head + "POINTS " + most + " float\n0 0 0\n"),
      vtk(head + "FIELD f " + most + "\n" + many("a 0 0 int\n", 100'000)),
      vtk(head + "FIELD f 1\na " + most + " " + most + " int\n0 0 0\n"),
      vtk(head + "FIELD f 1\na 4 " + most + " int\n0 0 0\n"),
      vtk(head + many("METADATA\n\n", 100'000)),
      vtk(head + "POINTS 0 float\nCELLS " + most + " 0\nCELL_TYPES 0\n"),
      vtk(head + "POINTS 0 float\nCELLS 0 " + most + "\n"),
      vtk(head + "POINTS 0 float\nCELLS 0 0\nCELL_TYPES " + most + "\n"),
      vtk(replaced_in(vtk_4(mesh, bytes), "CELLS 10 50", "CELLS 10 " + large)),
      vtk(replaced_in(vtk_5(mesh, bytes), "CELLS 11 40", "CELLS " + most + " 40")),
      vtk(replaced_in(vtk_5(mesh, text), "\n0 4 ", "\n0 " + most + " ")),
      vtk(replaced_in(vtk_5(mesh, text), "\n0 4 ", "\n0 -9223372036854775808 ")),
      vtk(replaced_in(vtk_5(mesh, text), "\n0 4 ", "\n-4 4 ")),
      vtk(replaced_in(vtk_4(mesh, text), "\n4 ", "\n-4 ")),
      vtk("# vtk DataFile Version " + std::string(3'000'000, '4')),
      {"a.ele", ele, replaced_in(node, "12 3", large + " 3")},
      {"a.ele", ele, replaced_in(node, "12 3", most + " 3")},
      {"a.ele", replaced_in(ele, "10 4", large + " 4"), node},
      {"a.ele", replaced_in(ele, "10 4", "-10 4"), node},
      {"a.ele", replaced_in(ele, "1 1 ", "1 99999999999999999999 "), node},
      {"a.ele", ele, many("#\n", 500'000)},
      {"a.ele", many("\n", 500'000), node},
  };
  for (std::size_t i = 0; i < hostile.size(); ++i) {
    INFO(hostile[i].name << ", row " << i);
    CHECK(fault_of(hostile[i], true) == "");
  }
}

TEST_CASE("the largest mesh that the bytes of a file can hold costs what the bound allows") {
  // The shortest rows there are: nodes of one digit each, the same tetrahedron again and again, refused at the end.
  std::string node = "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
  CHECK(fault_of({"a.ele", "100000 4\n" + many("1 1 2 3 4\n", 100'000), node}, true) == "");
  std::string points =
      "# vtk DataFile Version 4.2\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 100000 float\n";
  points += many("0 0 0\n", 99'996) + "0 0 0\n1 0 0\n0 1 0\n0 0 1\nCELLS 100000 500000\n";
  points += many("4 99996 99997 99998 99999\n", 100'000) + "CELL_TYPES 100000\n" + many("10\n", 100'000);
  CHECK(fault_of({"a.vtk", points, ""}, true) == "");
  const std::string gmsh =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n"
      "0 1 0\n0 0 1\n$EndNodes\n$Elements\n1 100000 1 1\n3 1 4 100000\n";
  CHECK(fault_of({"a.msh", gmsh + many("1 1 2 3 4\n", 100'000) + "$EndElements\n", ""}, true) == "");
}
