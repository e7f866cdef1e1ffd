// The JSON words of the enumerations of scene.hpp, in their order: for the table of keys, the reader,
// name_of.
#pragma once

namespace weft::scene {

inline constexpr const char* kGridPartNames[] = {"top_left", "top_right", "bottom_left", "bottom_right",
                                                 "top",      "bottom",    "left",        "right",
                                                 "corners",  "edges"};
inline constexpr const char* kPlaneNames[] = {"xy", "xz"};
inline constexpr const char* kSolverKindNames[] = {"mass_spring", "multigrid",           "xpbd", "pbd",
                                                   "vbd",         "projective_dynamics", "fem",  "auto"};
inline constexpr const char* kForcesNames[] = {"node_centric", "spring_centric", "spring_blocks"};
inline constexpr const char* kFabricEnergyNames[] = {"yarn", "green", "neo_hookean"};
inline constexpr const char* kRestAnglesNames[] = {"mesh", "flat"};
inline constexpr const char* kGasLawNames[] = {"isothermal", "constant"};
inline constexpr const char* kSolidEnergyNames[] = {"neo_hookean", "corotated"};
inline constexpr const char* kContactMethodNames[] = {"none", "paper", "bvh", "proximity"};
inline constexpr const char* kWeaveNames[] = {"plain", "twill", "satin", "knit", "none"};
inline constexpr const char* kPatternNames[] = {"plain", "check", "stripes"};
inline constexpr const char* kMaterialNames[] = {"plaster", "marble", "metal"};
inline constexpr const char* kEnvironmentNames[] = {"studio", "sky"};
inline constexpr const char* kViewNames[] = {"textured", "wireframe", "normals",
                                             "stretch",  "velocity",  "contacts"};

}  // namespace weft::scene
