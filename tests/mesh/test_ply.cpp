#include <doctest/doctest.h>

#include "mesh/gzip.hpp"
#include "mesh/ply.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

TEST_CASE("a PLY file written and read back has the same bits, packed too") {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    const TriangleMesh mesh = random_mesh(random);
    const std::string file = text_of(write_ply(mesh, i % 2 == 0 ? "" : "one line"));
    for (const std::string& bytes : {file, gzip(file)}) {
      const auto back = read_ply(bytes_of(bytes));
      REQUIRE(back);
      CHECK(same_bits(mesh, *back));
    }
    CHECK(file.find(ply_begin(i % 2 == 0 ? "" : "one line")) == 0);
  }
}

TEST_CASE(
    "a written PLY has the texture coordinates and normals that there are, and reads back to the same bits") {
  const VertexAttributes attributes{smooth_normals(cube()),
                                    std::vector<std::array<float, 2>>(8, {0.25F, 0.5F})};
  const std::string plain = text_of(write_ply(cube())), all = text_of(write_ply(cube(), {}, attributes));
  CHECK(
      all.find("property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float s\n"
               "property float t\nelement face 12\n") != std::string::npos);
  CHECK(plain.find("property float nx") == std::string::npos);
  const std::string::size_type added =
      std::string("property float nx\n").size() * 3 + std::string("property float s\n").size() * 2;
  CHECK(all.size() == plain.size() + added + 8 * (3 + 2) * 4);
  const auto back = read_ply(bytes_of(all));
  REQUIRE(back);
  CHECK(same_bits(*back, cube()));
}

TEST_CASE("PLY files with other elements, properties, lists, types and orders are read to the same bits") {
  Random random(9);
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const TriangleMesh mesh = random_mesh(random);
    for (const PlyFormat format : {PlyFormat::Text, PlyFormat::BinaryLittle, PlyFormat::BinaryBig}) {
      const auto back = read_ply(bytes_of(elaborate_ply(format, mesh, seed)));
      INFO((back ? "" : back.error().message));
      REQUIRE(back);
      CHECK(same_bits(mesh, *back));
    }
  }
}

TEST_CASE("a PLY text file with polygons, CR LF and integer coordinates is read") {
  const auto mesh =
      read_ply(bytes_of("ply\r\nformat ascii 1.0\r\nelement vertex 5\r\nproperty int x\r\nproperty uchar "
                        "y\r\nproperty double z\r\n"
                        "element face 2\r\nproperty list uchar uint vertex_indices\r\nend_header\r\n"
                        "0 0 0\r\n1 0 0\r\n1 1 0.5\r\n0 1 0\r\n-1 0 0\r\n5 0 1 2 3 4\r\n3 2 1 0"));
  REQUIRE(mesh);
  CHECK(mesh->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {2, 1, 0}});
  CHECK(mesh->positions[2] == Vec3f{1, 1, 0.5F});
  CHECK(mesh->positions[4] == Vec3f{-1, 0, 0});
}

TEST_CASE("gzip data of several members are unpacked, and their bounds are exact") {
  const std::string file = text_of(write_ply(cube()));
  const auto mesh = read_ply(bytes_of(gzip(file.substr(0, 100)) + gzip("") + gzip(file.substr(100))));
  REQUIRE(mesh);
  CHECK(same_bits(*mesh, cube()));
  const std::string zeros = gzip(std::string(1'000'000, '\0'));  // some 1000 bytes
  const auto result = gunzip(bytes_of(zeros));
  CHECK(result.error().message == "The " + std::to_string(zeros.size()) +
                                      " bytes of gzip data unpack to more than the limit of " +
                                      std::to_string(100 * zeros.size()) + " bytes.");
  CHECK(gunzip(bytes_of(gzip("weft") + "x")).error().message.find("but 1 bytes follow.") !=
        std::string::npos);
  CHECK(text_of(*gunzip(bytes_of(gzip("weft")))) == "weft");
  CHECK(gunzip(bytes_of(gzip("")))->empty());
}

TEST_CASE("an error in a PLY file gives its line or byte, the value and the limit") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n";
  const auto message = [](const std::string& text) { return read_ply(bytes_of(text)).error().message; };
  CHECK(message(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n") ==
        "The face at line 13 names vertex 3, but the mesh has 3 vertices, from 0.");
  CHECK(message(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n") ==
        "The face at line 13 names vertex -1, but the mesh has 3 vertices, from 0.");
  CHECK(message(header + "0 0 0\n1 0 0\n0 1e39 0\n3 0 1 2\n") ==
        "The coordinate inf at line 12 is not finite in single precision, where the largest is "
        "3.40282347e+38.");
  CHECK(message(header + "0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n") ==
        "The value \"x\" on line 12 is not a finite number.");
  CHECK(message(header + "0 0 0\n1 0 0\n0 0 0\n2 0 1 2\n") ==
        "The face at line 13 has 2 corners, fewer than 3.");
  CHECK(message(std::string(header).replace(header.find("uchar"), 5, "char") +
                "0 0 0\n1 0 0\n0 0 0\n-3 0 1 2\n") ==
        "The list \"vertex_index\" at line 13 has the size -3, which is not in 0 to 4, all that the file can "
        "hold.");
  CHECK(message(header + "0 0 0\n1 0 0\n0 0 0\n200 0 1 2\n") ==
        "The list \"vertex_index\" at line 13 has the size 200, which is not in 0 to 4, all that the file "
        "can hold.");
  CHECK(message("ply\nformat ascii 2.0\n") == "Line 2 names version \"2.0\" of PLY, not 1.0.");
}
