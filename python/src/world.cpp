#include "world.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cstring>
#include <memory>
#include <tuple>

namespace weft::python {
namespace {

namespace nb = nanobind;

using Point = std::array<double, 3>;
using Vectors = nb::ndarray<float, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<float, nb::shape<-1>, nb::c_contig, nb::device::cpu>;
using Numbered = nb::ndarray<const std::uint32_t, nb::shape<-1>, nb::c_contig, nb::device::cpu>;
using Corners = nb::ndarray<const std::uint32_t, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using GivenVectors = nb::ndarray<const float, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Pixels = nb::ndarray<nb::numpy, std::uint8_t, nb::shape<-1, -1, 4>, nb::c_contig>;
using Change = std::pair<std::string, std::string>;
using GivenMesh = std::tuple<std::string, GivenVectors, Corners>;

Vec3d vec(const Point& p) { return {p[0], p[1], p[2]}; }

std::span<const Vec3f> vectors(const GivenVectors& array) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  return {reinterpret_cast<const Vec3f*>(array.data()), array.shape(0)};
}

SharedWorld* make_world(const std::string& json, const std::string& name, const std::vector<Change>& changes,
                        const std::vector<GivenMesh>& meshes, const std::string& models,
                        const std::string& adapter) {
  Result<World> made = [&]() -> Result<World> {
    nb::gil_scoped_release released;
    Result<Scene> scene = Scene::from_text(json, name);
    if (!scene) return scene.error();
    for (const auto& [key, value] : changes)
      if (const Result<void> set = scene->set(key, value); !set) return set.error();
    for (const auto& [mesh, positions, corners] : meshes) {
      const std::span triangles(reinterpret_cast<const Triangle*>(corners.data()), corners.shape(0));
      if (const Result<void> added = scene->add_mesh(mesh, vectors(positions), triangles); !added)
        return added.error();
    }
    scene->set_models_folder(models);
    return World::create(*scene, {.adapter = adapter});
  }();
  return new SharedWorld(value_of(std::move(made)));
}

/// A method that fills an array with one of the world's buffers.
template <Buffer (World::*kBuffer)() const, class Array>
void read(SharedWorld& world, const Array& out) {
  const std::span values(out.data(), out.size());
  check(world.with([&](World& w) { return (w.*kBuffer)().read(values); }));
}

/// A method that takes an array of vectors, one for each node.
template <Result<void> (World::*kSet)(std::span<const Vec3f>)>
void set(SharedWorld& world, const GivenVectors& values) {
  check(world.with([&](World& w) { return (w.*kSet)(vectors(values)); }));
}

nb::ndarray<nb::numpy, std::uint32_t, nb::shape<-1, 3>> triangles(SharedWorld& world) {
  auto copy = world.with([](World& w) {
    return std::make_unique<std::vector<Triangle>>(w.triangles().begin(), w.triangles().end());
  });
  std::vector<Triangle>* owned = copy.release();
  const nb::capsule owner(owned, [](void* p) noexcept { delete static_cast<std::vector<Triangle>*>(p); });
  return {owned->data(), {owned->size(), 3}, owner};
}

void move(SharedWorld& world, const Numbered& nodes, const GivenVectors& places) {
  const std::span numbers(nodes.data(), nodes.size());
  check(world.with([&](World& w) { return w.move(numbers, vectors(places)); }));
}

void set_collider(SharedWorld& world, std::size_t collider, const Point& position,
                  const std::array<double, 4>& rotation) {
  check(world.with([&](World& w) { return w.set_collider(collider, {vec(position), rotation}); }));
}

void set_collider_by(SharedWorld& world, std::size_t collider, const std::array<double, 16>& columns) {
  const Placement placement = value_of(Placement::from_matrix(columns));
  check(world.with([&](World& w) { return w.set_collider(collider, placement); }));
}

nb::dict describe(SharedWorld& world) {
  const Description d = world.with([](World& w) { return w.describe(); });
  nb::dict out;
  out["nodes"] = d.nodes;
  out["triangles"] = d.triangles;
  out["springs"] = d.springs;
  out["membranes"] = d.membranes;
  out["hinges"] = d.hinges;
  out["slivers"] = d.slivers;
  out["tetrahedra"] = d.tetrahedra;
  out["dropped_triangles"] = d.dropped_triangles;
  out["solver"] = d.solver;
  out["solver_reason"] = d.solver_reason;
  out["solver_settings"] = d.solver_settings;
  out["contact_method"] = d.contact_method;
  out["frames"] = d.frames;
  out["substeps"] = d.substeps;
  out["frame_seconds"] = d.frame_seconds;
  out["step_seconds"] = d.step_seconds;
  out["stable_step_seconds"] = d.stable_step_seconds;
  out["unstable_step"] = d.unstable_step;
  return out;
}

nb::dict totals(SharedWorld& world) {
  const Totals now = world.with([](World& w) { return w.totals(); });
  nb::dict out;
  for_each(now, [&](const char* name, auto value) { out[name] = value; });
  return out;
}

View view_of(const std::string& name) {
  static constexpr std::pair<const char*, View> kViews[] = {
      {"textured", View::Textured}, {"wireframe", View::Wireframe}, {"normals", View::Normals},
      {"stretch", View::Stretch},   {"velocity", View::Velocity},   {"contacts", View::Contacts}};
  std::string known;
  for (const auto& [word, view] : kViews) {
    if (name == word) return view;
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  throw Raised{{ErrorKind::Input, "There is no view \"" + name + "\"; there are " + known + "."}};
}

using CameraPlace = std::tuple<Point, Point, double>;  // eye, target, vertical angle

PictureOptions picture_options(std::optional<std::uint32_t> width, std::optional<std::uint32_t> height,
                               const std::optional<std::string>& view,
                               const std::optional<CameraPlace>& camera, bool legend) {
  PictureOptions options{.width = width, .height = height, .legend = legend};
  if (view) options.view = view_of(*view);
  if (camera) {
    const auto& [eye, target, fov_degrees] = *camera;
    options.camera = Camera{vec(eye), vec(target), fov_degrees};
  }
  return options;
}

Pixels render(SharedWorld& world, std::optional<std::uint32_t> width, std::optional<std::uint32_t> height,
              const std::optional<std::string>& view, const std::optional<CameraPlace>& camera, bool legend) {
  const PictureOptions options = picture_options(width, height, view, camera, legend);
  auto image = std::make_unique<Image>(value_of(world.with([&](World& w) { return w.draw(options); })));
  Image* owned = image.release();
  const nb::capsule owner(owned, [](void* p) noexcept { delete static_cast<Image*>(p); });
  return {owned->rgba.data(), {owned->height, owned->width, 4}, owner};
}

/// cloth, triangle, node, point [m], distance [m]
using PickedPlace = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, Point, double>;

std::optional<PickedPlace> pick(SharedWorld& world, const Point& origin, const Point& direction) {
  const auto found = value_of(world.with([&](World& w) { return w.pick({vec(origin), vec(direction)}); }));
  if (!found) return std::nullopt;
  const Vec3d& p = found->point;
  return PickedPlace{found->cloth, found->triangle, found->node, Point{p.x, p.y, p.z}, found->distance};
}

nb::bytes mesh_file(SharedWorld& world, const std::string& format) {
  const auto bytes = value_of(world.with([&](World& w) { return w.mesh_file(format); }));
  return nb::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace

void bind_world(nb::module_& module) {
  nb::class_<SharedWorld>(module, "World")
      .def(nb::new_(&make_world), nb::arg("json"), nb::arg("name"), nb::arg("changes"), nb::arg("meshes"),
           nb::arg("models"), nb::arg("adapter"))
      .def("advance", [](SharedWorld& world) { check(world.with([](World& w) { return w.advance(); })); })
      .def("finish", [](SharedWorld& world) { check(world.with([](World& w) { return w.finish(); })); })
      .def("reset", [](SharedWorld& world) { check(world.with([](World& w) { return w.reset(); })); })
      .def("frame", [](SharedWorld& world) { return world.with([](World& w) { return w.frame(); }); })
      .def("time", [](SharedWorld& world) { return world.with([](World& w) { return w.time(); }); })
      .def("nodes",
           [](SharedWorld& world) { return world.with([](World& w) { return w.position().count(); }); })
      .def("read_positions", &read<&World::position, Vectors>, nb::arg("out").noconvert())
      .def("read_velocities", &read<&World::velocity, Vectors>, nb::arg("out").noconvert())
      .def("read_normals", &read<&World::normal, Vectors>, nb::arg("out").noconvert())
      .def("read_stretch", &read<&World::stretch, Numbers>, nb::arg("out").noconvert())
      .def("set_positions", &set<&World::set_positions>, nb::arg("values"))
      .def("set_velocities", &set<&World::set_velocities>, nb::arg("values"))
      .def("push", &set<&World::push>, nb::arg("impulses"))
      .def("move", &move, nb::arg("nodes"), nb::arg("places"))
      .def("given_nodes",
           [](SharedWorld& world) { return world.with([](World& w) { return w.given_nodes(); }); })
      .def("set_collider", &set_collider, nb::arg("collider"), nb::arg("position"), nb::arg("rotation"))
      .def("set_collider_by", &set_collider_by, nb::arg("collider"), nb::arg("columns"))
      .def("given_colliders",
           [](SharedWorld& world) { return world.with([](World& w) { return w.given_colliders(); }); })
      .def("triangles", &triangles)
      .def(
          "change",
          [](SharedWorld& world, const std::string& key, const std::string& value) {
            check(world.with([&](World& w) { return w.change(key, value); }));
          },
          nb::arg("key"), nb::arg("value"))
      .def(
          "grab",
          [](SharedWorld& world, std::uint32_t node, const Point& target) {
            check(world.with([&](World& w) { return w.grab(node, vec(target)); }));
          },
          nb::arg("node"), nb::arg("target"))
      .def(
          "drag",
          [](SharedWorld& world, std::uint32_t node, const Point& target) {
            check(world.with([&](World& w) { return w.drag(node, vec(target)); }));
          },
          nb::arg("node"), nb::arg("target"))
      .def(
          "release",
          [](SharedWorld& world, std::uint32_t node) {
            check(world.with([&](World& w) { return w.release(node); }));
          },
          nb::arg("node"))
      .def("pick", &pick, nb::arg("origin"), nb::arg("direction"))
      .def("state_hash",
           [](SharedWorld& world) { return value_of(world.with([](World& w) { return w.state_hash(); })); })
      .def("mesh_file", &mesh_file, nb::arg("format"))
      .def("describe", &describe)
      .def("totals", &totals)
      .def("adapter",
           [](SharedWorld& world) { return world.with([](World& w) { return w.adapter().name; }); })
      .def("gpu_bytes", [](SharedWorld& world) { return world.with([](World& w) { return w.gpu_bytes(); }); })
      .def("render", &render, nb::arg("width"), nb::arg("height"), nb::arg("view"), nb::arg("camera"),
           nb::arg("legend"));
}

}  // namespace weft::python
