#include "scene/build.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "scene/build_collider.hpp"
#include "scene/build_motion.hpp"
#include "scene/checked_values.hpp"
#include "scene/content_hash.hpp"
#include "scene/copies.hpp"
#include "scene/fabrics.hpp"
#include "scene/grab.hpp"
#include "scene/looks.hpp"
#include "scene/names.hpp"

namespace weft::scene {
namespace {

constexpr double kLeastNeoHookeanPoisson = 0.4;

class Builder {
 public:
  explicit Builder(const std::string& file) : file_(file) {}

  Result<Scene> scene(const Json& json) {
    Scene scene;
    scene.file = file_;
    scene.content = content_hash(json);
    scene.title = text(json, "title");
    scene.description = text(json, "description");
    scene.gravity = vector(json, "gravity");
    scene.external_force = vector(json, "external_force");
    scene.drag = number(json, "drag");
    const Json& wind = at(json, "wind");
    scene.wind = {vector(wind, "velocity"), number(wind, "gusts"), number(wind, "wavelength")};
    if (const Json* air = json.find("air"))
      scene.air = Air{number(*air, "density"), number(*air, "pressure"), number(*air, "lift"),
                      number(*air, "friction")};
    scene.time = time(at(json, "time"));
    scene.solver = solver(at(json, "solver"));
    WEFT_TRY(contact, this->contact(at(json, "contact")));
    scene.contact = contact;
    for (const char* list : {"cloths", "bodies"}) {
      const bool solid = list == std::string_view("bodies");
      const std::vector<Json>& entries = at(json, list).values;
      for (std::size_t entry = 0; entry < entries.size(); ++entry) {
        const std::string path = path_of_index(list, entry);
        WEFT_TRY(copies, copies_of(entries[entry], file_, path));
        WEFT_TRY(first, solid ? body(entries[entry], path, copies.count)
                              : cloth(entries[entry], path, copies.count));
        first.entry = entry;
        for (std::uint32_t k = 0; k < copies.count; ++k) {
          scene.cloths.push_back(shifted(first, copies.offset * k));
          scene.cloths.back().copy = k;
        }
      }
    }
    if (scene.cloths.empty())
      return input_error("%s: the scene has neither cloths nor bodies; it needs one.", file_.c_str());
    WEFT_CHECK(check_grabs(scene.cloths));
    WEFT_CHECK(check_solver(scene));
    for (const Json& one : at(json, "colliders").values) {
      const std::string path = path_of_index("colliders", scene.colliders.size());
      WEFT_TRY(built, build_collider(one, scene.contact.method, file_, path));
      scene.colliders.push_back(std::move(built));
    }
    WEFT_CHECK(check_rigid(scene));
    if (const Json* camera = json.find("camera")) {
      scene.camera =
          Camera{vector(*camera, "eye"), vector(*camera, "target"), number(*camera, "fov_degrees")};
      if (scene.camera->eye == scene.camera->target) return wrong("camera.target", "is the eye itself");
    }
    const Json& render = at(json, "render");
    scene.render.view = word<View>(at(render, "view"), kViewNames);
    scene.render.width = whole(at(render, "size").values[0]);
    scene.render.height = whole(at(render, "size").values[1]);
    scene.render.subdivide = whole(at(render, "subdivide"));
    const Json& light = at(render, "light");
    scene.render.light = {word<Environment>(at(light, "environment"), kEnvironmentNames), std::nullopt,
                          number(light, "degrees")};
    if (light.find("direction")) scene.render.light.direction = vector(light, "direction");
    if (scene.render.subdivide > 0)
      for (const Cloth& cloth : scene.cloths)
        if (!cloth.grid || cloth.strength || !cloth.seams.empty())
          return wrong("render.subdivide",
                       "is " + std::to_string(scene.render.subdivide) + ", and " + path_of(cloth) +
                           (cloth.solid            ? " is a body"
                            : cloth.strength       ? " tears"
                            : !cloth.seams.empty() ? " is sewn"
                                                   : " is a mesh") +
                           "; only grids that " + (cloth.seams.empty() ? "do not tear" : "are not sewn") +
                           " are drawn finer");
    return scene;
  }

 private:
  std::string where(const std::string& path) const { return file_ + ": " + path; }
  Error wrong(const std::string& path, const std::string& what) const {
    return input_error("%s %s.", where(path).c_str(), what.c_str());
  }

  /// A kind that has no use for a setting keeps its default.
  static Solver solver(const Json& json) {
    Solver solver;
    solver.kind = word<SolverKind>(at(json, "kind"), kSolverKindNames);
    if (const Json* forces = json.find("forces")) solver.forces = word<Forces>(*forces, kForcesNames);
    if (const Json* iterations = json.find("iterations")) solver.iterations = whole(*iterations);
    if (json.find("residual") != nullptr) solver.residual = number(json, "residual");
    return solver;
  }

  static Time time(const Json& json) {
    Time time;
    time.frame = number(json, "frame");
    const Json& substeps = at(json, "substeps");
    if (substeps.kind == Json::Kind::Number) time.substeps = whole(substeps);
    time.frames = whole(at(json, "frames"));
    return time;
  }

  Result<Contact> contact(const Json& json) const {
    Contact contact;
    contact.method = word<ContactMethod>(at(json, "method"), kContactMethodNames);
    contact.thickness = number(json, "thickness");
    contact.self = at(json, "self").boolean;
    contact.restitution = number(json, "restitution");
    if (contact.method == ContactMethod::Proximity && contact.thickness == 0)
      return wrong("contact.thickness", "is 0; contact.method \"proximity\" needs one above 0 m");
    return contact;
  }

  Result<Cloth> cloth(const Json& json, const std::string& path, std::uint32_t copies) {
    Cloth cloth;
    cloth.where = where(path);
    cloth.name = text(json, "name");
    cloth.mesh = text(json, "mesh");
    if (const Json* grid = json.find("grid")) {
      cloth.grid = grid_shape(json, *grid);
      cloth.grid->bump = number(json, "bump");
      WEFT_CHECK(count_nodes(path + ".grid", std::uint64_t{copies} * cloth.grid->nx * cloth.grid->ny));
    }
    if (const Json* panels = json.find("panels"))
      for (const Json& one : panels->values)
        WEFT_CHECK(add_panel(cloth, one, path_of_index(path + ".panels", cloth.panels.size()), copies));
    cloth.transform = transform_of(at(json, "transform"));
    cloth.density = maybe_number(json, "density");
    cloth.node_mass = maybe_number(json, "node_mass");
    if (const Json* given = json.find("fabric")) WEFT_SET(cloth.fabric, fabric(*given, path + ".fabric"));
    const NamedFabric* named = cloth.fabric ? find_fabric(cloth.fabric->name) : nullptr;
    if (named && !cloth.density && !cloth.node_mass) cloth.density = named->density.value;
    const Json& stiffness = at(json, "stiffness");
    cloth.stiffness = {number(stiffness, "structural"), number(stiffness, "shear"), number(stiffness, "bend"),
                       number(stiffness, "bending")};
    cloth.look = look(
        json.find("look"),
        json.find("pressure") ? "rubber" : look_of_fabric(cloth.fabric ? cloth.fabric->name : std::string{}));
    cloth.damping = number(json, "damping");
    cloth.friction = maybe_number(json, "friction").value_or(named ? named->friction.value : cloth.friction);
    cloth.strain_limit = maybe_number(json, "strain_limit");
    if (const Json* given = json.find("tethers")) {
      if (at(json, "pins").values.empty() && at(json, "motions").values.empty() &&
          at(json, "attachments").values.empty())
        return wrong(path + ".tethers",
                     "is of cloth that something holds; this one has no pins, motions or attachments");
      cloth.tethers = {number(*given, "slack")};
    }
    if (const Json* given = json.find("pressure"))
      WEFT_SET(cloth.pressure, pressure(*given, path + ".pressure"));
    WEFT_CHECK(add_nodes(cloth, json, path));
    if (const auto strength = maybe_number(json, "strength")) {
      cloth.strength = strength;
      for (const char* key : {"strain_limit", "tethers", "pressure"})
        if (json.find(key))
          return wrong(path + ".strength",
                       "is " + number_text(*strength) + " N/m; a cloth that tears has no " + in_quotes(key));
    }
    if (const Json* seams = json.find("seams")) {
      for (const Json& one : seams->values) {
        WEFT_TRY(built, seam(one, path_of_index(path + ".seams", cloth.seams.size()), cloth));
        cloth.seams.push_back(std::move(built));
      }
      for (const char* key : {"tethers", "pressure", "strength"})
        if (json.find(key))
          return wrong(path + ".seams",
                       "are of a cloth that has " + in_quotes(key) + ", which sewing cannot follow");
    }
    return cloth;
  }

  static GridShape grid_shape(const Json& json, const Json& grid) {
    const std::vector<Json>& size = at(json, "size").values;
    return {whole(grid.values[0]), whole(grid.values[1]), size[0].number, size[1].number,
            word<Plane>(at(json, "plane"), kPlaneNames)};
  }

  Result<void> add_panel(Cloth& cloth, const Json& json, const std::string& path, std::uint32_t copies) {
    Panel panel;
    panel.mesh = text(json, "mesh");
    if (const Json* grid = json.find("grid")) {
      panel.grid = grid_shape(json, *grid);
      WEFT_CHECK(count_nodes(path + ".grid", std::uint64_t{copies} * panel.grid->nx * panel.grid->ny));
    }
    panel.transform = transform_of(at(json, "transform"));
    cloth.panels.push_back(std::move(panel));
    return {};
  }

  Result<SeamRow> seam_row(const Json& json, const std::string& path, const Cloth& cloth) const {
    SeamRow row;
    row.panel = whole(at(json, "panel"));
    const std::size_t panels = std::max<std::size_t>(cloth.panels.size(), 1);
    if (row.panel >= panels)
      return wrong(path + ".panel", "is " + std::to_string(row.panel) + ", and the cloth has " +
                                        std::to_string(panels) + ", counted from 0");
    Cloth shape;  // whose parts have names
    shape.grid = cloth.panels.empty() ? cloth.grid : cloth.panels[row.panel].grid;
    WEFT_SET(row.nodes, selectors(at(json, "nodes"), path + ".nodes", shape));
    return row;
  }

  Result<Seam> seam(const Json& json, const std::string& path, const Cloth& cloth) const {
    Seam seam;
    seam.where = where(path);
    WEFT_SET(seam.first, seam_row(at(json, "first"), path + ".first", cloth));
    WEFT_SET(seam.second, seam_row(at(json, "second"), path + ".second", cloth));
    seam.reversed = at(json, "reversed").boolean;
    seam.force = number(json, "force");
    seam.speed = number(json, "speed");
    seam.within = number(json, "within");
    seam.start = number(json, "start");
    seam.patience = number(json, "patience");
    return seam;
  }

  Result<Cloth> body(const Json& json, const std::string& path, std::uint32_t copies) {
    Cloth body;
    body.where = where(path);
    body.name = text(json, "name");
    Solid solid;
    if (const Json* cells = json.find("block")) {
      solid.block = BlockShape{{whole(cells->values[0]), whole(cells->values[1]), whole(cells->values[2])},
                               vector(json, "size")};
      std::uint64_t nodes = copies;
      for (const std::uint32_t count : solid.block->cells) nodes *= count + 1;
      WEFT_CHECK(count_nodes(path + ".block", nodes));
    }
    solid.tetrahedra = text(json, "tetrahedra");
    solid.surface = text(json, "surface");
    solid.cell = maybe_number(json, "cell").value_or(0);
    const Json& material = at(json, "material");
    solid.young = number(material, "young");
    solid.poisson = number(material, "poisson");
    solid.damping = number(material, "damping");
    solid.energy = word<SolidEnergy>(at(material, "energy"), kSolidEnergyNames);
    // What a body of (1) bears across its free sides ends at 2.2 E there, and falls with it: docs/bodies.md.
    if (solid.energy == SolidEnergy::NeoHookean && solid.poisson < kLeastNeoHookeanPoisson)
      return wrong(path + ".material.poisson", "is " + number_text(solid.poisson) +
                                                   "; energy \"neo_hookean\" needs at least " +
                                                   number_text(kLeastNeoHookeanPoisson) +
                                                   ", below which \"corotated\" bears pressing better");
    body.solid = std::move(solid);
    body.look = look_of("rubber");
    body.transform = transform_of(at(json, "transform"));
    body.density = number(json, "density");
    body.friction = number(json, "friction");
    WEFT_CHECK(add_nodes(body, json, path));
    return body;
  }

  /// All grids and blocks together have a limit, known before anything is made of them.
  Result<void> count_nodes(const std::string& path, std::uint64_t nodes) {
    grid_nodes_ += nodes;
    if (grid_nodes_ > kMaxGridNodes)
      return wrong(path, "brings the grids and blocks to " + std::to_string(grid_nodes_) +
                             " nodes, more than the limit of " + std::to_string(kMaxGridNodes));
    return {};
  }

  /// What the scene does with its nodes, and its colour.
  Result<void> add_nodes(Cloth& cloth, const Json& json, const std::string& path) const {
    WEFT_TRY(pins, selectors(at(json, "pins"), path + ".pins", cloth));
    cloth.pins = std::move(pins);
    for (const Json& one : at(json, "motions").values) {
      WEFT_TRY(built, motion(one, path_of_index(path + ".motions", cloth.motions.size()), cloth));
      cloth.motions.push_back(std::move(built));
    }
    for (const Json& one : at(json, "attachments").values) {
      WEFT_TRY(built, attachment(one, path_of_index(path + ".attachments", cloth.attachments.size()), cloth));
      cloth.attachments.push_back(std::move(built));
    }
    for (const Json& one : at(json, "grabs").values) {
      WEFT_TRY(built, grab(one, path_of_index(path + ".grabs", cloth.grabs.size()), cloth));
      cloth.grabs.push_back(std::move(built));
    }
    if (const Json* color = json.find("color")) cloth.color = vector(*color);
    return {};
  }

  /// Reads  given: a name, an object or null; usual: the name of the look where nothing else is given.
  static Look look(const Json* given, const char* usual) {
    if (given == nullptr) return look_of(usual);
    if (given->kind == Json::Kind::Text) return look_of(given->text);
    Look look = look_of(given->find("name") ? given->find("name")->text : usual);
    if (const Json* weave = given->find("weave")) look.weave = word<Weave>(*weave, kWeaveNames);
    if (const Json* pattern = given->find("pattern")) look.pattern = word<Pattern>(*pattern, kPatternNames);
    if (const Json* weft = given->find("weft")) look.weft = vector(*weft);
    if (const Json* stripe = given->find("stripe")) look.stripe = vector(*stripe);
    look.threads_per_cm = maybe_number(*given, "threads_per_cm").value_or(look.threads_per_cm);
    look.sheen = maybe_number(*given, "sheen").value_or(look.sheen);
    look.gloss = maybe_number(*given, "gloss").value_or(look.gloss);
    look.translucency = maybe_number(*given, "translucency").value_or(look.translucency);
    return look;
  }

  Result<Fabric> fabric(const Json& json, const std::string& path) const {
    if (json.kind == Json::Kind::Text) return moduli_of(*find_fabric(json.text));
    const NamedFabric* named = find_fabric(text(json, "name"));
    Fabric fabric = named ? moduli_of(*named) : Fabric{};
    fabric.warp = maybe_number(json, "warp").value_or(fabric.warp);
    fabric.weft = maybe_number(json, "weft").value_or(named ? fabric.weft : fabric.warp);
    fabric.shear = maybe_number(json, "shear").value_or(fabric.shear);
    fabric.poisson = maybe_number(json, "poisson").value_or(fabric.poisson);
    fabric.bending_warp = maybe_number(json, "bending_warp").value_or(fabric.bending_warp);
    fabric.bending_weft =
        maybe_number(json, "bending_weft").value_or(named ? fabric.bending_weft : fabric.bending_warp);
    const double twist = 0.5 * std::sqrt(fabric.bending_warp * fabric.bending_weft);
    fabric.bending_twist = maybe_number(json, "bending_twist").value_or(named ? fabric.bending_twist : twist);
    fabric.damping = number(json, "damping");
    fabric.energy = word<FabricEnergy>(at(json, "energy"), kFabricEnergyNames);
    fabric.warp_direction = vector(json, "warp_direction");
    fabric.rest_angles = word<RestAngles>(at(json, "rest_angles"), kRestAnglesNames);
    if (const Json* given = json.find("plastic"))
      fabric.plastic = {number(*given, "yield_curvature"), number(*given, "hardening")};
    // At warp / weft the cloth resists one strain with nothing, and another without end.
    const double most = 0.9999 * fabric.warp / fabric.weft;
    if (fabric.poisson * fabric.poisson >= most)
      return wrong(path + ".poisson", "is " + number_text(fabric.poisson) +
                                          "; its square must be below 0.9999 warp / weft, " +
                                          number_text(most));
    if (fabric.energy == FabricEnergy::NeoHookean) WEFT_CHECK(check_isotropic(fabric, path));
    if (fabric.plastic && !fabric.bends())
      return wrong(path + ".plastic",
                   "is of bends that stay, and bending_warp, bending_weft and bending_twist are 0: "
                   "such a cloth resists none");
    return fabric;
  }

  Result<Pressure> pressure(const Json& json, const std::string& path) const {
    const Pressure pressure = {number(json, "gauge"), number(json, "ambient"),
                               word<GasLaw>(at(json, "law"), kGasLawNames)};
    if (pressure.law == GasLaw::Isothermal && !(pressure.ambient + pressure.gauge > 0))
      return wrong(path + ".gauge", "is " + number_text(pressure.gauge) + " Pa; with the ambient one, " +
                                        number_text(pressure.ambient) +
                                        " Pa, the pressure of a gas must be above 0");
    return pressure;
  }

  /// A stable solid has no axes: one modulus, Poisson's ratio, and the shear modulus that follows.
  Result<void> check_isotropic(const Fabric& fabric, const std::string& path) const {
    const double shear = fabric.warp / (2 * (1 + fabric.poisson));
    if (fabric.weft != fabric.warp)
      return wrong(path + ".weft", "is " + number_text(fabric.weft) +
                                       " N/m; energy \"neo_hookean\" has no axes and needs that of warp, " +
                                       number_text(fabric.warp));
    if (std::abs(fabric.shear - shear) > 1e-3 * shear)
      return wrong(path + ".shear",
                   "is " + number_text(fabric.shear) +
                       " N/m; energy \"neo_hookean\" has no axes and needs warp / (2 + 2 poisson), " +
                       number_text(shear));
    return {};
  }

  Result<std::vector<Selector>> selectors(const Json& json, const std::string& path,
                                          const Cloth& cloth) const {
    std::vector<Selector> all;
    if (json.kind != Json::Kind::List) {
      WEFT_TRY(one, selector(json, path, cloth));
      all.push_back(std::move(one));
      return all;
    }
    for (const Json& entry : json.values) {
      WEFT_TRY(one, selector(entry, path_of_index(path, all.size()), cloth));
      all.push_back(std::move(one));
    }
    return all;
  }

  Result<Selector> selector(const Json& json, const std::string& path, const Cloth& cloth) const {
    if (json.kind == Json::Kind::Text) {
      if (!cloth.grid) return wrong(path, "is " + in_quotes(json.text) + ", a part that only a grid has");
      return Selector{where(path), word<GridPart>(json, kGridPartNames)};
    }
    if (const Json* box = json.find("box")) {
      const SelectorBox what{vector(*box, "min"), vector(*box, "max")};
      for (int axis = 0; axis < 3; ++axis)
        if (what.max[axis] < what.min[axis])
          return wrong(path_of_index(path + ".box.max", static_cast<std::size_t>(axis)),
                       "is " + number_text(what.max[axis]) + ", below the box's min of " +
                           number_text(what.min[axis]));
      return Selector{where(path), what};
    }
    if (const Json* near = json.find("near"))
      return Selector{where(path), SelectorNear{vector(*near, "point"), number(*near, "radius")}};
    SelectorNodes what;
    for (const Json& index : at(json, "nodes").values) what.indices.push_back(whole(index));
    return Selector{where(path), std::move(what)};
  }

  Result<Motion> motion(const Json& json, const std::string& path, const Cloth& cloth) const {
    Motion motion;
    motion.where = where(path);
    WEFT_TRY(nodes, selectors(at(json, "nodes"), path + ".nodes", cloth));
    motion.nodes = std::move(nodes);
    WEFT_TRY(shape, build_motion(json, file_, path));
    motion.shape = std::move(shape);
    return motion;
  }

  /// What rigid bodies do not meet, and what cannot follow them.
  Result<void> check_rigid(const Scene& scene) const {
    if (!has_rigid(scene)) return {};
    for (std::size_t c = 0; c < scene.colliders.size(); ++c)
      if (std::holds_alternative<ColliderMesh>(scene.colliders[c]))
        return input_error(
            "%s: %s is a mesh, which rigid bodies do not meet; they meet spheres, boxes, capsules, planes "
            "and "
            "convex hulls.",
            file_.c_str(), path_of_index("colliders", c).c_str());
    for (const Cloth& cloth : scene.cloths)
      for (const Attachment& attachment : cloth.attachments)
        if (attachment.collider < scene.colliders.size() &&
            rigid_of(scene.colliders[attachment.collider]) != nullptr)
          return input_error(
              "%s holds nodes to colliders[%zu], a rigid body; nodes follow what the scene moves.",
              attachment.where.c_str(), attachment.collider);
    return {};
  }

  Result<Attachment> attachment(const Json& json, const std::string& path, const Cloth& cloth) const {
    Attachment attachment;
    attachment.where = where(path);
    WEFT_SET(attachment.nodes, selectors(at(json, "nodes"), path + ".nodes", cloth));
    attachment.collider = whole(at(json, "collider"));
    attachment.reach = number(json, "reach");
    return attachment;
  }

  Result<Grab> grab(const Json& json, const std::string& path, const Cloth& cloth) const {
    Grab grab;
    grab.where = where(path);
    WEFT_TRY(node, selector(at(json, "node"), path + ".node", cloth));
    grab.node = std::move(node);
    grab.start = number(json, "start");
    grab.end = maybe_number(json, "end");
    if (grab.end && *grab.end <= grab.start)
      return wrong(path + ".end", "is " + number_text(*grab.end) + " s, not after the start at " +
                                      number_text(grab.start) + " s");
    for (const Json& point : at(json, "path").values) {
      const double time = number(point, "time");
      if (!grab.path.empty() && time <= grab.path.back().time)
        return wrong(path_of_index(path + ".path", grab.path.size()) + ".time",
                     "is " + number_text(time) + " s, not after the " + number_text(grab.path.back().time) +
                         " s of the point before it");
      grab.path.push_back({time, vector(point, "point")});
    }
    return grab;
  }

  /// Bending needs the rows and columns of a grid; sums by springs have springs only.
  Result<void> check_solver(const Scene& scene) const {
    for (const Cloth& cloth : scene.cloths) {
      const std::string path = path_of(cloth);
      if (cloth.solid && scene.solver.forces != Forces::NodeCentric)
        return wrong(path, "has no springs; solver.forces " + in_quotes(name_of(scene.solver.forces)) +
                               " has springs only");
      if (cloth.fabric) WEFT_CHECK(check_fabric(scene, cloth, path));
      if (!cloth.seams.empty() && scene.solver.forces != Forces::NodeCentric)
        return wrong(path + ".seams", "are sewn by threads, which solver.forces " +
                                          in_quotes(name_of(scene.solver.forces)) + " does not take");
      if (cloth.stiffness.bending == 0) continue;
      const std::string bending = "is " + number_text(cloth.stiffness.bending) + " N·m; ";
      if (scene.solver.forces != Forces::NodeCentric)
        return wrong(
            path + ".stiffness.bending",
            bending + "solver.forces " + in_quotes(name_of(scene.solver.forces)) + " has springs only");
      if (!cloth.grid) return wrong(path + ".stiffness.bending", bending + "a mesh has bend springs only");
      if (cloth.strength || !cloth.seams.empty())
        return wrong(path + ".stiffness.bending", bending + "a grid with " +
                                                      in_quotes(cloth.strength ? "strength" : "seams") +
                                                      " is a mesh, which has bend springs only");
    }
    return {};
  }

  /// Fabric has no springs, so nothing may be said of them.
  Result<void> check_fabric(const Scene& scene, const Cloth& cloth, const std::string& path) const {
    if (scene.solver.forces != Forces::NodeCentric)
      return wrong(path + ".fabric", "has no springs; solver.forces " +
                                         in_quotes(name_of(scene.solver.forces)) + " has springs only");
    if (!(cloth.stiffness == Stiffness{}))
      return wrong(path + ".stiffness", "is of springs; a cloth with \"fabric\" has none");
    if (cloth.damping != Cloth{}.damping)
      return wrong(path + ".damping", "is of springs; a cloth with \"fabric\" has fabric.damping instead");
    if (cloth.grid && !(cloth.fabric->warp_direction == Fabric{}.warp_direction))
      return wrong(path + ".fabric.warp_direction", "is of meshes; the warp of a grid goes along i");
    if (cloth.grid && cloth.fabric->rest_angles != RestAngles::Mesh)
      return wrong(path + ".fabric.rest_angles", "is of meshes; a grid is flat at rest");
    return {};
  }

  /// No more grabs at any time than there are places.
  Result<void> check_grabs(const std::vector<Cloth>& cloths) const {
    std::vector<Hold> holds;
    for (const Cloth& cloth : cloths)
      for (const Grab& grab : cloth.grabs) holds.push_back(hold_of(grab));
    const MostAtOnce most = most_at_once(std::move(holds));
    if (most.count > kMaxGrabs)
      return input_error("%s: at %g s grabs hold %zu nodes; the limit is %zu at once.", file_.c_str(),
                         most.time, most.count, kMaxGrabs);
    return {};
  }

  const std::string& file_;
  std::uint64_t grid_nodes_ = 0;
};

}  // namespace

Result<Scene> build_scene(const Json& json, const std::string& file) { return Builder(file).scene(json); }

}  // namespace weft::scene
