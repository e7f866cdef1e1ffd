// Fabrics by name: measured numbers, each with its source. The whole table is here; scenes, their schema, `weft
// fabrics` and docs/fabrics.md read it.
#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>

#include "scene/scene.hpp"

namespace weft::scene {

struct FabricSource {
  const char* id;
  const char* citation;
};
inline constexpr FabricSource kFabricSources[] = {
    {"wang2011",
     "H. Wang, J. F. O'Brien, R. Ramamoorthi: Data-Driven Elastic Models for Cloth: Modeling and "
     "Measurement. ACM "
     "Transactions on Graphics 30(4) 71, 2011. Read in the material files of ARCSim 0.3.1 "
     "(github.com/kaist-silab/arcsim), what they mean in its code of stiffness and forces."},
    {"matsudaira2015",
     "M. Matsudaira, T. Masuda, M. Wada, H. Yokura: Shape Factor of Flared Skirts Compared with That of "
     "Circular "
     "Fabrics. Journal of Textile Engineering 61(6) 69-73, 2015, doi:10.4188/jte.61.69, tables 1 and 2. Read "
     "as a "
     "public program repeats them, not in the journal; its column of shear was not to be had."},
    {"ppf2025",
     "ppf-contact-solver (github.com/st-tech/ppf-contact-solver), calibration/cusick_drape/targets.csv: "
     "ranges by "
     "kind of cloth, collected from the literature of Cusick's test."},
    {"guess", "No measurement: a guess of the usual size, which is weft's own."},
};

/// A number and the id of its source.
struct Cited {
  double value = 0;
  const char* source = "guess";
};

/// What the literature has for Cusick's drape coefficient of this cloth, or of its kind [%].
struct DrapeRange {
  double least = 0, most = 0;
  const char* source = nullptr;  // null: nothing was found
};

struct NamedFabric {
  const char* name;
  const char* what;
  const char* published_as;
  Cited density;                                    // [kg/m²]
  Cited warp, weft, shear;                          // [N/m]
  Cited poisson;                                    // weft's contraction by warp's extension
  Cited bending_warp, bending_weft, bending_twist;  // [N·m]
  Cited friction;
  DrapeRange drape;
  const char* note;  // what was done to the numbers; "" where nothing needs to be said
};

/// Rows of a material file of ARCSim: the stiffness (c11, c12, c22, c33) [N/m] by axes weft (1) and warp (2), and the
/// resistance to bending (k0, k45, k90) at the least curvature [N·m].
struct WangRows {
  double density, c11, c12, c22, c33, k0, k45, k90;
};

/// By what ARCSim computes of them:
/// - It takes each c twice, and has the energy (c11 E11² + 2 c12 E11 E22 + c22 E22²) / 2 of Green's
///   strains: C = 2 c. Its forces of shear are those of 2 c33 E12² = c33 γ² / 2, with γ = 2 E12: the modulus is c33.
/// - The moduli of strips are C's inverse (docs/elements.md, eq. 2): E1 = C11 - C12² / C22, ν = C12 / C11 where axis 2
///   is pulled.
/// - An edge of length l between triangles of areas A0 and A1 has the energy k l² θ² / (8 (A0 + A1)). Rolled to a
///   curvature K across the edges of a strip of rectangles l x h, cut in two each, θ is K h, A0 + A1 is l h, and the
///   energy k K² / 8 for each l h: B = k / 4.
/// - k0 belongs to edges along axis 1, which bend what runs along axis 2.
/// - Of the six rows of a file, the first is of small strain in all directions; the others are of 17 % strain in five.
///   The first of them is taken whose C is positive definite, with c33 > 0 and c12 above -1 % of √(c11 c22): less is a
///   cloth that widens where it is pulled. Which one that is, where it is not the first, the note says.
/// - A strip at 45° has 4 / (1/B1 + 1/B2 + 1/D) (docs/elements.md, Moduli), which gives the twist's D.
constexpr NamedFabric of_wang(const char* name, const char* what, const char* published_as, const WangRows& r,
                              const DrapeRange& drape, const char* note) {
  constexpr const char* kFrom = "wang2011";
  const double twist = 1 / (4 / r.k45 - 1 / r.k0 - 1 / r.k90);
  return {name,
          what,
          published_as,
          {r.density, kFrom},
          {2 * (r.c22 - r.c12 * r.c12 / r.c11), kFrom},
          {2 * (r.c11 - r.c12 * r.c12 / r.c22), kFrom},
          {r.c33, kFrom},
          {r.c12 / r.c11, kFrom},
          {r.k0 / 4, kFrom},
          {r.k90 / 4, kFrom},
          {twist / 4, kFrom},
          {0.3, "guess"},
          drape,
          note};
}

/// Of Kawabata's instruments (KES): bending B [gf·cm²/cm] and weight [mg/cm²], one number for both directions.
/// 1 gf is 9.80665e-3 N, so 1 gf·cm²/cm is 9.80665e-5 N·m. What was not to be had is guessed: 2000 N/m along both
/// threads, half a gf/(cm·degree) in shear.
constexpr NamedFabric of_kawabata(const char* name, const char* what, const char* published_as,
                                  double bending, double weight, double drape) {
  constexpr const char* kFrom = "matsudaira2015";
  constexpr double kForce = 9.80665e-3, kDegree = 3.14159265358979323846 / 180;
  const double b = bending * kForce * 1e-2;
  return {name,
          what,
          published_as,
          {weight * 1e-2, kFrom},
          {2000, "guess"},
          {2000, "guess"},
          {0.5 * kForce / 1e-2 / kDegree, "guess"},
          {0, "guess"},
          {b, kFrom},
          {b, kFrom},
          {b / 2, "guess"},
          {0.3, "guess"},
          {drape, drape, kFrom},
          "One number for bending along warp and weft; stretch and shear are guessed."};
}

inline constexpr DrapeRange kNoDrape{};
inline constexpr NamedFabric kFabrics[] = {
    of_wang("denim_11oz", "jeans: 99 % cotton, 1 % spandex", "11oz-black-denim",
            {0.324, 205.352005, 10.234077, 1013.88629, 53.387184, 64.196457e-6, 73.384567e-6, 96.951576e-6},
            {70, 90, "ppf2025"}, ""),
    of_wang("ponte_roma", "jacket, a knit: 60 % polyester, 40 % rayon", "camel-ponte-roma",
            {0.284, 78.707756, 26.754574, 268.680725, 27.743423, 36.348366e-6, 33.013252e-6, 37.157593e-6},
            kNoDrape,
            "The stiffness of 17 % strain along the weft: that of small strain has c12 = -12.8 N/m, of a "
            "cloth that "
            "widens where it is pulled."),
    of_wang("interlock", "T-shirt, a knit: 60 % cotton, 40 % polyester", "gray-interlock",
            {0.187, 49.285110, 87.596100, 206.373993, 22.768457, 23.191698e-6, 24.749964e-6, 14.267624e-6},
            kNoDrape,
            "The stiffness of 17 % strain at 22.5° to the weft: that of small strain has c12 = -14.7 N/m, of "
            "a cloth "
            "that widens where it is pulled, that along the weft has c33 < 0."),
    of_wang("rib_knit", "underwear, a knit: 95 % cotton, 5 % spandex", "ivory-rib-knit",
            {0.276, 42.871021, -0.234556, 65.166023, 83.175644, 46.237591e-6, 30.015930e-6, 32.243889e-6},
            kNoDrape, ""),
    of_wang("sweater_knit", "sweater, a knit: 96 % polyester, 4 % spandex", "navy-sparkle-sweat",
            {0.224, 77.093796, 2.958664, 91.251160, 6.107700, 59.469658e-6, 40.072277e-6, 45.625023e-6},
            kNoDrape,
            "The stiffness of 17 % strain at 45° to the weft: those of small strain and at 22.5° are not "
            "positive "
            "definite, that along the weft has c33 < 0."),
    of_wang("blanket", "blanket: polyester", "pink-ribbon-brown",
            {0.228, 151.503906, 106.028160, 244.830673, 30.250183, 117.070122e-6, 87.509773e-6, 59.774277e-6},
            kNoDrape, ""),
    of_wang(
        "trousers", "trousers: 65 % cotton, 35 % polyester", "royal-target",
        {0.220, 2016.55456, 9.170511, 2034.97644, 104.759674, 125.409805e-6, 107.997696e-6, 125.409805e-6},
        kNoDrape,
        "c11 and c22 are within 1 % of those of tablecloth, of another cloth: maybe a bound of the published "
        "fit, and then the least that they can be."),
    of_wang("jacket", "jacket: polyester", "tango-red-jet-set",
            {0.113, 43.067627, 54.373299, 171.424835, 14.314700, 14.293814e-6, 21.951700e-6, 20.345654e-6},
            kNoDrape,
            "Contracts by 1.26 times its extension along the warp: C is positive definite, since the weft is "
            "so much "
            "softer."),
    of_wang("tablecloth", "tablecloth: polyester", "white-dots-on-blk",
            {0.128, 2002.08618, 0.345588, 2027.48559, 19.189022, 51.713814e-6, 40.659470e-6, 31.282822e-6},
            kNoDrape, "c11 and c22: see trousers."),
    of_wang("swimsuit", "swimsuit, a knit: 87 % nylon, 13 % spandex", "white-swim-solid",
            {0.204, 47.971176, 6.834521, 104.615456, 60.773663, 60.237942e-6, 58.803211e-6, 51.018833e-6},
            kNoDrape, ""),
    of_kawabata("cotton_broad", "plain weave: cotton", "A, Cotton Broad", 0.118, 12.38, 82.9),
    of_kawabata("wool_tropical", "plain weave: wool", "B, Wool Tropical", 0.067, 16.29, 49.8),
    of_kawabata("polyester_tropical", "polyester tropical", "C, Polyester Tropical", 0.077, 11.65, 50.7),
    of_kawabata("polyester_faille", "polyester faille", "F, Polyester Faille", 0.019, 10.43, 28.3),
};

/// Their names, in the same order.
inline constexpr auto kFabricNames = [] {
  std::array<const char*, std::size(kFabrics)> names{};
  for (std::size_t k = 0; k < names.size(); ++k) names[k] = kFabrics[k].name;
  return names;
}();

/// The fabric of this name; null: there is none.
const NamedFabric* find_fabric(std::string_view name);

/// Its moduli, with the defaults of what the table does not have.
Fabric moduli_of(const NamedFabric& fabric);

}  // namespace weft::scene
