#include "cloths.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/json.hpp"
#include "base/words.hpp"
#include "common.hpp"
#include "method/mass_spring/plan.hpp"
#include "model/seams.hpp"
#include "model/sheet_moduli.hpp"
#include "model/tethers.hpp"
#include "scene/names.hpp"

namespace weft::cli {
namespace {

constexpr double kMicro = 1e6, kMilli = 1e3;

[[gnu::format(printf, 2, 3)]] void add(std::string& text, const char* format, ...) {
  char buffer[512];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  text += buffer;
}

/// "cloths[0]", and what kind of sheet it is.
std::string heading(const scene::Cloth& cloth) {
  std::string text = "  " + scene::path_of(cloth);
  if (!cloth.name.empty()) text += " " + in_quotes(cloth.name);
  if (cloth.solid) return text;
  if (!cloth.fabric) return text + ", of springs";
  return text + (cloth.fabric->name.empty() ? ", of fabric" : ", of fabric " + cloth.fabric->name);
}

/// "1240 tetrahedra of 0.2 litres in all, neo-Hookean, Young's modulus 1e+05 Pa, ..."
void add_solid(std::string& text, const scene::Cloth& cloth, const Model& model, const Body& body) {
  double mass = 0;
  for (std::uint32_t v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v)
    mass += model.mass[v];
  add(text,
      "%zu tetrahedr%s, %s, %.4g litres and %.4g kg; Young's modulus %.4g Pa, Poisson's ratio %.3g; friction "
      "%.3g\n",
      body.tets.size(), body.tets.size() == 1 ? "on" : "a",
      cloth.solid->energy == scene::SolidEnergy::Corotated ? "corotated" : "neo-Hookean",
      1e3 * mass / *cloth.density, mass, cloth.solid->young, cloth.solid->poisson, cloth.friction);
}

/// "2017 N/m along i and 408 across, ..." Springs of a mesh have no axes.
void add_moduli(std::string& text, const scene::Cloth& cloth, const SheetModuli& moduli) {
  const Moduli &stretch = moduli.stretch, &bending = moduli.bending;
  const bool springs = !cloth.fabric;
  if (springs && !cloth.grid) {
    add(text, "at most %.4g N/m in the mean over directions", stretch.warp);
  } else {
    add(text, "%.4g N/m along %s and %.4g along %s", stretch.warp, cloth.grid ? "i" : "the warp",
        stretch.weft, cloth.grid ? "j" : "the weft");
  }
  add(text, ", Poisson's ratio %.3g, shear %.4g N/m; bending ", stretch.poisson, stretch.shear);
  if (bending.warp == 0 && bending.weft == 0) {
    add(text, "0 for slight folds");
  } else {
    add(text, "%.4g and %.4g µN·m, twist %.4g", kMicro * bending.warp, kMicro * bending.weft,
        kMicro * bending.shear);
  }
  if (cloth.density) add(text, "; %.4g g/m²", kMilli * *cloth.density);
  add(text, "; friction %.3g\n", cloth.friction);
}

const char* name_of(const StepCause::Part& part) {
  return part.kind ? kElementNames[static_cast<std::size_t>(*part.kind)] : "gas";
}

/// "encloses 113.1 litres at a gauge pressure of 500 Pa, of an ideal gas in 1.013e+05 Pa outside"
void add_gas(std::string& text, const scene::Cloth& cloth, const Body& body) {
  const scene::Pressure& pressure = *cloth.pressure;
  add(text, "    encloses %.4g litres at a gauge pressure of %.4g Pa", 1e3 * body.gas->rest_volume,
      pressure.gauge);
  if (pressure.law == scene::GasLaw::Constant)
    text += ", at any volume\n";
  else
    add(text, ", of an ideal gas in %.4g Pa outside\n", pressure.ambient);
}

/// "keeps of a bend what is beyond a curvature of 50 1/m, a radius of 20 mm; hardening 0.3"
void add_plastic(std::string& text, const scene::Plastic& plastic) {
  add(text,
      "    keeps of a bend what is beyond a curvature of %.4g 1/m, a radius of %.4g mm; hardening %.3g\n",
      plastic.yield_curvature, kMilli / plastic.yield_curvature, plastic.hardening);
}

/// "990 tethers to held nodes, at most 2.04 m long"
void add_tethers(std::string& text, const TetherRows& rows, const Body& body) {
  const std::uint32_t first = rows.starts[body.first_vertex],
                      end = rows.starts[body.first_vertex + body.vertex_count];
  double longest = 0;
  for (std::uint32_t k = first; k < end; ++k) longest = std::max(longest, rows.tethers[k].length);
  add(text, "    %s to held nodes, at most %.4g m long\n", counted(end - first, "tether", "tethers").c_str(),
      longest);
}

void add_step(std::string& text, const scene::Scene& scene, const Model& model, const Body& body) {
  const StepCause cause = step_cause(model, body, scene.drag);
  if (cause.parts.empty()) {
    add(text, "    any explicit step is stable: nothing resists\n");
    return;
  }
  add(text, "    explicit steps are stable up to %.4g ms, because of %s", kMilli * cause.largest_step,
      name_of(cause.parts[0]));
  for (std::size_t k = 1; k < cause.parts.size(); ++k)
    add(text, " (%s alone: %.4g ms)", name_of(cause.parts[k]), kMilli * cause.parts[k].largest_step);
  add(text, "; the least height of a triangle is %.4g mm", kMilli * least_height(model, body));
  if (body.fabric) {
    const auto& facets = model.plate(body).facets;
    const auto slivers =
        std::count_if(facets.begin(), facets.end(), [](const hinge::Facet& facet) { return facet.sliver; });
    add(text, "; %s", counted(static_cast<std::uint64_t>(slivers), "sliver", "slivers").c_str());
  }
  text += '\n';
}

}  // namespace

std::string cloths_text(const scene::Scene& scene, const Model& model) {
  std::string text;
  const TetherRows tethers = tethers_of(model);
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    const scene::Cloth& cloth = scene.cloths[c];
    if (cloth.copy > 0) continue;
    text += heading(cloth) + ": ";
    if (cloth.solid)
      add_solid(text, cloth, model, model.bodies[c]);
    else
      add_moduli(text, cloth, sheet_moduli(model, model.bodies[c]));
    if (cloth.fabric && cloth.fabric->plastic) add_plastic(text, *cloth.fabric->plastic);
    if (cloth.tethers) add_tethers(text, tethers, model.bodies[c]);
    if (cloth.strength) add(text, "    tears where it bears more than %.4g N/m\n", *cloth.strength);
    if (const auto& pattern = model.bodies[c].pattern)
      add(text, "    %zu pairs of nodes are sewn together, in %zu seams\n", pair_count(*pattern),
          cloth.seams.size());
    if (cloth.pressure) add_gas(text, cloth, model.bodies[c]);
    add_step(text, scene, model, model.bodies[c]);
  }
  return text;
}

std::string stiffening_text(const scene::Scene& scene, const Model& model, const Method& method,
                            std::uint32_t substeps) {
  std::string text;
  if (method.stiffening == nullptr) return text;
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    const scene::Cloth& cloth = scene.cloths[c];
    if (cloth.copy > 0) continue;
    const StiffeningRange times =
        method.stiffening(scene.solver, model, model.bodies[c], scene.time.frame / substeps);
    if (times.most == 0) continue;  // nothing resists
    add(text,
        "  By \"%s\" in %s of %s, an element of %s that nothing else pulls at resists with %.3g to %.3g "
        "times "
        "its stiffness.\n",
        scene::name_of(method.kind), counted(substeps, "substep", "substeps").c_str(),
        counted(scene.solver.iterations, "sweep", "sweeps").c_str(), scene::path_of(cloth).c_str(),
        times.least, times.most);
  }
  return text;
}

std::string creeping_text(const scene::Scene& scene, const Method& method) {
  std::string text;
  for (const scene::Cloth& cloth : scene.cloths)
    if (cloth.copy == 0 && cloth.solid && cloth.solid->poisson > method.even_poisson)
      add(text,
          "  By \"%s\" a slender body of Poisson's ratio %.3g, as %s has, may creep for many seconds; one of "
          "%.2g "
          "does not.\n",
          scene::name_of(method.kind), cloth.solid->poisson, scene::path_of(cloth).c_str(),
          method.even_poisson);
  return text;
}

nlohmann::ordered_json cloths_json(const scene::Scene& scene, const Model& model) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    const scene::Cloth& cloth = scene.cloths[c];
    if (cloth.copy > 0) continue;
    nlohmann::ordered_json one;
    if (!cloth.name.empty()) one["name"] = cloth.name;
    if (cloth.solid) {
      one["of"] = "tetrahedra";
      one["tetrahedra"] = model.bodies[c].tets.size();
      one["density"] = *cloth.density;
      one["young"] = cloth.solid->young;
      one["poisson"] = cloth.solid->poisson;
      one["friction"] = cloth.friction;
      list.push_back(std::move(one));
      continue;
    }
    const auto [stretch, bending] = sheet_moduli(model, model.bodies[c]);
    if (cloth.fabric && !cloth.fabric->name.empty()) one["fabric"] = cloth.fabric->name;
    one["of"] = cloth.fabric ? "fabric" : "springs";
    if (cloth.density) one["density"] = *cloth.density;
    one["warp"] = stretch.warp;
    one["weft"] = stretch.weft;
    one["poisson"] = stretch.poisson;
    one["shear"] = stretch.shear;
    one["bending_warp"] = bending.warp;
    one["bending_weft"] = bending.weft;
    one["bending_twist"] = bending.shear;
    one["friction"] = cloth.friction;
    if (cloth.fabric && cloth.fabric->plastic) {
      one["yield_curvature"] = cloth.fabric->plastic->yield_curvature;
      one["hardening"] = cloth.fabric->plastic->hardening;
    }
    if (cloth.strength) one["strength"] = *cloth.strength;
    if (const auto& pattern = model.bodies[c].pattern) one["sewn_pairs"] = pair_count(*pattern);
    if (cloth.pressure) {
      one["gauge"] = cloth.pressure->gauge;
      one["ambient"] = cloth.pressure->ambient;
      one["law"] = scene::kGasLawNames[static_cast<std::size_t>(cloth.pressure->law)];
      one["volume"] = model.bodies[c].gas->rest_volume;
    }
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace weft::cli
