// The linear system of the multigrid solver and its V-cycle, against Eigen's direct solution.
#include <Eigen/Eigenvalues>

#include "convergence.hpp"
#include "eigen_blocks.hpp"
#include "sheets.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

/// The matrix of a step, spring by spring from the sheet itself: mass, springs as they are stretched,
/// bending. `galerkin`: what coarser levels are made of instead, bend springs as structural ones, and of
/// bending only what names a fixed node, taken apart where that is the middle one.
Matrix explicit_matrix(const Sheet& sheet, const StepStart& step, double he, bool galerkin) {
  const auto& system = sheet.system;
  const mesh::Grid grid = *sheet.model.bodies[0].grid;
  const std::size_t count = system.position.size();
  Entries entries;
  const auto fixed = [&](std::size_t node) { return system.inverse_mass[node] == 0; };
  const auto add_line = [&](const std::vector<std::pair<std::size_t, double>>& line,
                            const Eigen::Matrix3d& block) {
    for (const auto& [a, wa] : line)
      for (const auto& [b, wb] : line)
        if (!fixed(a) && !fixed(b)) add_block(entries, a, b, wa * wb * block);
  };
  for (std::size_t a = 0; a < count; ++a)
    if (!fixed(a)) {
      const double mass = sheet.mass(a) * (1 / (he * he) + system.drag / he);
      add_block(entries, a, a, mass * Eigen::Matrix3d::Identity());
    }
  const auto spring = [&](std::size_t a, std::size_t b, double l0, double k, double c) {
    const Eigen::Vector3d span = eigen(led_span(step, a, b));
    const Eigen::Vector3d n = span.normalized();
    // With contact what presses resists across as what pulls does, by its force in the residual: equation (6a).
    const double length = span.norm(), now = length - l0,
                 then = now + n.dot(eigen(step.start[b] - step.start[a]));
    const bool presses = !step.leads && (now < 0 || then < 0);
    const double stretched =
        presses ? std::min(1.0, std::abs(then) / length) : std::max(0.0, 1 - l0 / length);
    add_line({{a, -1.0}, {b, 1.0}}, (k * (1 - stretched) + c / he) * n * n.transpose() +
                                        k * stretched * Eigen::Matrix3d::Identity());
  };
  for (const SpringLink& s : system.springs) {
    const std::size_t apart = s.node_b - s.node_a;
    const bool far = apart == 2 || apart == 2 * std::size_t{grid.nx};
    if (!far || !galerkin) {
      spring(s.node_a, s.node_b, s.rest_length, s.stiffness, s.damping);
    } else {
      const std::size_t middle = s.node_a + apart / 2;
      spring(s.node_a, middle, s.rest_length / 2, 2 * s.stiffness, 2 * s.damping);
      spring(middle, s.node_b, s.rest_length / 2, 2 * s.stiffness, 2 * s.damping);
    }
  }
  const double b = sheet.model.bodies[0].stiffness.bending;
  const double di = grid.width / (grid.nx - 1), dj = grid.height / (grid.ny - 1);
  const auto bend = [&](std::size_t a, std::size_t m, std::size_t c, double stiffness) {
    const Eigen::Matrix3d block = stiffness * Eigen::Matrix3d::Identity();
    if (galerkin && !fixed(a) && !fixed(m) && !fixed(c)) return;
    if (galerkin && fixed(m)) {
      add_line({{a, 1}}, (fixed(c) ? 1 : 2) * block);
      add_line({{c, 1}}, (fixed(a) ? 1 : 2) * block);
    } else {
      add_line({{a, 1}, {m, -2}, {c, 1}}, block);
    }
  };
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const std::size_t a = j * grid.nx + i;
      const double row = j == 0 || j + 1 == grid.ny ? 0.5 : 1, column = i == 0 || i + 1 == grid.nx ? 0.5 : 1;
      if (i > 0 && i + 1 < grid.nx) bend(a - 1, a, a + 1, row * b * dj / (di * di * di));
      if (j > 0 && j + 1 < grid.ny) bend(a - grid.nx, a, a + grid.nx, column * b * di / (dj * dj * dj));
    }
  return matrix_from(entries, count, count);
}

/// The same numbers out of a GridOperator, without its bending.
Matrix stencil_matrix(const GridOperator& grid) {
  Entries entries;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const std::uint32_t a = j * grid.nx + i;
      if (grid.fixed[a]) continue;
      const int di[] = {0, 1, 0, 1, -1}, dj[] = {0, 0, 1, 1, 1};
      for (int p = 0; p < 5; ++p) {
        const int ib = static_cast<int>(i) + di[p], jb = static_cast<int>(j) + dj[p];
        if (ib < 0 || ib >= static_cast<int>(grid.nx) || jb >= static_cast<int>(grid.ny)) continue;
        const auto b = static_cast<std::uint32_t>(jb) * grid.nx + static_cast<std::uint32_t>(ib);
        if (grid.fixed[b]) continue;
        add_block(entries, a, b, dense(grid.rows[a][static_cast<std::size_t>(p)]));
        if (p > 0) add_block(entries, b, a, dense(grid.rows[a][static_cast<std::size_t>(p)]));
      }
    }
  return matrix_from(entries, grid.size(), grid.size());
}

/// P of one level, bilinear by hand: the coarse nodes' places along a side, and hat functions between them.
Matrix prolongation(std::uint32_t nx, std::uint32_t ny, const std::vector<bool>& fixed) {
  const auto hat = [](std::uint32_t fine, std::uint32_t coarse, std::uint32_t n) {
    if (n <= 5) return fine == coarse ? 1.0 : 0.0;
    const double last = n - 1, at = fine;
    const auto place = [&](double c) { return std::min(2 * c, last); };
    const double mine = place(coarse);
    if (at == mine) return 1.0;
    if (at < mine) return coarse > 0 && at > place(coarse - 1.0) ? 0.5 : 0.0;
    return at < place(coarse + 1.0) ? 0.5 : 0.0;
  };
  const std::uint32_t cx = nx > 5 ? nx / 2 + 1 : nx, cy = ny > 5 ? ny / 2 + 1 : ny;
  Entries entries;
  for (std::uint32_t a = 0; a < nx * ny; ++a)
    for (std::uint32_t c = 0; c < cx * cy; ++c) {
      const double weight = hat(a % nx, c % cx, nx) * hat(a / nx, c / cx, ny);
      if (weight > 0 && !fixed[a]) add_block(entries, a, c, weight * Eigen::Matrix3d::Identity());
    }
  return matrix_from(entries, std::size_t{nx} * ny, std::size_t{cx} * cy);
}

double difference(const Matrix& a, const Matrix& b) { return (a - b).norm() / b.norm(); }

std::string any_sheet(std::uint32_t nx, std::uint32_t ny, const std::string& pins) {
  return R"("cloths": [{"grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) +
         R"(], "size": [2, 1.5], "plane": "xz", "density": 0.2, "damping": 0.25,
            "stiffness": {"structural": 5000, "shear": 2000, "bend": 500, "bending": 1e-3}, "pins": )" +
         pins + "}]";
}

}  // namespace

TEST_CASE("the matrix of a step is mass, springs and bending, added up one by one") {
  for (const auto& [nx, ny] : {std::pair{9U, 12U}, {2U, 2U}, {3U, 7U}, {17U, 4U}}) {
    CAPTURE(nx);
    Sheet sheet(any_sheet(nx, ny, R"(["top_left"])"));
    sheet.system.drag = 0.7;
    sheet.perturb(nx, 0.1, 2);
    const double he = 2.0 / 3 / 480;
    // No node has been stepped yet, so that mass is backward Euler's; damping goes by the step.
    sheet.stepper.advance({sheet.system, sheet.system.position, 1.0 / 480});
    const LinearStep second = sheet.linearise();
    const Matrix expected = explicit_matrix(sheet, second, he, false);
    Random random(3);
    Field x(second.matrix.size());
    for (std::size_t a = 0; a < x.size(); ++a)
      if (!second.matrix.fixed[a])
        x[a] = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const Eigen::VectorXd product = expected * eigen(x);
    CHECK((eigen(second.matrix.apply(x)) - product).norm() <
          1e-6 * product.norm());  // f32 stiffness and length
  }
}

TEST_CASE("coarse matrices are Pᵀ A P of mass and springs, for sides of any length") {
  for (const auto& [nx, ny] : {std::pair{17U, 17U}, {16U, 23U}, {11U, 6U}, {14U, 3U}, {9U, 2U}}) {
    CAPTURE(nx);
    CAPTURE(ny);
    Sheet sheet(any_sheet(nx, ny, R"(["top_left", {"nodes": [4, 12]}])"));
    sheet.perturb(ny, 0.05, 2);
    sheet.stepper.advance({sheet.system, sheet.system.position, 1.0 / 480});
    const LinearStep step = sheet.linearise();
    const Hierarchy hierarchy(step.matrix, step.source);
    Matrix expected = explicit_matrix(sheet, step, 2.0 / 3 / 480, true);
    CHECK(difference(stencil_matrix(step.source), expected) < 1e-6);
    REQUIRE(hierarchy.levels().size() > 1);
    for (std::size_t l = 1; l < hierarchy.levels().size(); ++l) {
      const GridOperator& fine = hierarchy.levels()[l - 1];
      const Matrix p = prolongation(fine.nx, fine.ny, fine.fixed);
      expected = Matrix(p.transpose() * expected * p);
      CHECK(difference(stencil_matrix(hierarchy.levels()[l]), expected) < 1e-6);
    }
  }
}

TEST_CASE("coarse matrices have what obstacles hold nodes with") {
  Sheet sheet(any_sheet(16, 23, R"(["top_left"])"));
  sheet.perturb(5, 0.05, 2);
  sheet.stepper.advance({sheet.system, sheet.system.position, 1.0 / 480});
  Random random(3);
  std::vector<Press> presses(16 * 23);
  Entries holds;
  for (std::uint32_t a = 1; a < presses.size(); a += 3) {  // ten metres to go; nothing sticks, or all does
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), weight = random.uniform(0.2, 2);
    const Vec3d n = Vec3d{x, y, 1} / length(Vec3d{x, y, 1});
    presses[a] = {.normal = weight * n,
                  .lack = 10 * weight,
                  .weight = weight,
                  .friction = a % 2 == 0 ? 0 : weight * 1e9};
    const double he = 2.0 / 3 / 480, inertia = std::min(weight, 1.0) * sheet.mass(a) / (he * he);
    const Eigen::Vector3d m(n.x, n.y, n.z);
    const Eigen::Matrix3d normal = m * m.transpose(), across = Eigen::Matrix3d::Identity() - normal;
    add_block(holds, a, a, inertia * (30 * normal + (a % 2 == 0 ? 0.0 : 1.0) * across));
  }
  sheet.stepper.set_hold_forces(std::vector<HoldForce>(presses.size(), {1, {}}));
  const LinearStep step =
      sheet.stepper.linearise(sheet.system, sheet.system.position, 1.0 / 480, 1, 0, presses);
  Matrix expected = explicit_matrix(sheet, step, 2.0 / 3 / 480, true) + matrix_from(holds, 16 * 23, 16 * 23);
  const Hierarchy hierarchy(step.matrix, step.source);
  CHECK(difference(stencil_matrix(step.source), expected) < 1e-6);
  for (std::size_t l = 1; l < hierarchy.levels().size(); ++l) {
    const GridOperator& fine = hierarchy.levels()[l - 1];
    const Matrix p = prolongation(fine.nx, fine.ny, fine.fixed);
    expected = Matrix(p.transpose() * expected * p);
    CHECK(difference(stencil_matrix(hierarchy.levels()[l]), expected) < 1e-6);
  }
}

TEST_CASE("cycles do not over-correct where bending is strong, whatever is pinned and however levels end") {
  // Of the cycle and the matrix the largest eigenvalue, by the power method in the inner product of the matrix.
  for (const auto& [nx, ny] : {std::pair{82U, 21U}, {81U, 17U}, {65U, 65U}})
    for (const std::uint32_t pinned : {0U, 1U, 2U, 4U}) {
      std::string nodes;
      for (std::uint32_t j = 0; j < ny; ++j)
        for (std::uint32_t i = 0; i < pinned; ++i)
          nodes += (nodes.empty() ? "" : ", ") + std::to_string(j * nx + i);
      Sheet strip(R"("cloths": [{"grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) +
                  R"(], "size": [0.5, )" + std::to_string(0.5 * (ny - 1) / (nx - 1)) +
                  R"(], "plane": "xz", "density": 0.2, "damping": 0.01,
                  "stiffness": {"structural": 2000, "shear": 500, "bend": 0, "bending": 0.05}, "pins": [)" +
                  (pinned > 0 ? R"({"nodes": [)" + nodes + "]}" : "") + "]}]");
      const LinearStep step = strip.linearise();
      for (const Bottom& bottom : {Bottom{}, strip.bottom()}) {
        const Hierarchy hierarchy(step.matrix, step.source, bottom);
        Random random(1);
        Field x(step.matrix.size());
        for (std::size_t a = 0; a < x.size(); ++a)
          if (!step.fixed[a]) x[a] = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        double largest = 0;
        for (int k = 0; k < 60; ++k) {
          const Field y = step.matrix.apply(x);
          const Field z = hierarchy.cycle(y);
          double square = 0, product = 0;
          for (std::size_t a = 0; a < x.size(); ++a) {
            square += dot(x[a], y[a]);
            product += dot(z[a], y[a]);
          }
          largest = product / square;
          const double size = norm(z);
          for (std::size_t a = 0; a < x.size(); ++a) x[a] = z[a] / size;
        }
        CAPTURE(nx);
        CAPTURE(pinned);
        CAPTURE(hierarchy.levels().size());
        CHECK(largest < 1.1);
        CHECK(largest > 0.9);
      }
    }
}

TEST_CASE("prolongation is bilinear, and restriction its transpose") {
  for (const auto& [nx, ny] : {std::pair{8U, 13U}, {5U, 9U}, {33U, 2U}}) {
    GridOperator fine;
    fine.nx = nx;
    fine.ny = ny;
    fine.rows.resize(std::size_t{nx} * ny);
    fine.fixed.assign(fine.rows.size(), false);
    fine.fixed[3] = true;
    const Matrix p = prolongation(nx, ny, fine.fixed);
    Random random(nx);
    Field coarse(std::size_t{coarser_side(nx)} * coarser_side(ny)), r(fine.size());
    for (Vec3d& v : coarse) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    for (Vec3d& v : r) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    CHECK((eigen(prolonged(coarse, fine)) - p * eigen(coarse)).norm() < 1e-14);
    CHECK((eigen(restricted(r, fine)) - p.transpose() * eigen(r)).norm() < 1e-14);
  }
}

TEST_CASE("the residual at rest is minus the energy's gradient, and its sum is the weight") {
  Sheet sheet(any_sheet(7, 9, "[]"));
  sheet.system.acceleration = {};
  sheet.perturb(5, 0.03, 0);
  const auto& springs = sheet.system.springs;
  const mesh::Grid grid = *sheet.model.bodies[0].grid;
  const auto [along_i, along_j] = bending_stiffness(sheet.model.bodies[0]);
  const auto energy = [&](const std::vector<Vec3d>& x) {
    double sum = 0;
    for (const SpringLink& s : springs)
      sum += 0.5 * s.stiffness * std::pow(length(x[s.node_b] - x[s.node_a]) - s.rest_length, 2);
    for (std::uint32_t j = 0; j < grid.ny; ++j)
      for (std::uint32_t i = 0; i < grid.nx; ++i) {
        const std::size_t a = j * grid.nx + i;
        const auto term = [&](std::size_t step, double k) {
          const Vec3d curve = x[a - step] - 2.0 * x[a] + x[a + step];
          sum += 0.5 * k * dot(curve, curve);
        };
        if (i > 0 && i + 1 < grid.nx) term(1, along_i * (j == 0 || j + 1 == grid.ny ? 0.5 : 1));
        if (j > 0 && j + 1 < grid.ny) term(grid.nx, along_j * (i == 0 || i + 1 == grid.nx ? 0.5 : 1));
      }
    return sum;
  };
  const LinearStep step = sheet.linearise();
  Vec3d total;
  double largest = 0;
  for (const Vec3d& r : step.residual) largest = std::max(largest, length(r));
  for (std::size_t a = 0; a < step.residual.size(); ++a) {
    total += step.residual[a];
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Vec3d> x = sheet.system.position;
      const double h = 1e-6;
      x[a][axis] += h;
      const double up = energy(x);
      x[a][axis] -= 2 * h;
      const double slope = (up - energy(x)) / (2 * h);
      CHECK(std::abs(step.residual[a][axis] + slope) < 1e-6 * largest);
    }
  }
  CHECK(length(total) < 1e-12 * largest);
}

TEST_CASE(
    "V-cycles solve the system that Eigen solves, flat sheets at 0.3 a cycle and wrinkled ones at 0.75") {
  struct Case {
    std::uint32_t nx, ny;
    double wrinkles;  // [m]
    double bound;
  };
  for (const Case& c : {Case{17, 17, 0, 0.3},
                        {65, 65, 0, 0.3},
                        {129, 129, 0, 0.3},
                        {100, 77, 0, 0.3},
                        {17, 17, 0.02, 0.75},
                        {33, 33, 0.02, 0.75},
                        {65, 65, 0.02, 0.75},
                        {129, 129, 0.02, 0.75},
                        {100, 77, 0.02, 0.75},
                        {128, 128, 0.02, 0.75}}) {
    Sheet sheet(thin_sheet(c.nx, c.ny));
    if (c.wrinkles > 0) sheet.wrinkle(2, c.wrinkles);
    sheet.stepper.advance({sheet.system, sheet.system.position, 1.0 / 480});
    const LinearStep step = sheet.linearise();
    const Bottom bottom = sheet.bottom();
    const Convergence found =
                          converge(Hierarchy(step.matrix, step.source, {}, sheet.finest()), step.residual),
                      ended = converge(Hierarchy(step.matrix, step.source, bottom, sheet.finest()),
                                       step.residual);
    MESSAGE(c.nx << " x " << c.ny << ", wrinkles " << c.wrinkles << " m: " << found.mean
                 << " a cycle, at worst " << found.worst << ", at last " << found.last << "; to level "
                 << bottom.level << ", " << bottom.sweeps << " sweeps: " << ended.mean);
    CHECK(found.mean < c.bound);
    CHECK(ended.mean < c.bound);
    if (c.nx > 70) continue;  // the direct solution of larger ones takes long
    Entries fixed;            // their rows are empty
    for (std::size_t a = 0; a < step.matrix.size(); ++a)
      if (step.matrix.fixed[a]) add_block(fixed, a, a, Eigen::Matrix3d::Identity());
    const Matrix matrix = explicit_matrix(sheet, step, 2.0 / 3 / 480, false) +
                          matrix_from(fixed, step.matrix.size(), step.matrix.size());
    const Eigen::SimplicialLLT<Matrix> factors(matrix);
    const Eigen::VectorXd exact = factors.solve(eigen(step.residual));
    CHECK((eigen(found.solution) - exact).norm() < 1e-5 * exact.norm());
  }
}

TEST_CASE(
    "cycles converge where stiffness jumps: obstacles 1000 times a node's inertia, shear a tenth of the "
    "threads") {
  for (const bool obstacles : {true, false}) {
    const std::string soft =
        R"("cloths": [{"grid": [65, 65], "size": [2, 2], "plane": "xz", "density": 0.15, "damping": 0,
        "stiffness": {"structural": 2000, "shear": 200, "bend": 0, "bending": 1e-5},
        "pins": ["top_left", "top_right"]}])";
    Sheet sheet(obstacles ? thin_sheet(65, 65) : soft);
    sheet.wrinkle(2, 0.02);
    sheet.stepper.advance({sheet.system, sheet.system.position, 1.0 / 480});
    LinearStep step = sheet.linearise();
    Random random(1);
    for (std::size_t a = 0; obstacles && a < step.matrix.size(); ++a) {
      const Vec3d way{random.uniform(-1, 1), 1, random.uniform(-1, 1)};
      // Two thirds of the upper part lie on something, and one of the lower.
      if (step.matrix.fixed[a] || random.below(3) < (a / 65 < 30 ? 1U : 2U)) continue;
      const Sym3 hold = Sym3::outer(way / length(way), 1000 * sheet.mass(a) * 2.25 * 480 * 480);
      step.matrix.rows[a][0] += hold;
      step.source.rows[a][0] += hold;
    }
    for (const Bottom& bottom : {Bottom{}, sheet.bottom()}) {
      const Convergence found =
          converge(Hierarchy(step.matrix, step.source, bottom, sheet.finest()), step.residual);
      MESSAGE(std::string(obstacles ? "obstacles: " : "shear: ")
              << found.mean << " a cycle, at worst " << found.worst << ", at last " << found.last);
      CHECK(found.mean < (obstacles ? 0.9 : 0.75));
      CHECK(found.worst < 1);
    }
  }
}

TEST_CASE(
    "where a cycle ends no part of the error is left to coarser levels, whatever the cloth's step and "
    "state") {
  // Eigen's least eigenvalue of D⁻¹ A there, and the part of an error that the sweeps leave.
  const std::string strip = R"("cloths": [{"grid": [161, 9], "size": [4, 0.2], "plane": "xz", "density": 0.2,
      "stiffness": {"structural": 900, "shear": 300, "bend": 4, "bending": 1e-4}}])";
  const std::string sheet = R"("cloths": [{"grid": [41, 37], "size": [1, 1], "plane": "xz", "density": 0.3,
      "damping": 0.02, "stiffness": {"structural": 450, "shear": 60, "bend": 2}, "pins": ["top_left"]}])";
  int ended = 0;
  for (const std::string& cloth : {strip, sheet})
    for (const double step : {1.0 / 240, 1.0 / 480, 1.0 / 1440})
      for (const double wrinkles : {0.0, 0.03}) {
        CAPTURE(step);
        CAPTURE(wrinkles);
        Sheet made(cloth);
        if (wrinkles > 0) made.wrinkle(1, wrinkles);
        const Bottom bottom = made.bottom(step);
        const LinearStep linear = made.linearise(step);
        const Hierarchy all(linear.matrix, linear.source), hierarchy(linear.matrix, linear.source, bottom);
        if (bottom.level + 1 == all.levels().size()) continue;
        ++ended;
        const GridOperator& level = hierarchy.levels().back();
        const std::vector<Sym3>& inverse = hierarchy.inverse_diagonals().back();
        std::vector<Eigen::Triplet<double>> blocks;
        for (std::size_t a = 0; a < level.size(); ++a) add_block(blocks, a, a, dense(inverse[a]));
        const Eigen::MatrixXd d(matrix_from(blocks, level.size(), level.size()));
        const Eigen::MatrixXd root = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(d).operatorSqrt();
        Eigen::MatrixXd a(d.rows(), d.cols());
        for (Eigen::Index column = 0; column < a.cols(); ++column) {
          Field unit(level.size());
          unit[static_cast<std::size_t>(column / 3)][static_cast<int>(column % 3)] = 1;
          a.col(column) = eigen(level.apply(unit));
        }
        const Eigen::VectorXd values =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(root * a * root, Eigen::EigenvaluesOnly)
                .eigenvalues();
        CHECK(values.minCoeff() > bottom.low);
        Field x(level.size());
        Random random(3);
        for (Vec3d& v : x) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        const Field task = level.apply(x);
        Field found(x.size());
        smooth(level, inverse, task, found, {bottom.sweeps, bottom.low, kSmoothHigh});
        for (std::size_t k = 0; k < x.size(); ++k) found[k] -= x[k];
        const Field left = level.apply(found);
        double before = 0, after = 0;
        for (std::size_t k = 0; k < x.size(); ++k) {
          before += dot(x[k], task[k]);
          after += dot(found[k], left[k]);
        }
        CHECK(std::sqrt(after / before) < 1 / multigrid::kBottomPart);
      }
  CHECK(ended > 4);
}
