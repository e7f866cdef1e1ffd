#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "allocation_meter.hpp"
#include "mesh/glb.hpp"
#include "mesh/gzip.hpp"
#include "mesh/obj.hpp"
#include "mesh/off.hpp"
#include "mesh/ply.hpp"
#include "mesh/stl.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

using Reader = Result<TriangleMesh> (*)(std::span<const std::byte>);

struct Hostile {
  std::string name;
  Reader reader;
  std::string bytes;
};

// Memory follows the bytes that are there: triangles take 12 bytes, and a polygon's corner at least one in a
// file.
constexpr std::size_t kMaxGrowth = 16;
constexpr std::size_t kMaxConstant = std::size_t{1} << 20U;  // bytes

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

std::string ply_header(const std::string& format, const std::string& vertices, const std::string& faces,
                       const std::string& list = "uchar int") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list " + list + " vertex_indices\nend_header\n";
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::vector<Hostile> hostile_obj() {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  return {
      {"empty", read_obj, ""},
      {"only points", read_obj, points},
      {"a point of two", read_obj, "v 0 0\n"},
      {"nan", read_obj, points + "v nan 0 0\nf 1 2 3\n"},
      {"inf", read_obj, points + "v 0 -inf 0\nf 1 2 3\n"},
      {"1e999", read_obj, points + "v 0 1e999 0\nf 1 2 3\n"},
      {"1e39, beyond float", read_obj, points + "v 0 1e39 0\nf 1 2 3\n"},
      {"a word for a number", read_obj, "v 0 zero 0\nf 1 1 1\n"},
      {"index 0", read_obj, points + "f 0 1 2\n"},
      {"index 0 before other points", read_obj, points + "f 0 1 2\n" + points},
      {"index past the end", read_obj, points + "f 1 2 4\n"},
      {"negative index past the begin", read_obj, points + "f -1 -2 -4\n"},
      {"index 2^32 + 1", read_obj, points + "f 4294967297 1 2\n"},
      {"index of 30 digits", read_obj, points + "f 1 2 " + std::string(30, '9') + "\n"},
      {"index -2^63", read_obj, points + "f -9223372036854775808 1 2\n"},
      {"two corners", read_obj, points + "f 1 2\n"},
      {"no corner", read_obj, points + "f\n"},
      {"slashes only", read_obj, points + "f / / /\n"},
      {"corner with an open slash", read_obj, points + "f 1/ 2/ 3/\n"},
      {"corner of four numbers", read_obj, points + "f 1/1/1/1 2 3\n"},
      {"a word of megabytes", read_obj, "v " + std::string(3'000'000, '1') + " 0 0\nf 1 1 1\n"},
      {"a coordinate of megabytes that is none", read_obj, "v 0 0 " + std::string(3'000'000, '-') + "\n"},
      {"a face of a million corners, the last wrong", read_obj,
       points + "f" + repeated(" 1", 1'000'000) + " 9\n"},
      {"a million faces of no points", read_obj, repeated("f 1 1 1\n", 1'000'000)},
      {"a megabyte of backslashes", read_obj, repeated("\\\n", 500'000)},
      {"zeros", read_obj, std::string(100'000, '\0')},
      {"white space", read_obj, repeated(" \t\r", 300'000)},
  };
}

std::vector<Hostile> hostile_off() {
  const std::string good = text_off(cube());
  return {
      {"empty", read_off, ""},
      {"keyword only", read_off, "OFF"},
      {"wrong keyword", read_off, "OOF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"four dimensions", read_off, "4OFF\n3 1 0\n0 0 0 0\n1 0 0 0\n0 1 0 0\n3 0 1 2\n"},
      {"binary", read_off, "OFF BINARY\n" + std::string(100, '\1')},
      {"no faces", read_off, "OFF\n1 0 0\n0 0 0\n"},
      {"absurd vertex count", read_off, replaced(good, "8 12", "4000000000 12")},
      {"absurd face count", read_off, replaced(good, "8 12", "8 9223372036854775807")},
      {"count beyond 64 bits", read_off, replaced(good, "8 12", "99999999999999999999 12")},
      {"negative count", read_off, replaced(good, "8 12", "-8 12")},
      {"one face more than there is", read_off, replaced(good, "8 12", "8 13")},
      {"truncated", read_off, good.substr(0, good.size() - 4)},
      {"truncated in the points", read_off, good.substr(0, 30)},
      {"absurd corner count", read_off, replaced(good, "3 0 2 1", "4000000000 0 2 1")},
      {"negative corner count", read_off, replaced(good, "3 0 2 1", "-3 0 2 1")},
      {"many absurd corner counts", read_off, "OFF\n1 90000 0\n0 0 0\n" + repeated("399999 0\n", 90'000)},
      {"negative index", read_off, replaced(good, "3 0 2 1", "3 0 2 -1")},
      {"index past the end", read_off, replaced(good, "3 0 2 1", "3 0 2 8")},
      {"nan", read_off, replaced(good, "1 1 0", "1 nan 0")},
      {"1e999", read_off, replaced(good, "1 1 0", "1 1e999 0")},
      {"no points, one face", read_off, "OFF\n0 1 0\n3 0 0 0\n"},
      {"a line of megabytes", read_off, "OFF\n1 1 0\n0 0 0\n3 0 0" + std::string(3'000'000, ' ') + "x\n"},
      {"a megabyte of comments", read_off, repeated("#\n", 500'000)},
  };
}

std::vector<Hostile> hostile_stl() {
  const std::string text = text_stl(cube());
  const std::string binary = binary_stl(cube());
  const std::string nan = std::string("\0\0\xc0\x7f", 4);
  const std::string count = std::string("\x0c\0\0\0", 4);
  return {
      {"empty", read_stl, ""},
      {"83 bytes", read_stl, std::string(83, 'x')},
      {"no triangles, binary", read_stl, std::string(84, '\0')},
      {"no triangles, text", read_stl, "solid a\nendsolid a\n"},
      {"count 0xFFFFFFFF", read_stl, replaced(binary, count, "\xff\xff\xff\xff")},
      {"one triangle more than there is", read_stl, replaced(binary, count, std::string("\x0d\0\0\0", 4))},
      {"truncated binary", read_stl, binary.substr(0, binary.size() - 7)},
      {"binary nan", read_stl, binary.substr(0, 96) + nan + binary.substr(100)},
      {"truncated text", read_stl, text.substr(0, text.size() / 2)},
      {"text without an end", read_stl, text.substr(0, text.find("endsolid"))},
      {"text nan", read_stl, replaced(text, "vertex 0", "vertex nan")},
      {"text 1e999", read_stl, replaced(text, "vertex 0", "vertex 1e999")},
      {"two corners", read_stl, replaced(text, "endloop", "")},
      {"wrong keyword", read_stl, replaced(text, "vertex", "vortex")},
      {"nested solids", read_stl, "solid a\n" + repeated("solid b\n", 100'000)},
      {"nested facets", read_stl, "solid a\n" + repeated("facet normal 0 0 1\n", 100'000)},
      {"a name of megabytes", read_stl, "solid " + std::string(3'000'000, 'n')},
  };
}

std::vector<Hostile> hostile_ply() {
  const std::string good = text_of(write_ply(cube()));
  const std::string text = ply_header("ascii", "3", "1") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string nan = std::string("\0\0\xc0\x7f", 4);
  const auto data = good.find("end_header\n") + 11;
  return {
      {"empty", read_ply, ""},
      {"keyword only", read_ply, "ply"},
      {"wrong keyword", read_ply, "plx" + text.substr(3)},
      {"no format", read_ply, replaced(text, "format ascii 1.0\n", "")},
      {"wrong format", read_ply, replaced(text, "ascii", "binary")},
      {"wrong version", read_ply, replaced(text, "1.0", "3.0")},
      {"wrong header keyword", read_ply, replaced(text, "element face", "elephant face")},
      {"wrong type", read_ply, replaced(text, "float y", "quad y")},
      {"no end of the header", read_ply, replaced(text, "end_header\n", "")},
      {"no faces element", read_ply, replaced(text, "element face", "element edge")},
      {"no faces", read_ply, ply_header("ascii", "1", "0") + "0 0 0\n"},
      {"no property z", read_ply, replaced(text, "float z", "float w")},
      {"property x twice", read_ply, replaced(text, "float z", "float x")},
      {"element vertex twice", read_ply, replaced(text, "element face", "element vertex")},
      {"x is a list", read_ply, replaced(text, "property float x", "property list uchar float x")},
      {"indices are no list", read_ply, replaced(text, "list uchar int", "int")},
      {"indices are floats", read_ply, replaced(text, "uchar int", "uchar float")},
      {"list counted in floats", read_ply, replaced(text, "uchar int", "float int")},
      {"property before any element", read_ply, "ply\nformat ascii 1.0\nproperty float x\nend_header\n"},
      {"a thousand elements", read_ply,
       "ply\nformat ascii 1.0\n" +
           [] {
             std::string lines;
             for (int i = 0; i < 1000; ++i) lines += "element e" + std::to_string(i) + " 0\n";
             return lines;
           }() +
           "end_header\n"},
      {"a million properties", read_ply,
       "ply\nformat ascii 1.0\nelement vertex 0\n" + repeated("property int a\n", 1'000'000)},
      {"absurd vertex count, text", read_ply, ply_header("ascii", "4000000000", "1") + "0 0 0\n"},
      {"absurd vertex count, binary", read_ply, replaced(good, "vertex 8", "vertex 4000000000")},
      {"absurd face count, binary", read_ply, replaced(good, "face 12", "face 9223372036854775807")},
      {"count beyond 64 bits", read_ply, replaced(good, "face 12", "face 99999999999999999999")},
      {"negative count", read_ply, replaced(good, "vertex 8", "vertex -8")},
      {"2^62 rows of nothing, then no mesh", read_ply,
       "ply\nformat ascii 1.0\nelement void 4611686018427387904\n" +
           ply_header("ascii", "0", "0").substr(21)},
      {"2^62 rows of empty lists", read_ply,
       "ply\nformat binary_little_endian 1.0\nelement void 4611686018427387904\nproperty list uchar int a\n" +
           good.substr(good.find("element vertex"))},
      {"a list larger than the file", read_ply,
       ply_header("binary_little_endian", "0", "1", "uint uchar") + "\xff\xff\xff\xff"},
      {"a negative list", read_ply, ply_header("ascii", "1", "1", "char int") + "0 0 0\n-3 0 0 0\n"},
      {"a list of 2^63", read_ply, ply_header("ascii", "1", "1") + "0 0 0\n9223372036854775807 0 0 0\n"},
      {"a megabyte of zeros as one face of bytes, no vertex", read_ply,
       ply_header("binary_little_endian", "0", "1", "uint uchar") + std::string("\x40\x42\x0f\0", 4) +
           std::string(1'000'000, '\0')},
      {"a megabyte of faces with two corners", read_ply,
       ply_header("binary_big_endian", "0", "300000", "uchar uchar") +
           repeated(std::string("\2\0\0", 3), 300'000)},
      {"truncated binary", read_ply, good.substr(0, good.size() - 1)},
      {"truncated in the points", read_ply, good.substr(0, data + 20)},
      {"truncated text", read_ply, text.substr(0, text.size() - 3)},
      {"binary nan", read_ply, good.substr(0, data + 4) + nan + good.substr(data + 8)},
      {"text nan", read_ply, replaced(text, "1 0 0", "1 nan 0")},
      {"text 1e999", read_ply, replaced(text, "1 0 0", "1 1e999 0")},
      {"double beyond float", read_ply,
       replaced(replaced(text, "float x", "double x"), "1 0 0", "1e200 0 0")},
      {"negative index", read_ply, replaced(text, "3 0 1 2", "3 0 1 -1")},
      {"index past the end", read_ply, replaced(text, "3 0 1 2", "3 0 1 3")},
      {"index 2^32", read_ply, replaced(text, "3 0 1 2", "3 0 1 4294967296")},
      {"index with a fraction", read_ply, replaced(text, "3 0 1 2", "3 0 1 1.5")},
      {"two corners", read_ply, replaced(text, "3 0 1 2", "2 0 1 2")},
      {"a comment of megabytes", read_ply, "ply\ncomment " + std::string(3'000'000, 'c')},
      {"a name of megabytes", read_ply,
       "ply\nformat ascii 1.0\nelement " + std::string(3'000'000, 'n') + " x\n"},
      {"gzip bomb", read_ply, gzip(text + std::string(50'000'000, ' '))},
      {"gzip bomb in gzip", read_ply, gzip(gzip(std::string(50'000'000, '\0')))},
      {"gzip in gzip", read_ply, gzip(gzip(good))},
      {"gzip truncated", read_ply, gzip(good).substr(0, gzip(good).size() / 2)},
      {"gzip header only", read_ply, "\x1f\x8b"},
      {"gzip with a wrong sum", read_ply,
       [&] {
         std::string packed = gzip(good);
         packed[packed.size() - 6] = static_cast<char>(packed[packed.size() - 6] ^ 1);
         return packed;
       }()},
      {"gzip of nothing, ten thousand times", read_ply, repeated(gzip(""), 10'000)},
  };
}

std::string check_hostile(const Hostile& hostile) {
  const AllocationMeter meter;
  const auto result = hostile.reader(bytes_of(hostile.bytes));
  const std::size_t peak = meter.peak();
  if (result) return "is read";
  if (result.error().kind != ErrorKind::Input) return "is another kind of error";
  const std::string& message = result.error().message;
  if (message.size() < 10 || message.size() > 300 || message.back() != '.')
    return "has the message " + message;
  for (const char c : message)
    if (c < ' ' || c > '~') return "has a character in its message that does not print";
  // JSON takes more room than its text, and a file may use a mesh many times; both have their limits.
  const std::size_t growth = hostile.reader == read_glb ? 2 * kMaxGlbGrowth : kMaxGrowth;
  if (peak > growth * hostile.bytes.size() + kMaxConstant)
    return "allocates " + std::to_string(peak) + " for " + std::to_string(hostile.bytes.size()) + " bytes";
  return {};
}

// A GLB file of a triangle, with one place of its JSON replaced.
std::string glb_with(std::string_view from, std::string_view to) {
  const std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0},{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
      R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],)"
      R"("buffers":[{"byteLength":42}]})";
  std::string binary(36, '\0');
  binary[4 * 3 + 2] = static_cast<char>(0x80), binary[4 * 3 + 3] = 0x3f;  // (1, 0, 0)
  binary[4 * 7 + 2] = static_cast<char>(0x80), binary[4 * 7 + 3] = 0x3f;  // (0, 1, 0)
  return glb_file(from.empty() ? json : replaced(json, from, to), binary + std::string("\0\0\1\0\2\0", 6));
}

std::vector<Hostile> hostile_glb() {
  const std::string good = glb_with("", "");
  const std::size_t binary = good.size() - 44;
  const std::string nan = std::string("\0\0\xc0\x7f", 4);
  const auto row = [](const char* name, std::string_view from, std::string_view to) {
    return Hostile{name, read_glb, glb_with(from, to)};
  };
  const auto json_only = [](const std::string& json) {
    return "glTF" + std::string("\2\0\0\0", 4) +
           ply_value(PlyFormat::BinaryLittle, PlyType::Uint32, static_cast<double>(20 + json.size())) +
           ply_value(PlyFormat::BinaryLittle, PlyType::Uint32, static_cast<double>(json.size())) + "JSON" +
           json;
  };
  std::string chain;  // nodes, each the child of the one before
  for (int i = 1; i < 20'000; ++i) chain += R"({"children":[)" + std::to_string(i) + "]},";
  return {
      {"empty", read_glb, ""},
      {"a header alone", read_glb, std::string("glTF\2\0\0\0\14\0\0\0", 12)},
      {"text", read_glb, R"({"asset":{"version":"2.0"}, "scenes": []})"},
      {"version 1", read_glb, good.substr(0, 4) + "\1" + good.substr(5)},
      {"one byte less than stated", read_glb, good.substr(0, good.size() - 1)},
      {"one byte more than stated", read_glb, good + "x"},
      {"a chunk of 4 GiB", read_glb, good.substr(0, 12) + "\xff\xff\xff\xff" + good.substr(16)},
      {"a binary chunk of 4 GiB", read_glb,
       good.substr(0, binary - 8) + "\xff\xff\xff\xff" + good.substr(binary - 4)},
      {"a binary chunk of four bytes more", read_glb,
       good.substr(0, binary - 8) + std::string("\x30\0\0\0", 4) + good.substr(binary - 4)},
      {"the first chunk is not JSON", read_glb, good.substr(0, 16) + "BIN!" + good.substr(20)},
      {"JSON of nothing", read_glb, json_only("")},
      {"JSON of zeros", read_glb, json_only(std::string(1000, '\0'))},
      {"JSON of bytes that are no text", read_glb, json_only("{\"\xff\xfe\x80\": 1}    ")},
      {"JSON that is deep", read_glb, json_only(repeated("[", 100'000))},
      {"JSON with a key twice", read_glb, json_only("{\"\xc3\xa4\":1,\"\xc3\xa4\":1}")},
      {"two million values", read_glb, json_only("[0" + repeated(",0", 2'000'000) + "]")},
      {"a list", read_glb, json_only("[]  ")},
      row("no version", R"({"version":"2.0"})", "{}"),
      row("version 3", R"("2.0")", R"("3.0")"),
      row("a required extension", R"("scene":0)",
          R"("extensionsRequired":["KHR_draco_mesh_compression"],"scene":0)"),
      row("a required extension that is no text", R"("scene":0)", R"("extensionsRequired":[7],"scene":0)"),
      row("no scene", R"("scenes":[{"nodes":[0]}])", R"("scenes":[])"),
      row("scene 1 of 1", R"("scene":0)", R"("scene":1)"),
      row("scene -1", R"("scene":0)", R"("scene":-1)"),
      row("a scene without nodes", R"({"nodes":[0]})", "{}"),
      row("node 9", R"({"nodes":[0]})", R"({"nodes":[9]})"),
      row("node 0.5", R"({"nodes":[0]})", R"({"nodes":[0.5]})"),
      row("node 1e300", R"({"nodes":[0]})", R"({"nodes":[1e300]})"),
      row("node \"0\"", R"({"nodes":[0]})", R"({"nodes":["0"]})"),
      row("a node twice", R"({"nodes":[0]})", R"({"nodes":[0,0]})"),
      row("a node that is its own child", R"({"mesh":0},)", R"({"mesh":0,"children":[0]},)"),
      row("a ring of nodes", R"({"mesh":0},{"mesh":0})", R"({"mesh":0,"children":[1]},{"children":[0]})"),
      row("a chain of 20,000 nodes to none", R"([{"mesh":0},{"mesh":0}])",
          "[" + chain + "{\"children\":[20000]}]"),
      row("a node that is no object", R"([{"mesh":0},{"mesh":0}])", "[3]"),
      row("mesh 1 of 1", R"({"mesh":0},)", R"({"mesh":1},)"),
      row("a rotation of zero", R"({"mesh":0},)", R"({"mesh":0,"rotation":[0,0,0,0]},)"),
      row("a scale of two numbers", R"({"mesh":0},)", R"({"mesh":0,"scale":[1,1]},)"),
      row("a scale of words", R"({"mesh":0},)", R"({"mesh":0,"scale":["a","b","c"]},)"),
      row("a scale beyond float", R"({"mesh":0},)", R"({"mesh":0,"scale":[1e300,1,1]},)"),
      row("a translation beyond float", R"({"mesh":0},)", R"({"mesh":0,"translation":[0,-1e39,0]},)"),
      row("a matrix with perspective", R"({"mesh":0},)",
          R"({"mesh":0,"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]},)"),
      row("points", R"("indices":1)", R"("indices":1,"mode":0)"),
      row("mode 7", R"("indices":1)", R"("indices":1,"mode":7)"),
      row("no attributes", R"("attributes":{"POSITION":0},)", ""),
      row("no positions", R"({"POSITION":0})", R"({"NORMAL":0})"),
      row("accessor 2 of 2", R"({"POSITION":0})", R"({"POSITION":2})"),
      row("indices of floats", R"("indices":1)", R"("indices":0)"),
      row("positions of shorts", R"({"POSITION":0})", R"({"POSITION":1})"),
      row("signed indices", "5123", "5122"),
      row("doubles", "5126", "5130"),
      row("positions of two numbers", "VEC3", "VEC2"),
      row("a sparse accessor", R"("type":"VEC3")", R"("type":"VEC3","sparse":{"count":1})"),
      row("an accessor without a view", R"("bufferView":0,)", ""),
      row("view 2 of 2", R"("bufferView":0)", R"("bufferView":2)"),
      row("a count of 4", R"("count":3,"type":"VEC3")", R"("count":4,"type":"VEC3")"),
      row("a count of 2^53", R"("count":3,"type":"SCALAR")", R"("count":9007199254740992,"type":"SCALAR")"),
      row("a count of 1e300", R"("count":3,"type":"VEC3")", R"("count":1e300,"type":"VEC3")"),
      row("a count of -3", R"("count":3,"type":"VEC3")", R"("count":-3,"type":"VEC3")"),
      row("a count of 2.5", R"("count":3,"type":"VEC3")", R"("count":2.5,"type":"VEC3")"),
      row("two corners", R"("count":3,"type":"SCALAR")", R"("count":2,"type":"SCALAR")"),
      row("a vertex that is not there", R"("count":3,"type":"VEC3")", R"("count":2,"type":"VEC3")"),
      row("an offset past the view", R"("count":3,"type":"VEC3")",
          R"("byteOffset":37,"count":3,"type":"VEC3")"),
      row("an offset that leaves two", R"("count":3,"type":"VEC3")",
          R"("byteOffset":4,"count":3,"type":"VEC3")"),
      row("a stride of 4", R"("byteLength":36)", R"("byteLength":36,"byteStride":4)"),
      row("a stride of 16", R"("byteLength":36)", R"("byteLength":36,"byteStride":16)"),
      row("a stride of 2^32", R"("byteLength":36)", R"("byteLength":36,"byteStride":4294967296)"),
      row("a view past the buffer", R"("byteLength":6}],)", R"("byteLength":7}],)"),
      row("a view that begins past it", R"("byteOffset":36)", R"("byteOffset":4294967295)"),
      row("a buffer longer than the chunk", R"({"byteLength":42})", R"({"byteLength":45})"),
      row("a buffer elsewhere", R"({"byteLength":42})", R"({"byteLength":42,"uri":"a.bin"})"),
      row("a buffer in the JSON", R"({"byteLength":42})", R"({"byteLength":42,"uri":"data:,abc"})"),
      row("buffer 1 of 1", R"("buffer":0,)", R"("buffer":1,)"),
      {"nan", read_glb, good.substr(0, binary) + nan + good.substr(binary + 4)},
      {"a mesh that 2,000 nodes use", read_glb,
       [] {
         std::string numbers = "0", nodes = R"({"mesh":0})";
         for (int i = 1; i < 2000; ++i) numbers += "," + std::to_string(i), nodes += R"(,{"mesh":0})";
         std::string file = replaced(
             replaced(glb_with("", "").substr(20, 100'000), R"("nodes":[0])", "\"nodes\":[" + numbers + "]"),
             R"([{"mesh":0},{"mesh":0}])", "[" + nodes + "]");
         const std::string list = R"({"attributes":{"POSITION":0},"indices":1})";
         std::string many = list;
         for (int i = 1; i < 2000; ++i) many += "," + list;
         file = replaced(file.substr(0, file.rfind('}') + 1), list, many);
         return glb_file(file, glb_with("", "").substr(glb_with("", "").size() - 44));
       }()},
  };
}

void check_all(const std::vector<Hostile>& table, std::size_t least_count) {
  CHECK(table.size() >= least_count);
  for (const Hostile& hostile : table) {
    INFO(hostile.name);
    CHECK(check_hostile(hostile) == "");
  }
}

std::string mutated(std::string bytes, Random& random) {
  static constexpr std::string_view kTokens[] = {
      "-1",   "1e999", "nan", "4294967295", "0",         "9223372036854775807", "#",    "\n",
      "\\\n", "/",     " ",   "f",          "v 1 1 1\n", "\xff\xff\xff\xff",    "list", "3"};
  return changed(std::move(bytes), kTokens, random);
}

// The fault in the answer to arbitrary bytes; empty if none.
std::string check_any(Reader reader, const std::string& bytes) {
  const AllocationMeter meter;
  const auto result = reader(bytes_of(bytes));
  const std::size_t peak = meter.peak();
  const bool may_grow = is_gzip(bytes_of(bytes)) || reader == read_glb;
  const std::size_t unpacked = may_grow ? kMaxGzipRatio * bytes.size() : bytes.size();
  if (peak > (kMaxGrowth + 1) * unpacked + kMaxConstant) return "allocates " + std::to_string(peak);
  if (result) return check_mesh(*result) ? "" : "a bad mesh passes";
  if (result.error().kind != ErrorKind::Input || result.error().message.empty())
    return "another kind of error";
  return {};
}

void check_mutations(Reader reader, const std::vector<std::string>& files, std::uint32_t seed) {
  Random random(seed);
  int accepted = 0;
  constexpr int kMutations = 5000;
  for (int i = 0; i < kMutations; ++i) {
    const std::string bytes = mutated(files[random.below(static_cast<std::uint32_t>(files.size()))], random);
    if (const std::string problem = check_any(reader, bytes); !problem.empty()) {
      INFO("mutation " << i << " of seed " << seed);
      FAIL(problem);
    }
    accepted += reader(bytes_of(bytes)) ? 1 : 0;
  }
  CHECK(accepted > kMutations / 50);  // some changes do no harm: not all mutations die at the first byte
  CHECK(accepted < kMutations * 9 / 10);
}

}  // namespace

TEST_CASE("hostile OBJ files are input errors, and cost no more memory than they are large") {
  check_all(hostile_obj(), 20);
}
TEST_CASE("hostile OFF files are input errors, and cost no more memory than they are large") {
  check_all(hostile_off(), 20);
}
TEST_CASE("hostile STL files are input errors, and cost no more memory than they are large") {
  check_all(hostile_stl(), 15);
}
TEST_CASE("hostile PLY files are input errors, and cost no more memory than they are large") {
  check_all(hostile_ply(), 45);
}

TEST_CASE("hostile GLB files are input errors, and cost no more memory than they may grow") {
  CHECK(read_glb(bytes_of(glb_with("", ""))));
  check_all(hostile_glb(), 60);
}

TEST_CASE("large good files cost no more memory than they are large either") {
  const std::string polygons = "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + std::string("f") + repeated(" 1 2 3", 500'000);
  const std::string bytes = ply_header("binary_little_endian", "1", "1", "uint uchar") +
                            std::string(12, '\0') + std::string("\x40\x42\x0f\0", 4) +
                            std::string(1'000'000, '\0');
  const std::pair<Reader, std::string> files[] = {
      {read_obj, polygons},
      {read_ply, bytes},
      {read_off, "OFF\n1 1 0\n0 0 0\n1000000" + repeated(" 0", 1'000'000)},
      {read_stl, text_stl({cube().positions, std::vector<Triangle>(20'000, Triangle{0, 1, 2})})},
      {read_stl, binary_stl({cube().positions, std::vector<Triangle>(20'000, Triangle{0, 1, 2})})}};
  for (const auto& [reader, file] : files) {
    CHECK(reader(bytes_of(file)));
    CHECK(check_any(reader, file) == "");
  }
}

TEST_CASE("mutated files of every format are read or refused, never worse") {
  const auto begin = std::chrono::steady_clock::now();
  const std::string binary = text_of(write_ply(cube()));
  check_mutations(
      read_obj,
      {text_of(write_obj(cube())), "# x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf -1/1 -2//1 -3/1/1 1 2\n"}, 1);
  check_mutations(read_off,
                  {text_off(cube()), "COFF 4 1 0\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n\n4 0 1 2 3 9\n"}, 2);
  check_mutations(read_stl, {text_stl(cube()), binary_stl(cube())}, 3);
  check_mutations(
      read_ply,
      {binary, elaborate_ply(PlyFormat::Text, cube(), 1), elaborate_ply(PlyFormat::BinaryBig, cube(), 2),
       elaborate_ply(PlyFormat::BinaryLittle, cube(), 3)},
      4);
  Random random(5);  // inside the packing, and the packing itself, whose sum notices nearly everything
  for (int i = 0; i < 1000; ++i) {
    CHECK(check_any(read_ply, gzip(mutated(binary, random))) == "");
    CHECK(check_any(read_ply, mutated(gzip(binary), random)) == "");
  }
  const std::string glb = elaborate_glb(), json = glb.substr(20, glb.find("BIN") - 24),
                    data = glb.substr(glb.size() - 164);
  int accepted = 0;
  for (int i = 0; i < 5000;
       ++i) {  // inside the container, and the container itself, which states its lengths
    const std::string inside =
        glb_file(i % 3 == 0 ? json : mutated(json, random), i % 3 == 1 ? data : mutated(data, random));
    for (const std::string& bytes : {inside, mutated(i % 2 == 0 ? glb : inside, random)})
      if (const std::string problem = check_any(read_glb, bytes); !problem.empty()) {
        INFO("mutation " << i << " of GLB");
        FAIL(problem);
      }
    accepted += read_glb(bytes_of(inside)) ? 1 : 0;
  }
  CHECK(accepted > 500);
  CHECK(accepted < 4500);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  MESSAGE("32,000 mutations in " << wall.count() << " s");
}
