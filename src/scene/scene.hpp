// A scene as plain data, as docs/scene.md describes it. SI units; y points up. load.hpp reads and checks one.
// Two things are equal wherever they stand: `where` is for messages and is not compared.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/vec.hpp"
#include "weft/placement.hpp"
#include "weft/view.hpp"

namespace weft::scene {

/// Scale first, then rotation, then translation.
struct Transform {
  double scale = 1;
  std::array<double, 4> rotate{0, 0, 0, 1};  // unit quaternion x, y, z, w
  Vec3d translate;                           // [m]
  bool operator==(const Transform&) const = default;
};

/// A part of a grid cloth by name. Row j = 0 is the top, column i = 0 is the left.
enum class GridPart { TopLeft, TopRight, BottomLeft, BottomRight, Top, Bottom, Left, Right, Corners, Edges };

/// Nodes whose rest position in the world lies in a box, faces included [m].
struct SelectorBox {
  Vec3d min, max;
  bool operator==(const SelectorBox&) const = default;
};
/// Nodes whose rest position in the world is at most `radius` from `point` [m].
struct SelectorNear {
  Vec3d point;
  double radius = 0;
  bool operator==(const SelectorNear&) const = default;
};
/// Nodes by index: row by row on a grid (j * nx + i), the file's order on a mesh.
struct SelectorNodes {
  std::vector<std::uint32_t> indices;
  bool operator==(const SelectorNodes&) const = default;
};
/// Which nodes of a cloth are meant; select.hpp finds them.
struct Selector {
  std::string where;  // file and JSON path, for messages: "scenes/a.json: cloths[0].pins[1]"
  std::variant<GridPart, SelectorBox, SelectorNear, SelectorNodes> what;
  bool operator==(const Selector& other) const { return what == other.what; }
};

/// A translation along a line, with speed and place given by `start`, `ramp` and `distance` (motion.hpp).
struct MotionLine {
  Vec3d direction;                 // unit
  double speed = 0;                // [m/s]
  std::optional<double> distance;  // [m]; none: without end
  double start = 0, ramp = 0;      // [s]
  bool operator==(const MotionLine&) const = default;
};
struct PathPoint {
  double time = 0;  // [s]
  Vec3d offset;     // from the rest position [m]
  bool operator==(const PathPoint&) const = default;
};
/// A translation along straight pieces between points at rising times.
struct MotionPath {
  std::vector<PathPoint> points;
  bool loops = false;  // after the last point, where it is as at time 0, it begins anew
  bool operator==(const MotionPath&) const = default;
};
/// A rotation about an axis through `center`, right-handed.
struct MotionRotation {
  Vec3d axis;                   // unit
  Vec3d center;                 // in the world [m]
  double speed = 0;             // [rad/s]
  std::optional<double> angle;  // [rad]; none: without end
  double start = 0, ramp = 0;   // [s]
  bool operator==(const MotionRotation&) const = default;
};
/// Nodes that a program moves (sim::World::move), each by itself and straight; until then they stay.
struct MotionGiven {
  double speed = 0;           // the most that it may move one by [m/s]
  double begin = 0, end = 0;  // of the last way [s]
  Vec3d from, to;             // from the rest position [m]
  bool operator==(const MotionGiven&) const = default;
};
/// The way of a collider through a frame that a program has given it, along the screw between the two (screw.hpp).
struct CarriedWay {
  double begin = 0, end = 0;  // [s]
  Placement from, to;
  bool operator==(const CarriedWay&) const = default;
};
/// A collider that a program moves (sim::World::set_collider), and what is attached to it; until then it stays. How it
/// has been moved is not compared.
struct MotionCarried {
  double speed = 0;              // the most that it may move a point of it by [m/s]
  std::vector<CarriedWay> ways;  // the last ones: each begins where that before it ended
  std::size_t collider = 0;      // of the scene's: of nodes that are attached to it
  bool operator==(const MotionCarried& other) const { return speed == other.speed; }
};
using MotionShape = std::variant<MotionLine, MotionPath, MotionRotation, MotionGiven, MotionCarried>;
/// Nodes that follow a given motion instead of the forces.
struct Motion {
  std::string where;  // file and JSON path
  std::vector<Selector> nodes;
  MotionShape shape;
  bool operator==(const Motion& other) const { return nodes == other.nodes && shape == other.shape; }
};

/// Nodes that go where a collider's surface takes them: each with the point that is nearest at time 0.
struct Attachment {
  std::string where;  // file and JSON path
  std::vector<Selector> nodes;
  std::size_t collider = 0;  // of the scene's
  double reach = 0;          // how far a node may be from it [m]
  bool operator==(const Attachment& other) const {
    return nodes == other.nodes && collider == other.collider && reach == other.reach;
  }
};

struct GrabPoint {
  double time = 0;  // [s]
  Vec3d point;      // in the world [m]
  bool operator==(const GrabPoint&) const = default;
};
/// One free node that is pulled along a path for a while (grab.hpp).
struct Grab {
  std::string where;  // file and JSON path
  Selector node;
  double start = 0;           // [s]
  std::optional<double> end;  // when it is let go [s]; none: never
  std::vector<GrabPoint> path;
  bool operator==(const Grab& other) const {
    return node == other.node && start == other.start && end == other.end && path == other.path;
  }
};

/// Where a grid lies before its transform, centred on the origin.
enum class Plane {
  Xy,  ///< hangs: i grows with +x, j with -y
  Xz,  ///< lies flat: i grows with +x, j with +z
};
struct GridShape {
  std::uint32_t nx = 0, ny = 0;  // nodes
  double width = 0, height = 0;  // along i and along j [m]
  Plane plane = Plane::Xy;
  double bump = 0;  // how far the middle stands out at the start [m]
  bool operator==(const GridShape&) const = default;
};

/// Of springs [N/m].
struct Stiffness {
  double structural = 5000, shear = 2000, bend = 500;
  double bending = 0;  // of the sheet itself, quadratic [N·m]
  bool operator==(const Stiffness&) const = default;
};

/// Which strains a fabric's energy is of (docs/elements.md, Membrane).
enum class FabricEnergy { Yarn, Green, NeoHookean };
/// The angles at the edges of a mesh that nothing bends: those that it has, or none.
enum class RestAngles { Mesh, Flat };

/// When a bend stays (docs/elements.md, Creases).
struct Plastic {
  double yield_curvature = 0;  // up to which the cloth springs back [1/m]
  double hardening = 0;        // how much that grows by all curvature that was kept
  bool operator==(const Plastic&) const = default;
};

/// A measured cloth: what strips of it resist with.
struct Fabric {
  std::string
      name;  // in the table of fabrics.hpp, before anything was changed; none: the scene has all numbers
  double warp = 0, weft = 0, shear = 0;  // Young's moduli and shear modulus, force per width [N/m]
  double poisson = 0;                    // weft's contraction by warp's extension
  double bending_warp = 0, bending_weft = 0, bending_twist = 0;  // [N·m]
  double damping = 0.0001;                                       // delay of Kelvin and Voigt [s]
  FabricEnergy energy = FabricEnergy::Yarn;
  Vec3d warp_direction{1, 0, 0};              // on a mesh, before its transform; a grid's warp goes along i
  RestAngles rest_angles = RestAngles::Mesh;  // of a mesh; a grid is flat
  std::optional<Plastic> plastic;             // none: it springs back from every bend

  /// Whether it resists bending.
  bool bends() const { return bending_warp > 0 || bending_weft > 0 || bending_twist > 0; }
  bool operator==(const Fabric&) const = default;
};

/// How far a node may be from what holds its cloth (docs/solvers/xpbd.md, Tethers).
struct Tethers {
  /// By which a tether is longer than the way to there along the cloth at rest, as a part of it.
  double slack = 0;
  bool operator==(const Tethers&) const = default;
};

/// How the pressure in a closed cloth goes with its volume (docs/pressure.md).
enum class GasLaw { Isothermal, Constant };

/// Of the gas in a closed cloth.
struct Pressure {
  double gauge = 0;         // above that outside, at the volume at rest [Pa]
  double ambient = 101325;  // outside [Pa]
  GasLaw law = GasLaw::Isothermal;
  bool operator==(const Pressure&) const = default;
};

/// A block of cells along x, y and z, centred on the origin, each cut into five tetrahedra.
struct BlockShape {
  std::array<std::uint32_t, 3> cells{};
  Vec3d size;  // [m]
  bool operator==(const BlockShape&) const = default;
};

/// Which energy tetrahedra have (docs/bodies.md).
enum class SolidEnergy { NeoHookean, Corotated };

/// A body with volume: its tetrahedra, and what they resist with.
struct Solid {
  std::optional<BlockShape> block;  // either this
  std::string tetrahedra;           // or this: a path of a tetrahedral mesh; see mesh_path
  std::string surface;              // or this, a closed mesh, filled
  double cell = 0;                  // with tetrahedra from a lattice of such cubes, in the world [m]
  double young = 0, poisson = 0;    // [Pa], 1
  double damping = 0;               // delay of Kelvin and Voigt [s]
  SolidEnergy energy = SolidEnergy::NeoHookean;
  bool operator==(const Solid&) const = default;
};

/// A piece of a cloth that is made of several: a grid or a mesh.
struct Panel {
  std::optional<GridShape> grid;  // either this
  std::string mesh;               // or this, as of Cloth
  Transform transform;            // before the cloth's
  bool operator==(const Panel&) const = default;
};

/// A run of a panel's rim that is sewn on.
struct SeamRow {
  std::size_t panel = 0;  // 0: also a cloth without panels
  std::vector<Selector> nodes;
  bool operator==(const SeamRow&) const = default;
};

/// Two rows that threads pull together, after which they are one (docs/sewing.md).
struct Seam {
  std::string where;  // file and JSON path
  SeamRow first, second;
  bool reversed = false;           // the other way round than where they are nearer at the start
  double force = 0, speed = 0;     // of the threads, at most: by length of the seam [N/m]; [m/s]
  double within = 0;               // how near all its pairs are when they become one [m]
  double start = 0, patience = 0;  // when it is begun, and how long it is waited for [s]
  bool operator==(const Seam& other) const {
    return first == other.first && second == other.second && reversed == other.reversed &&
           force == other.force && speed == other.speed && within == other.within && start == other.start &&
           patience == other.patience;
  }
};

enum class Weave { Plain, Twill, Satin, Knit, None };
enum class Pattern { Plain, Check, Stripes };
/// How a cloth looks in View::Textured (docs/rendering.md, Cloth).
struct Look {
  std::string name =
      "woven";  // in the table of looks.hpp, before anything was changed; its numbers are those below
  Weave weave = Weave::Plain;
  Pattern pattern = Pattern::Check;
  double threads_per_cm = 0;          // 0: 150 over the sheet
  std::optional<Vec3d> warp;          // where the cloth has no colour; none: the renderer's
  std::optional<Vec3d> weft;          // none: as the warp
  std::optional<Vec3d> stripe;        // of checks and stripes; none: a darker warp
  double sheen = 0.35, gloss = 0.25;  // 0 to 1
  double translucency = 0.12;         // the part of what is not absorbed that goes through
  bool operator==(const Look&) const = default;
};

/// A cloth, or with `solid` a body with volume, whose surface meets things as a cloth does.
struct Cloth {
  std::string where;  // file and JSON path: "scenes/a.json: cloths[0]"
  std::string name;
  std::optional<Solid> solid;     // either this
  std::optional<GridShape> grid;  // or this
  std::string mesh;               // or this: the name of a model or a path; see mesh_path
  std::vector<Panel> panels;      // or these
  std::vector<Seam> seams;        // of these, or of its own rim
  Transform transform;
  std::optional<double> density;       // either this [kg/m²]; of a body [kg/m³]
  std::optional<double> node_mass;     // or this [kg]
  std::optional<Fabric> fabric;        // instead of springs
  Stiffness stiffness;                 // of springs
  double damping = 0.25;               // along each spring [N·s/m]
  double friction = 0.3;               // with cloth, and with colliders that give none
  std::optional<double> strain_limit;  // how far edges are stretched at most, of their length
  std::optional<Tethers> tethers;      // to what holds it; none: there are none
  std::optional<double> strength;      // what it bears before it tears [N/m]; none: it does not tear
  std::optional<Pressure> pressure;    // of the gas that it encloses; none: there is none
  std::vector<Selector> pins;
  std::vector<Motion> motions;
  std::vector<Attachment> attachments;
  std::vector<Grab> grabs;
  std::optional<Vec3d> color;  // red, green, blue in [0, 1]
  Look look;
  std::size_t entry = 0;   // in the scene's list of cloths, or of bodies
  std::uint32_t copy = 0;  // which of that entry's copies it is
};

/// How a whole collider moves; motion_at takes it from where the scene puts it to its place at a time.
using ColliderMotion = MotionShape;

/// A shape that a mesh collider has come to at a time: other positions of the same vertices.
struct ColliderKeyframe {
  double time = 0;   // [s]
  std::string mesh;  // the name of a model or a path; see mesh_path
  bool operator==(const ColliderKeyframe&) const = default;
};

/// How a mesh collider moves by an animation of its own file.
struct ColliderAnimation {
  std::string name;  // "": the first
  double start = 0;  // where in it time 0 is [s]
  double speed = 1;  // seconds of it in a second
  bool loop = true;  // else it stays at its end
  double rate = 60;  // shapes a second that it is taken as; straight between [1/s]
  bool operator==(const ColliderAnimation&) const = default;
};

/// Of a collider with a mass that cloth and gravity move (docs/rigid.md): one of density and mass is given.
struct Rigid {
  std::optional<double> density;  // [kg/m³]
  std::optional<double> mass;     // [kg]
  Vec3d velocity, spin;           // at the start [m/s], [rad/s]
  bool operator==(const Rigid&) const = default;
};

/// What a collider looks like it is made of.
enum class Material { Plaster, Marble, Metal };

// Each has its friction (none: the cloth's) and its motion (none: it stays), or else it may be rigid.
struct ColliderMesh {
  std::string where;  // file and JSON path
  std::string mesh;   // the name of a model or a path; see mesh_path
  Transform transform;
  std::vector<ColliderKeyframe> keyframes{};     // times rise; straight between, from `mesh` at time 0
  std::optional<ColliderAnimation> animation{};  // instead of keyframes
  std::optional<double> friction{};
  std::optional<ColliderMotion> motion{};
  Material material = Material::Plaster;
  bool operator==(const ColliderMesh& other) const {
    return mesh == other.mesh && transform == other.transform && keyframes == other.keyframes &&
           animation == other.animation && friction == other.friction && motion == other.motion &&
           material == other.material;
  }
};
struct ColliderSphere {
  Vec3d center;       // [m]
  double radius = 0;  // [m]
  std::optional<double> friction{};
  std::optional<ColliderMotion> motion{};
  std::optional<Rigid> rigid{};
  Material material = Material::Plaster;
  bool operator==(const ColliderSphere&) const = default;
};
/// Solid on the side away from `normal`.
struct ColliderPlane {
  Vec3d point;   // [m]
  Vec3d normal;  // unit
  std::optional<double> friction{};
  std::optional<ColliderMotion> motion{};
  Material material = Material::Plaster;
  bool operator==(const ColliderPlane&) const = default;
};
/// All points within `radius` of the line from `a` to `b`, which differ.
struct ColliderCapsule {
  Vec3d a, b;         // [m]
  double radius = 0;  // [m]
  std::optional<double> friction{};
  std::optional<ColliderMotion> motion{};
  std::optional<Rigid> rigid{};
  Material material = Material::Plaster;
  bool operator==(const ColliderCapsule&) const = default;
};
struct ColliderBox {
  Vec3d center, size;                        // [m]; full edge lengths along x, y, z before the rotation
  std::array<double, 4> rotate{0, 0, 0, 1};  // unit quaternion x, y, z, w; about the centre
  std::optional<double> friction{};
  std::optional<ColliderMotion> motion{};
  std::optional<Rigid> rigid{};
  Material material = Material::Plaster;
  bool operator==(const ColliderBox&) const = default;
};
/// The convex hull of a mesh's vertices, or of points: one of them is given.
struct ColliderConvex {
  std::string where;          // file and JSON path
  std::string mesh;           // as of ColliderMesh; empty where there are points
  std::vector<Vec3d> points;  // before the transform [m]
  Transform transform;
  std::optional<double> friction{};
  std::optional<ColliderMotion> motion{};
  std::optional<Rigid> rigid{};
  Material material = Material::Plaster;
  bool operator==(const ColliderConvex& other) const {
    return mesh == other.mesh && points == other.points && transform == other.transform &&
           friction == other.friction && motion == other.motion && rigid == other.rigid &&
           material == other.material;
  }
};
using Collider =
    std::variant<ColliderMesh, ColliderSphere, ColliderPlane, ColliderCapsule, ColliderBox, ColliderConvex>;

const std::optional<double>& friction_of(const Collider& collider);
const std::optional<ColliderMotion>& motion_of(const Collider& collider);
Material material_of(const Collider& collider);
void set_material(Collider& collider, Material material);
/// Null: no program moves it.
const MotionCarried* carried_of(const Collider& collider);
MotionCarried* carried_of(Collider& collider);
/// Null: it is an obstacle.
const Rigid* rigid_of(const Collider& collider);

/// The velocity that drag and `air` are relative to. Gusts are two waves that travel through it (wind.hpp).
struct Wind {
  Vec3d velocity;         // the mean [m/s]
  double gusts = 0;       // their strength, from 0 to 1 of the mean
  double wavelength = 1;  // of the gusts along the wind [m]
};

/// What pushes on every triangle of every cloth, as the wind relative to it does: docs/air.md. The coefficients are by
/// the area of one face and count what happens on both.
struct Air {
  double density = 1.225;  // [kg/m³]
  double pressure = 1.17;  // on a sheet across the flow
  double lift = 1.48;      // normal force by angle to the flow, where that is small [1/rad]
  double friction = 0.01;  // on a sheet along the flow
  bool operator==(const Air&) const = default;
};

struct Time {
  double frame = 1.0 / 60.0;              // simulated time of a frame [s]
  std::optional<std::uint32_t> substeps;  // none: the solver chooses
  std::uint32_t frames = 90;
};

enum class SolverKind {
  MassSpring,
  Multigrid,
  Xpbd,
  Pbd,
  Vbd,
  ProjectiveDynamics,
  Fem,
  Auto,  ///< the cheaper of the first two for this scene
};
enum class Forces { NodeCentric, SpringCentric, SpringBlocks };
struct Solver {
  SolverKind kind = SolverKind::Auto;
  Forces forces = Forces::NodeCentric;  // of MassSpring
  std::uint32_t iterations = 1;         // of methods that sweep or iterate: how often in a substep
  double residual =
      0.01;  // of Multigrid: what a substep leaves of its linear system's, by what it began with; of
             // Fem: of its equation's
};

enum class ContactMethod { None, Paper, Bvh, Proximity };
struct Contact {
  ContactMethod method = ContactMethod::Proximity;
  double thickness = 0.005;  // [m]
  // Of method proximity only.
  bool self = true;        // cloth meets cloth
  double restitution = 0;  // of the normal velocity, 0 to 1
};

using weft::Camera;
using weft::View;
enum class Environment { Studio, Sky };
struct Light {
  Environment environment = Environment::Studio;
  std::optional<Vec3d>
      direction;       // to the sun, or the studio's key light; none: from the camera's left, above
  double degrees = 3;  // the angle that it covers
};
struct Render {
  View view = View::Textured;
  std::uint32_t width = 1280, height = 720;  // [pixel]
  std::uint32_t subdivide = 0;               // how often each cell of the drawn cloth is halved; grids only
  Light light;                               // of View::Textured, and where the shadows of all views fall
};

struct Scene {
  std::string file;           // the name it was read under; mesh paths start at its folder
  std::uint64_t content = 0;  // content_hash of its JSON
  std::string title, description;
  Vec3d gravity{0, -9.81, 0};  // [m/s²]
  Vec3d external_force;        // uniform, beside gravity [N/kg]
  double drag = 0;             // a = -drag * (v - wind) [1/s]
  Wind wind;
  std::optional<Air> air;  // none: it does not push
  Time time;
  Solver solver;
  Contact contact;
  std::vector<Cloth> cloths;  // each copy by itself; behind them the bodies
  std::vector<Collider> colliders;
  std::optional<Camera> camera;  // none: the renderer frames the scene
  Render render;
};

/// Whether any collider of the scene is rigid.
bool has_rigid(const Scene& scene);

/// A point after scale, rotation and translation. Adds and multiplies only: the same bits everywhere.
Vec3d transformed(const Transform& transform, const Vec3d& point);

/// The rest positions of a grid in the world [m], row by row: node j * nx + i.
std::vector<Vec3d> grid_positions(const GridShape& grid, const Transform& transform);
/// Where its free nodes are at the start: the same, but for its bump, a hill of 16 s² (1-s)² 16 t² (1-t)²
/// times its height along the sheet's normal, s and t from 0 to 1 along the sides.
std::vector<Vec3d> grid_start_positions(const GridShape& grid, const Transform& transform);

/// "cloths[0]" or "bodies[0]": where a cloth or body is in its scene.
std::string path_of(const Cloth& cloth);

/// The JSON word for a value.
const char* name_of(GridPart part);
const char* name_of(Plane plane);
const char* name_of(SolverKind kind);
const char* name_of(Forces forces);
const char* name_of(ContactMethod method);
const char* name_of(View view);

}  // namespace weft::scene
