// The multigrid solver on meshes in double: its matrices and cycle against Eigen, its step against explicit
// ones.
#include "convergence.hpp"
#include "eigen_blocks.hpp"
#include "mesh/irregular_meshes.hpp"
#include "reference/simulation.hpp"
#include "relative_error.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

std::string mesh_cloth(const std::string& pins, const std::string& stiffness, const std::string& more = "") {
  return more + R"("cloths": [{"mesh": "a.obj", "density": 0.15, "damping": 0.01, "stiffness": {)" +
         stiffness + R"(}, "pins": )" + pins + "}]";
}
const std::string kClips =
    R"([{"near": {"point": [-1, 0, -1], "radius": 0.05}}, {"near": {"point": [1, 0, -1], "radius": 0.05}}])";
const std::string kFirstNodes = R"([{"nodes": [0, 1, 2]}])";
const std::string kThin = R"("structural": 1500, "shear": 750, "bend": 20)";
const std::string kUsual = R"("structural": 5000, "shear": 2000, "bend": 500)";

/// The matrix of a step after the first, spring by spring from the mesh itself.
Matrix explicit_matrix(const Sheet& sheet, const StepStart& step, double he) {
  const auto& system = sheet.system;
  const std::size_t count = system.position.size();
  Entries entries;
  const auto fixed = [&](std::size_t node) { return system.inverse_mass[node] == 0; };
  for (std::size_t a = 0; a < count; ++a)
    if (!fixed(a)) {
      const double mass = sheet.mass(a) * (1 / (he * he) + system.drag / he);
      add_block(entries, a, a, mass * Eigen::Matrix3d::Identity());
    }
  for (const SpringLink& s : system.springs) {
    const Eigen::Vector3d span = eigen(led_span(step, s.node_a, s.node_b));
    const Eigen::Vector3d n = span.normalized();
    const double stretched = std::max(0.0, 1 - s.rest_length / span.norm());
    const Eigen::Matrix3d block = (s.stiffness * (1 - stretched) + s.damping / he) * n * n.transpose() +
                                  s.stiffness * stretched * Eigen::Matrix3d::Identity();
    if (!fixed(s.node_a)) add_block(entries, s.node_a, s.node_a, block);
    if (!fixed(s.node_b)) add_block(entries, s.node_b, s.node_b, block);
    if (fixed(s.node_a) || fixed(s.node_b)) continue;
    add_block(entries, s.node_a, s.node_b, -block);
    add_block(entries, s.node_b, s.node_a, -block);
  }
  return matrix_from(entries, count, count);
}

Matrix block_matrix(const MeshOperator& matrix) {
  Entries entries;
  for (std::size_t a = 0; a < matrix.size(); ++a) {
    add_block(entries, a, a, dense(matrix.blocks[a]));
    for (const Coupling& c : matrix.levels[0].rows.of(a))
      add_block(entries, a, c.node, dense(matrix.blocks[c.at.block]));
  }
  return matrix_from(entries, matrix.size(), matrix.size());
}

/// P, from the taps alone.
Matrix prolongation(const MeshOperator& fine) {
  Entries entries;
  for (std::size_t a = 0; a < fine.size(); ++a)
    for (const Share& tap : fine.coarser()->taps[a])
      add_block(entries, a, tap.index, static_cast<double>(tap.weight) * Eigen::Matrix3d::Identity());
  return matrix_from(entries, fine.size(), fine.coarser()->node_count);
}

Field random_field(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Field made(count);
  for (Vec3d& v : made) {
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
    v = {a, b, random.uniform(-1, 1)};
  }
  return made;
}

/// The largest eigenvalue of D⁻¹ A, by power iteration: from below.
double largest_eigenvalue(const MeshOperator& matrix) {
  const std::vector<Sym3> inverse = matrix.inverse_diagonal();
  Field x = random_field(matrix.size(), 3);
  double value = 0;
  for (int k = 0; k < 100; ++k) {
    Field y = matrix.apply(x);
    for (std::size_t a = 0; a < y.size(); ++a) y[a] = inverse[a] * y[a];
    const double size = norm(y);
    value = size / norm(x);
    for (std::size_t a = 0; a < y.size(); ++a) x[a] = y[a] / size;
  }
  return value;
}

struct Case {
  std::string name;
  mesh::TriangleMesh mesh;
  std::string pins, stiffness;
  double wrinkles;  // [m]
  double bound;     // of the mean factor
};

/// A sheet, tube or skin in its second step.
Sheet stepped(const Case& c) {
  Sheet sheet(mesh_cloth(c.pins, c.stiffness), {c.mesh});
  if (c.wrinkles > 0) sheet.wrinkle(2, c.wrinkles);
  sheet.stepper.advance({sheet.system, sheet.system.position, 1.0 / 480});
  return sheet;
}

/// Cycles until the system is solved, tells how fast, and compares with Eigen's solution.
void check_convergence(const Case& c) {
  CAPTURE(c.name);
  const Sheet stood = stepped(c);
  const MeshStep step = stood.linearise_mesh();
  const MeshHierarchy hierarchy(step.matrix, {}, stood.finest());
  const Convergence found = converge(hierarchy, step.residual);
  double eigenvalue = 0;
  for (const MeshOperator& level : hierarchy.levels())
    eigenvalue = std::max(eigenvalue, largest_eigenvalue(level));
  MESSAGE(c.name << ", wrinkles " << c.wrinkles << " m, " << step.place.size() << " nodes: " << found.mean
                 << " a cycle, at worst " << found.worst << ", at last " << found.last << ", eigenvalues to "
                 << eigenvalue);
  CHECK(found.mean < c.bound);
  CHECK(found.worst < 1);
  const Convergence ended =
      converge(MeshHierarchy(step.matrix, stood.bottom(), stood.finest()), step.residual);
  MESSAGE("to level " << stood.bottom().level << " of " << hierarchy.levels().size() << ", "
                      << stood.bottom().sweeps << " sweeps: " << ended.mean << " a cycle");
  CHECK(ended.mean < c.bound);
  CHECK(largest_eigenvalue(hierarchy.levels()[0]) <
        2 * (1 + 1e-9));  // each spring adds at most twice its own
  CHECK(eigenvalue < kSmoothHigh);
  if (step.place.size() > 2000 || found.mean > 0.7) return;  // a direct solution takes long
  Entries fixed;                                             // their rows are empty
  for (std::size_t a = 0; a < step.matrix.size(); ++a)
    if (step.fixed[a]) add_block(fixed, a, a, Eigen::Matrix3d::Identity());
  const std::size_t count = step.matrix.size();
  const Matrix matrix = explicit_matrix(stood, step, 2.0 / 3 / 480) + matrix_from(fixed, count, count);
  const Eigen::SimplicialLLT<Matrix> factors(matrix);
  const Eigen::VectorXd exact = factors.solve(eigen(step.residual));
  CHECK((eigen(found.solution) - exact).norm() < 1e-5 * exact.norm());
}

/// The matrix of a cloth's step as it begins, moved by up to `amount` [m] a side.
struct FabricStart {
  Model model;
  MassSpringSystem system;
  ImplicitStepper stepper;

  FabricStart(const std::string& fabric, const mesh::TriangleMesh& mesh, double step, double amount)
      : model(model_of(fabric, mesh)), system(elements_of(model)), stepper(model, step) {
    system.position = model.start_position;
    system.velocity.resize(model.vertex_count());
    for (std::size_t node = 0; node < model.vertex_count(); ++node)
      system.inverse_mass.push_back(model.inverse_mass(node));
    const Field moves = random_field(model.vertex_count(), 11);
    for (std::size_t node = 0; node < moves.size(); ++node)
      if (system.inverse_mass[node] > 0) system.position[node] += amount * moves[node];
  }

 private:
  static Model model_of(const std::string& fabric, const mesh::TriangleMesh& mesh) {
    const auto scene = scene::parse_scene(
        R"({"format": "weft-scene/1", "solver": {"kind": "multigrid"}, "cloths": [{"mesh": "a.obj",
            "density": 0.16, "fabric": )" +
            fabric + R"(, "pins": [{"nodes": [0, 1, 2]}]}]})",
        "test.json");
    REQUIRE_MESSAGE(scene, scene.error().message);
    auto made = build_model(*scene, {mesh});
    REQUIRE_MESSAGE(made, made.error().message);
    return std::move(*made);
  }
};
const std::string kWeakShear = R"({"warp": 2000, "shear": 28, "bending_warp": 6.6e-6})";

}  // namespace

TEST_CASE(
    "the matrix of a mesh's step is mass and springs, added up one by one, and coarse ones are Pᵀ A P") {
  for (const mesh::TriangleMesh& mesh : {shuffled(jittered_sheet(13, 17, 2, 2, 0.45)), tube(16, 9, 0.3, 1),
                                         both(jittered_sheet(7, 6, 1, 1), sphere_skin(5, 0.3), {0, 1, 0})}) {
    Sheet sheet(mesh_cloth(R"([{"nodes": [0, 40]}])", kUsual, R"("drag": 0.7, )"), {mesh});
    sheet.system.drag = 0.7;
    sheet.perturb(5, 0.05, 2);
    sheet.stepper.advance({sheet.system, sheet.system.position, 1.0 / 480});
    const MeshStep step = sheet.linearise_mesh();
    Matrix expected = explicit_matrix(sheet, step, 2.0 / 3 / 480);
    const MeshHierarchy hierarchy(step.matrix);
    REQUIRE(hierarchy.levels().size() > 2);
    for (std::size_t l = 0; l < hierarchy.levels().size(); ++l) {
      const MeshOperator& level = hierarchy.levels()[l];
      const Matrix found = block_matrix(level);
      CHECK((found - expected).norm() < 1e-6 * expected.norm());  // products of f32
      const Field x = random_field(level.size(), l);
      CHECK((eigen(level.apply(x)) - found * eigen(x)).norm() < 1e-12 * (found * eigen(x)).norm());
      if (!level.coarser()) continue;
      const Matrix p = prolongation(level);
      expected = Matrix(p.transpose() * expected * p);
      const Field coarse = random_field(level.coarser()->node_count, l);
      Eigen::VectorXd up = p * eigen(coarse);
      for (int a = 0; a < static_cast<int>(level.size()); ++a)
        if (level.fixed(static_cast<std::size_t>(a))) up.segment<3>(3 * a).setZero();
      CHECK((eigen(prolonged(coarse, level)) - up).norm() < 1e-13);
      Field masked = x;  // what is handed down is 0 where nodes are fixed
      for (std::size_t a = 0; a < masked.size(); ++a)
        if (level.fixed(a)) masked[a] = {};
      CHECK((eigen(restricted(masked, level)) - p.transpose() * eigen(masked)).norm() < 1e-13);
    }
  }
}

TEST_CASE("a mesh's residual at rest is minus the springs' energy's gradient, 0 where nodes are fixed") {
  Sheet sheet(mesh_cloth(kFirstNodes, kUsual), {jittered_sheet(7, 6, 1, 1)});
  sheet.system.acceleration = {};
  sheet.perturb(5, 0.03, 0);
  const MeshStep step = sheet.linearise_mesh();
  const std::vector<Vec3d> forces = spring_forces(sheet.system);
  double largest = 0;
  for (const Vec3d& f : forces) largest = std::max(largest, length(f));
  for (std::size_t a = 0; a < forces.size(); ++a) {
    const Vec3d expected = a < 3 ? Vec3d{} : forces[a];
    CHECK(length(step.residual[a] - expected) < 1e-12 * largest);
  }
}

TEST_CASE(
    "V-cycles on meshes solve the system that Eigen solves, and no eigenvalue is beyond what is smoothed") {
  const auto sheet = [](std::uint32_t n) { return jittered_sheet(n, n, 2, 2); };
  const Case cases[] = {
      {"17 x 17", sheet(17), kClips, kThin, 0, 0.2},
      {"33 x 33", sheet(33), kClips, kThin, 0, 0.2},
      {"65 x 65", sheet(65), kClips, kThin, 0, 0.3},
      {"129 x 129", sheet(129), kClips, kThin, 0, 0.4},
      {"17 x 17", sheet(17), kClips, kThin, 0.02, 0.3},
      {"33 x 33", sheet(33), kClips, kThin, 0.02, 0.25},
      {"65 x 65", sheet(65), kClips, kThin, 0.02, 0.5},
      {"129 x 129", sheet(129), kClips, kThin, 0.02, 0.5},
      {"65 x 65, 5000 N/m", sheet(65), kClips, kUsual, 0.02, 0.6},
      {"65 x 65, numbered at random", shuffled(sheet(65)), kClips, kThin, 0.02, 0.6},
      {"65 x 65, thin triangles", jittered_sheet(65, 65, 2, 2, 0.45), kClips, kThin, 0.02, 0.6},
      {"grid of 65 x 65, cut", jittered_sheet(65, 65, 2, 2, 0), kClips, kThin, 0.02, 0.5},
      {"tube of 80 x 50", tube(80, 50, 0.3, 1.2), kFirstNodes, kThin, 0, 0.5},
      {"sphere of 4,098", sphere_skin(32, 0.5), kFirstNodes, kThin, 0, 0.5},
      {"sphere of 16,386", sphere_skin(64, 0.5), kFirstNodes, kThin, 0, 0.65},
      {"sphere of rings, 80 triangles in each pole", rings(40, 0.5), kFirstNodes, kThin, 0, 0.9},
      {"strip of 100 x 3, 2 cm wide", jittered_sheet(100, 3, 2, 0.02), kFirstNodes, kThin, 0, 0.85},
      {"strip of 400 x 2, 5 mm wide", jittered_sheet(400, 2, 2, 0.005), kFirstNodes, kThin, 0, 0.95},
      {"two pieces", both(sheet(33), tube(24, 20, 0.2, 0.8), {0, 1, 0}), kFirstNodes, kThin, 0, 0.4},
      {"folded sheet", folded(jittered_sheet(41, 41, 2, 2, 0)), kFirstNodes, kThin, 0, 0.4},
      {"two triangles", jittered_sheet(2, 2, 2, 2), "[]", kThin, 0, 0.6},
      {"a triangle and a large sheet",
       both(sheet(33), {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, {3, 0, 0}), kFirstNodes, kThin, 0,
       0.4}};
  for (const Case& c : cases) check_convergence(c);
}

TEST_CASE(
    "long: V-cycles on meshes of 66,000 nodes converge as on small ones, and no eigenvalue is beyond what is "
    "smoothed") {
  check_convergence({"257 x 257", jittered_sheet(257, 257, 2, 2), kClips, kThin, 0, 0.4});
  check_convergence({"257 x 257", jittered_sheet(257, 257, 2, 2), kClips, kThin, 0.02, 0.55});
  check_convergence({"sphere of 65,538", sphere_skin(128, 0.5), kFirstNodes, kThin, 0, 0.7});
}

TEST_CASE("a mesh falls as with explicit steps, within 1.5 % after a quarter and half a second") {
  Sheet implicit(mesh_cloth(kClips, kThin), {jittered_sheet(33, 33, 2, 2)});
  MassSpringSystem exact = implicit.system;
  const std::vector<Vec3d> start = exact.position;
  constexpr int kSteps = 60 * 16;  // a quarter of a second; half of them differ by 0.05 %
  for (const int quarter : {1, 2}) {
    implicit.advance(1.0 / 480, 120);
    for (int step = 0; step < kSteps; ++step) advance(exact, 0.25 / kSteps);
    const double error = relative_error(implicit.system.position, exact.position, start);
    MESSAGE("after " << 0.25 * quarter << " s apart by " << 100 * error << " % of the way");
    CHECK(error < 0.015);
  }
}

TEST_CASE(
    "free meshes keep their momentum and fall as stones, with solved systems and as they are solved by "
    "default") {
  for (const mesh::TriangleMesh& mesh : {jittered_sheet(19, 14, 2, 1.5), tube(19, 14, 0.3, 1)}) {
    Sheet sheet(mesh_cloth("[]", kUsual), {mesh});
    sheet.perturb(3, 0.005, 1);
    double mass = 0;
    for (std::size_t n = 0; n < sheet.system.velocity.size(); ++n) mass += sheet.mass(n);
    const double fall = 9.81 * 24 / 480 * mass;  // what gravity gives in 24 steps [kg·m/s]
    // The part of it by which the momentum is off.
    const auto drift = [&](double residual) {
      sheet.stepper.wanted_residual = residual;
      Vec3d change{0, fall, 0};
      for (std::size_t n = 0; n < sheet.system.velocity.size(); ++n)
        change -= sheet.mass(n) * sheet.system.velocity[n];
      sheet.advance(1.0 / 480, 24);
      for (std::size_t n = 0; n < sheet.system.velocity.size(); ++n)
        change += sheet.mass(n) * sheet.system.velocity[n];
      return length(change) / fall;
    };
    CHECK(drift(1e-12) < 1e-8);
    const double by_default = drift(scene::Solver{}.residual);
    MESSAGE("as solved by default momentum drifts by " << by_default << " of the weight");
    CHECK(by_default < 1e-11);
  }
}

TEST_CASE("smoothing of the finest level is for all eigenvalues of fabric, however stiff against bending") {
  const std::string bending[] = {"1e-8", "6.6e-6", "1e-4", "1e-2"};
  for (const mesh::TriangleMesh& mesh :
       {jittered_sheet(15, 12, 0.4, 0.3), jittered_sheet(15, 12, 0.4, 0.3, 0.45), tube(24, 9, 0.1, 0.2)})
    for (const std::string& modulus : bending)
      for (const double amount : {0.0, 0.003}) {
        const FabricStart start(R"({"warp": 2000, "shear": 90, "bending_warp": )" + modulus + "}", mesh,
                                1.0 / 360, amount);
        const MeshStep step =
            start.stepper.linearise_mesh(start.system, start.system.position, 1.0 / 360, 0, 0);
        const double found = largest_eigenvalue(step.matrix),
                     high = multigrid::finest_smoothing(start.model, multigrid::CycleKind::Fabric, 1.0 / 360)
                                .high;
        MESSAGE("bending " << modulus << " N·m, moved by " << amount << " m: " << found << " of " << high);
        CHECK(found < high);
        CHECK(high <= kSmoothHigh * (1 + 1e-12));
        if (modulus == "1e-8") CHECK(high < 0.76 * kSmoothHigh);  // that of membranes
      }
}

TEST_CASE("cloth whose threads hardly stretch takes fewer iterations by four sweeps of the finest level") {
  const FabricStart start(kWeakShear, tube(84, 24, 0.2, 0.5), 1.0 / 360, 0);
  const MeshStep step = start.stepper.linearise_mesh(start.system, start.system.position, 1.0 / 360, 1, 0);
  const auto iterations = [&](const Smoothing& finest) {
    const Solution solution = solve(MeshHierarchy(step.matrix, {}, finest), step.residual, step.guess, 200,
                                    {}, [](const Solution& begun) { return 1e-8 * begun.first; });
    const Field left = residual(step.matrix, step.residual, solution.x);
    CHECK(norm(left) < 1e-6 * norm(step.residual));
    return solution.iterations;
  };
  const std::uint32_t two = iterations({}), four = iterations(multigrid::finest_smoothing(
                                                start.model, multigrid::CycleKind::Fabric, 1.0 / 360));
  MESSAGE(four << " iterations instead of " << two);
  CHECK(4 * four < 3 * two);
}
