#include "scene/format.hpp"

#include "scene/fabrics.hpp"
#include "scene/looks.hpp"
#include "scene/names.hpp"

namespace weft::scene {
namespace {

using Kind = Type::Kind;

constexpr double kFar = kMaxCoordinate;
constexpr double kSmall = 1e-6;         // m; below it f32 has no digits left beside a coordinate of 1 m
constexpr double kLate = 1e6;           // s; eleven days
constexpr double kMostNodes = 1 << 26;  // of all grids together, and of one node list

// Plain values.
constexpr Type kShortText{.kind = Kind::Text, .count_least = 1, .count_most = 200};
constexpr Type kLongText{.kind = Kind::Text, .count_most = 10000};
constexpr Type kMeshName{.kind = Kind::Text, .count_least = 1, .count_most = 1000};
constexpr Type kPoint{
    .kind = Kind::Numbers, .name = "point", .least = -kFar, .most = kFar, .unit = "m", .count_least = 3};
constexpr Type kDirection{.kind = Kind::Numbers,
                          .name = "direction",
                          .least = -kFar,
                          .most = kFar,
                          .count_least = 3,
                          .rule = Type::Rule::NonZero};
constexpr Type kAcceleration{
    .kind = Kind::Numbers, .least = -1e4, .most = 1e4, .unit = "m/s²", .count_least = 3};
constexpr Type kForcePerMass{
    .kind = Kind::Numbers, .least = -1e4, .most = 1e4, .unit = "N/kg", .count_least = 3};
constexpr Type kVelocity{.kind = Kind::Numbers, .least = -1e3, .most = 1e3, .unit = "m/s", .count_least = 3};
constexpr Type kRate{.kind = Kind::Number, .most = 1e4, .unit = "1/s"};
constexpr Type kInstant{.kind = Kind::Number, .most = kLate, .unit = "s"};
constexpr Type kLength{.kind = Kind::Number, .least = kSmall, .most = kFar, .unit = "m"};
constexpr Type kSpeed{.kind = Kind::Number, .least = 1e-9, .most = 1e4, .unit = "m/s"};
constexpr Type kTurnRate{.kind = Kind::Number, .least = 1e-9, .most = 1e4, .unit = "rad/s"};
constexpr Type kPart{.kind = Kind::Number, .most = 1};
constexpr Type kFriction{.kind = Kind::Number, .most = 100};
constexpr Type kTruth{.kind = Kind::Truth};
constexpr Type kAngle{.kind = Kind::Number, .least = 1e-9, .most = 1e6, .unit = "rad"};

// transform
constexpr Type kScale{.kind = Kind::Number, .least = 1e-6, .most = 1e6};
constexpr Type kQuaternion{
    .kind = Kind::Numbers, .least = -1.001, .most = 1.001, .count_least = 4, .rule = Type::Rule::Unit};
constexpr Key kTransformKeys[] = {
    {"scale", &kScale, "Factor on all lengths; applied first", "1"},
    {"rotate", &kQuaternion, "Unit quaternion [x, y, z, w] (length within 0.001 of 1); applied second",
     "[0, 0, 0, 1]"},
    {"translate", &kPoint, "Shift; applied last", "[0, 0, 0]"},
};
constexpr Type kTransform{.kind = Kind::Object, .name = "transform", .keys = kTransformKeys};

// wind
constexpr Key kWindKeys[] = {
    {"velocity", &kVelocity, "The mean", "[0, 0, 0]"},
    {"gusts", &kPart, "Strength of the gusts, as a part of the mean", "0"},
    {"wavelength", &kLength, "Length of the gusts along the wind", "1"},
};
constexpr Type kWind{.kind = Kind::Object, .keys = kWindKeys};

// air
constexpr Type kAirDensity{.kind = Kind::Number, .most = 1e4, .unit = "kg/m³"};
constexpr Type kCoefficient{.kind = Kind::Number, .most = 100};
constexpr Key kAirKeys[] = {
    {"density", &kAirDensity, "Density of the air", "1.225"},
    {"pressure", &kCoefficient, "Pressure on a sheet across the flow, by the dynamic pressure", "1.17"},
    {"lift", &kCoefficient, "Normal force on a sheet by its small angle to the flow", "1.48"},
    {"friction", &kCoefficient, "Friction on both faces of a sheet along the flow", "0.01"},
};
constexpr Type kAir{.kind = Kind::Object, .keys = kAirKeys};

// time
constexpr Type kFrame{.kind = Kind::Number, .least = 1e-6, .most = 10, .unit = "s"};
constexpr Type kSubstepCount{.kind = Kind::Number, .least = 1, .most = 65536, .whole = true};
constexpr const char* kAuto[] = {"auto"};
constexpr Type kAutoWord{.kind = Kind::Choice, .choices = kAuto};
constexpr const Type* kSubstepTypes[] = {&kSubstepCount, &kAutoWord};
constexpr Type kSubsteps{.kind = Kind::Either, .types = kSubstepTypes};
constexpr Type kFrames{.kind = Kind::Number, .least = 1, .most = 1e7, .whole = true};
constexpr Key kTimeKeys[] = {
    {"frame", &kFrame, "Simulated time of one frame (1/60 s)", "0.016666666666666666"},
    {"substeps", &kSubsteps, "Steps in a frame; \"auto\" asks the solver how many are stable", "\"auto\""},
    {"frames", &kFrames, "Frames of a run", "90"},
};
constexpr Type kTime{.kind = Kind::Object, .keys = kTimeKeys};

// solver
constexpr Type kSolverKind{.kind = Kind::Choice, .choices = kSolverKindNames};
constexpr Type kForces{.kind = Kind::Choice, .choices = kForcesNames};
constexpr Key kSolverKeys[] = {{"kind", &kSolverKind, "The method", "\"auto\""}};
constexpr Key kForcesKey = {"forces", &kForces,
                            "Gather over each node's springs, or scatter from each spring by atomic adds",
                            "\"node_centric\""};
constexpr Key kMassSpringKeys[] = {kForcesKey};
constexpr Type kIterations{.kind = Kind::Number, .least = 1, .most = 1000, .whole = true};
constexpr Key kXpbdKeys[] = {
    {"iterations", &kIterations,
     "Sweeps over all elements in a substep; more substeps do more for the same work", "1"},
};
constexpr Key kPbdKeys[] = {
    {"iterations", &kIterations, "Sweeps over all elements in a substep; more make cloth stiffer", "10"}};
constexpr Key kVbdKeys[] = {{"iterations", &kIterations, "Sweeps over all nodes in a substep", "10"}};
constexpr Key kProjectiveDynamicsKeys[] = {
    {"iterations", &kIterations, "Iterations over all nodes in a substep", "20"}};
constexpr Type kResidual{.kind = Kind::Number, .least = 1e-5, .most = 0.5};
constexpr Key kResidualKey = {
    "residual", &kResidual, "What a substep may leave of its linear system's residual, by what it began with",
    "0.01"};
constexpr Key kMultigridKeys[] = {kResidualKey};
constexpr Type kNewtonSteps{.kind = Kind::Number, .least = 1, .most = 50, .whole = true};
constexpr Key kFemKeys[] = {
    {"iterations", &kNewtonSteps, "Newton steps in a substep at most", "4"},
    {"residual", &kResidual, "What a substep may leave of its equation's residual, by what it began with",
     "0.01"}};
constexpr Key kAutoKeys[] = {kForcesKey, kResidualKey};  // of whichever it takes
constexpr Variant kSolverVariants[] = {                  // in the order of SolverKind
    {kSolverKindNames[0], kMassSpringKeys}, {kSolverKindNames[1], kMultigridKeys},
    {kSolverKindNames[2], kXpbdKeys},       {kSolverKindNames[3], kPbdKeys},
    {kSolverKindNames[4], kVbdKeys},        {kSolverKindNames[5], kProjectiveDynamicsKeys},
    {kSolverKindNames[6], kFemKeys},        {kSolverKindNames[7], kAutoKeys}};
static_assert(std::size(kSolverVariants) == std::size(kSolverKindNames));
constexpr Type kSolver{.kind = Kind::Object, .keys = kSolverKeys, .variants = kSolverVariants};

// contact
constexpr Type kContactMethod{.kind = Kind::Choice, .choices = kContactMethodNames};
constexpr Type kThickness{.kind = Kind::Number, .most = 10, .unit = "m"};
constexpr Key kContactKeys[] = {
    {"method", &kContactMethod,
     "How cloth meets colliders: not at all, all pairs, pairs from a tree, or before surfaces meet, cloth "
     "too",
     "\"proximity\""},
    {"thickness", &kThickness, "Distance that contact keeps from a surface; above 0 for proximity", "0.005"},
    {"self", &kTruth, "Whether cloth meets cloth; only proximity uses it", "true"},
    {"restitution", &kPart, "Part of the normal velocity that comes back; only proximity uses it", "0"},
};
constexpr Type kContact{.kind = Kind::Object, .keys = kContactKeys};

// selectors
constexpr Type kGridPart{.kind = Kind::Choice, .choices = kGridPartNames};
constexpr Key kBoxKeys[] = {
    {"min", &kPoint, "Least corner", nullptr, true},
    {"max", &kPoint, "Greatest corner, nowhere below min", nullptr, true},
};
constexpr Type kBox{.kind = Kind::Object, .keys = kBoxKeys};
constexpr Type kNodeIndex{.kind = Kind::Number, .most = kMostNodes - 1, .whole = true};
constexpr const Type* kNodeIndexTypes[] = {&kNodeIndex};
constexpr Type kNodeList{
    .kind = Kind::List, .count_least = 1, .count_most = 1 << 20, .types = kNodeIndexTypes};
constexpr Key kNearKeys[] = {
    {"point", &kPoint, "Centre", nullptr, true},
    {"radius", &kLength, "Greatest distance from it", nullptr, true},
};
constexpr Type kNear{.kind = Kind::Object, .keys = kNearKeys};
constexpr Key kSelectorKeys[] = {
    {"box", &kBox, "Nodes whose rest position in the world lies in the box"},
    {"nodes", &kNodeList, "Nodes by index: j * nx + i on a grid, the file's order on a mesh"},
    {"near", &kNear, "Nodes whose rest position in the world is near a point"},
};
constexpr const char* kSelectorWays[] = {"box", "nodes", "near"};
constexpr OneOf kSelectorOneOf[] = {{kSelectorWays}};
constexpr Type kSelectorObject{.kind = Kind::Object, .keys = kSelectorKeys, .one_of = kSelectorOneOf};
constexpr const Type* kSelectorTypes[] = {&kGridPart, &kSelectorObject};
constexpr Type kSelector{.kind = Kind::Either, .name = "selector", .types = kSelectorTypes};
constexpr const Type* kSelectorItem[] = {&kSelector};
constexpr Type kPinList{.kind = Kind::List, .count_most = 1000, .types = kSelectorItem};
constexpr Type kSelectorList{
    .kind = Kind::List, .count_least = 1, .count_most = 1000, .types = kSelectorItem};
constexpr const Type* kSelectorOrList[] = {&kGridPart, &kSelectorObject, &kSelectorList};
constexpr Type kSelectors{.kind = Kind::Either, .types = kSelectorOrList};

// motions
constexpr const char* kMotionKindNames[] = {"line", "path", "rotation", "given"};
constexpr Type kMotionKind{.kind = Kind::Choice, .choices = kMotionKindNames};
constexpr Key kMotionKeys[] = {
    {"kind", &kMotionKind, "How the nodes move", nullptr, true},
    {"nodes", &kSelectors, "The nodes that move: a selector or a list of them", nullptr, true},
};
constexpr Key kLineKeys[] = {
    {"direction", &kDirection, "Any length but zero", nullptr, true},
    {"speed", &kSpeed, "Full speed", nullptr, true},
    {"distance", &kLength, "Where the motion ends; without it there is no end"},
    {"start", &kInstant, "When the motion begins", "0"},
    {"ramp", &kInstant, "Time in which the speed rises from 0, and falls to 0 before the end", "0"},
};
constexpr const Type* kPathPointTypes[] = {&kInstant, &kPoint};
constexpr Type kPathPoint{.kind = Kind::Tuple, .types = kPathPointTypes};
constexpr const Type* kPathPointItem[] = {&kPathPoint};
constexpr Type kPathPoints{
    .kind = Kind::List, .count_least = 1, .count_most = 100000, .types = kPathPointItem};
constexpr Key kPathKeys[] = {
    {"points", &kPathPoints,
     "[time in s, [x, y, z] in m from the rest position], times rising; straight between", nullptr, true},
};
constexpr Key kRotationKeys[] = {
    {"axis", &kDirection, "Any length but zero; the rotation is right-handed", nullptr, true},
    {"center", &kPoint, "A point of the axis, in the world", nullptr, true},
    {"speed", &kTurnRate, "Full speed", nullptr, true},
    {"angle", &kAngle, "Where the rotation ends; without it there is no end"},
    {"start", &kInstant, "When the motion begins", "0"},
    {"ramp", &kInstant, "Time in which the speed rises from 0, and falls to 0 before the end", "0"},
};
constexpr Key kGivenKeys[] = {
    {"speed", &kSpeed, "The most that a program may move a node, or a point of a collider, by", nullptr,
     true},
};
constexpr Variant kMotionVariants[] = {
    {"line", kLineKeys}, {"path", kPathKeys}, {"rotation", kRotationKeys}, {"given", kGivenKeys}};
constexpr Key kColliderMotionKeys[] = {
    {"kind", &kMotionKind, "How the collider moves", nullptr, true},
};
constexpr Type kColliderMotion{.kind = Kind::Object,
                               .name = "collider_motion",
                               .keys = kColliderMotionKeys,
                               .variants = kMotionVariants};
constexpr Type kMotion{
    .kind = Kind::Object, .name = "motion", .keys = kMotionKeys, .variants = kMotionVariants};
constexpr const Type* kMotionItem[] = {&kMotion};
constexpr Type kMotions{.kind = Kind::List, .count_most = 1000, .types = kMotionItem};

// attachments
constexpr Type kColliderNumber{.kind = Kind::Number, .least = 0, .most = 999, .whole = true};
constexpr Key kAttachmentKeys[] = {
    {"nodes", &kSelectors, "The nodes that go with it: a selector or a list of them", nullptr, true},
    {"collider", &kColliderNumber, "Its place in colliders, from 0", nullptr, true},
    {"reach", &kLength, "How far from its surface a node may be at time 0", "0.05"},
};
constexpr Type kAttachment{.kind = Kind::Object, .name = "attachment", .keys = kAttachmentKeys};
constexpr const Type* kAttachmentItem[] = {&kAttachment};
constexpr Type kAttachments{.kind = Kind::List, .count_most = 1000, .types = kAttachmentItem};

// grabs
constexpr Key kGrabPointKeys[] = {
    {"time", &kInstant, "When", nullptr, true},
    {"point", &kPoint, "Where, in the world", nullptr, true},
};
constexpr Type kGrabPoint{.kind = Kind::Object, .keys = kGrabPointKeys};
constexpr const Type* kGrabPointItem[] = {&kGrabPoint};
constexpr Type kGrabPath{.kind = Kind::List, .count_least = 1, .count_most = 100000, .types = kGrabPointItem};
constexpr Key kGrabKeys[] = {
    {"node", &kSelector, "The node that is grabbed: a selector of exactly one free node", nullptr, true},
    {"start", &kInstant, "When it is taken", "0"},
    {"end", &kInstant, "When it is let go; without it never"},
    {"path", &kGrabPath, "Where it is pulled, times rising; straight between, still before and after",
     nullptr, true},
};
constexpr Type kGrab{.kind = Kind::Object, .name = "grab", .keys = kGrabKeys};
constexpr const Type* kGrabItem[] = {&kGrab};
constexpr Type kGrabs{.kind = Kind::List, .count_most = 4096, .types = kGrabItem};

// cloths
constexpr Type kGrid{.kind = Kind::Numbers, .least = 2, .most = 16384, .whole = true, .count_least = 2};
constexpr Type kSize{.kind = Kind::Numbers, .least = kSmall, .most = kFar, .unit = "m", .count_least = 2};
constexpr Type kPlane{.kind = Kind::Choice, .choices = kPlaneNames};
constexpr Type kDensity{.kind = Kind::Number, .least = 1e-6, .most = 1e6, .unit = "kg/m²"};
constexpr Type kNodeMass{.kind = Kind::Number, .least = 1e-12, .most = 1e6, .unit = "kg"};
constexpr Type kSpringStiffness{.kind = Kind::Number, .most = 1e12, .unit = "N/m"};
constexpr Type kBending{.kind = Kind::Number, .most = 1e6, .unit = "N·m"};
constexpr Type kBump{.kind = Kind::Number, .least = -kFar, .most = kFar, .unit = "m"};
constexpr Type kStrainLimit{.kind = Kind::Number, .least = 0.001, .most = 10};
constexpr Type kDamping{.kind = Kind::Number, .most = 1e9, .unit = "N·s/m"};
constexpr Type kColor{.kind = Kind::Numbers, .most = 1, .count_least = 3};
constexpr Type kCopyCount{.kind = Kind::Number, .least = 1, .most = 1000, .whole = true};
constexpr Key kCopiesKeys[] = {
    {"count", &kCopyCount, "How often it stands, the first included", nullptr, true},
    {"offset", &kPoint, "From each copy to the next", nullptr, true},
};
constexpr Type kCopies{.kind = Kind::Object, .keys = kCopiesKeys};
constexpr Key kStiffnessKeys[] = {
    {"structural", &kSpringStiffness, "Springs along the threads, or along the edges of a mesh", "5000"},
    {"shear", &kSpringStiffness, "Springs along the diagonals", "2000"},
    {"bend", &kSpringStiffness, "Springs over two cells, or over an edge of a mesh", "500"},
    {"bending", &kBending, "Resistance of a grid to curvature, beside the bend springs", "0"},
};
constexpr Type kStiffness{.kind = Kind::Object, .keys = kStiffnessKeys};
constexpr Type kModulus{.kind = Kind::Number, .least = 1e-3, .most = 1e9, .unit = "N/m"};
constexpr Type kPoisson{.kind = Kind::Number, .least = -0.99, .most = 10};
constexpr Type kBendingModulus{.kind = Kind::Number, .most = 1e3, .unit = "N·m"};
constexpr Type kDelay{.kind = Kind::Number, .most = 10, .unit = "s"};
constexpr Type kRestAngles{.kind = Kind::Choice, .choices = kRestAnglesNames};
constexpr Type kFabricEnergy{.kind = Kind::Choice, .choices = kFabricEnergyNames};
constexpr Type kFabricName{.kind = Kind::Choice, .name = "fabric_name", .choices = kFabricNames};
constexpr Type kCurvature{.kind = Kind::Number, .least = 1e-3, .most = 1e6, .unit = "1/m"};
constexpr Type kHardening{.kind = Kind::Number, .most = 1e3};
constexpr Key kPlasticKeys[] = {
    {"yield_curvature", &kCurvature, "Up to which curvature the cloth springs back", nullptr, true},
    {"hardening", &kHardening, "How much that grows by all curvature that the cloth has kept", "0"},
};
constexpr Type kPlastic{.kind = Kind::Object, .name = "plastic", .keys = kPlasticKeys};
constexpr Key kFabricKeys[] = {
    {"name", &kFabricName, "A measured fabric, from which the numbers come that are not given here"},
    {"warp", &kModulus, "Young's modulus of a strip along the warp, force per width", nullptr, true, "name"},
    {"weft", &kModulus, "The same along the weft; without it the warp's"},
    {"shear", &kModulus, "Shear modulus", nullptr, true, "name"},
    {"poisson", &kPoisson, "Weft's contraction by warp's extension; its square below warp / weft", "0", false,
     "name"},
    {"bending_warp", &kBendingModulus, "What a strip along the warp resists curvature with, moment per width",
     nullptr, true, "name"},
    {"bending_weft", &kBendingModulus, "The same along the weft; without it the warp's"},
    {"bending_twist", &kBendingModulus,
     "Moment per width by twice the twist; without it half the geometric mean of both"},
    {"damping", &kDelay, "By the rate of a strain or bend the cloth resists as by this time's worth of it",
     "0.0001"},
    {"energy", &kFabricEnergy, "What strains are: of the yarns, Green's, or of an isotropic stable solid",
     "\"yarn\""},
    {"warp_direction", &kDirection, "The warp of a mesh, before its transform; a grid's goes along i",
     "[1, 0, 0]"},
    {"rest_angles", &kRestAngles, "Angles at the edges of a mesh that nothing bends: its own, or flat",
     "\"mesh\""},
    {"plastic", &kPlastic, "When a bend stays; without it the cloth springs back from every one"},
};
constexpr Type kFabricObject{.kind = Kind::Object, .keys = kFabricKeys};
constexpr const Type* kFabricTypes[] = {&kFabricName, &kFabricObject};
constexpr Type kFabric{.kind = Kind::Either, .types = kFabricTypes};
constexpr Type kSlack{.kind = Kind::Number, .most = 10};
constexpr Key kTethersKeys[] = {
    {"slack", &kSlack, "By which a tether is longer than the way along the cloth at rest, as a part of it",
     "0"},
};
constexpr Type kTethers{.kind = Kind::Object, .name = "tethers", .keys = kTethersKeys};
constexpr Type kGauge{.kind = Kind::Number, .least = -1e9, .most = 1e9, .unit = "Pa"};
constexpr Type kAmbient{.kind = Kind::Number, .most = 1e9, .unit = "Pa"};
constexpr Type kGasLaw{.kind = Kind::Choice, .choices = kGasLawNames};
constexpr Key kPressureKeys[] = {
    {"gauge", &kGauge, "Above the pressure outside, at the volume at rest", nullptr, true},
    {"ambient", &kAmbient, "The pressure outside", "101325"},
    {"law", &kGasLaw, "Ideal gas at constant temperature, p V = const, or the gauge pressure at any volume",
     "\"isothermal\""},
};
constexpr Type kPressure{.kind = Kind::Object, .name = "pressure", .keys = kPressureKeys};
constexpr const char* kMeshWords =
    "Name of a model, or path of an OBJ, PLY (.ply.gz too), OFF, STL or GLB file relative to the scene";
constexpr Key kPanelKeys[] = {
    {"grid", &kGrid, "Nodes along i and j"},
    {"size", &kSize, "Width along i and height along j of a grid"},
    {"plane", &kPlane, "As of a cloth that is a grid", "\"xy\""},
    {"mesh", &kMeshName, kMeshWords},
    {"transform", &kTransform, "Places the panel; that of the cloth follows", "{}"},
};
constexpr const char* kPanelWays[] = {"grid", "mesh"};
constexpr OneOf kPanelOneOf[] = {{kPanelWays}};
constexpr Needs kPanelNeeds[] = {{"grid", "size"}, {"size", "grid"}, {"plane", "grid"}};
constexpr Type kPanel{
    .kind = Kind::Object, .name = "panel", .keys = kPanelKeys, .one_of = kPanelOneOf, .needs = kPanelNeeds};
constexpr const Type* kPanelItem[] = {&kPanel};
constexpr Type kPanels{.kind = Kind::List, .count_least = 1, .count_most = 1000, .types = kPanelItem};
constexpr Type kPanelNumber{.kind = Kind::Number, .most = 999, .whole = true};
constexpr Key kSeamRowKeys[] = {
    {"panel", &kPanelNumber, "Its place in panels, from 0", "0"},
    {"nodes", &kSelectors, "What has of the panel's rim one run: a selector or a list of them", nullptr,
     true},
};
constexpr Type kSeamRow{.kind = Kind::Object, .name = "seam_row", .keys = kSeamRowKeys};
constexpr Type kThreadForce{.kind = Kind::Number, .least = 1e-3, .most = 1e6, .unit = "N/m"};
constexpr Type kThreadSpeed{.kind = Kind::Number, .least = 1e-3, .most = 100, .unit = "m/s"};
constexpr Type kWithin{.kind = Kind::Number, .least = 1e-6, .most = 0.01, .unit = "m"};
constexpr Key kSeamKeys[] = {
    {"first", &kSeamRow, "One row of nodes", nullptr, true},
    {"second", &kSeamRow, "The row that is sewn to it", nullptr, true},
    {"reversed", &kTruth, "Sewn the other way round than where the rows are nearer at the start", "false"},
    {"force", &kThreadForce, "What the threads pull with at most, by length of the seam", "20"},
    {"speed", &kThreadSpeed, "How fast they pull at most", "0.5"},
    {"within", &kWithin, "How near all pairs are when they become one", "0.0001"},
    {"start", &kInstant, "When the threads begin to pull", "0"},
    {"patience", &kInstant, "How long after that the seam is waited for", "10"},
};
constexpr Type kSeam{.kind = Kind::Object, .name = "seam", .keys = kSeamKeys};
constexpr const Type* kSeamItem[] = {&kSeam};
constexpr Type kSeams{.kind = Kind::List, .count_least = 1, .count_most = 1000, .types = kSeamItem};
constexpr Type kWeave{.kind = Kind::Choice, .choices = kWeaveNames};
constexpr Type kPattern{.kind = Kind::Choice, .choices = kPatternNames};
constexpr Type kThreads{.kind = Kind::Number, .least = 0.1, .most = 1000, .unit = "1/cm"};
constexpr Type kShare{.kind = Kind::Number, .most = 1};
constexpr Type kTranslucency{.kind = Kind::Number, .most = 0.9};
constexpr Type kLookName{.kind = Kind::Choice, .name = "look_name", .choices = kLookNames};
constexpr Key kLookKeys[] = {
    {"name", &kLookName,
     "A look by name, from which all comes that is not given here; without it the fabric's"},
    {"weave", &kWeave, "How the threads cross"},
    {"pattern", &kPattern, "What their colours make"},
    {"threads_per_cm", &kThreads,
     "Threads, or of a knit columns of loops; without it and a name 150 over the sheet"},
    {"weft", &kColor, "Red, green and blue of the weft; the warp has the cloth's color"},
    {"stripe", &kColor, "Red, green and blue of checks and stripes"},
    {"sheen", &kShare, "How much fibres that stand up shine at a slant"},
    {"gloss", &kShare, "How bright the highlights of the threads are"},
    {"translucency", &kTranslucency, "The part of the light not absorbed that goes through"},
};
constexpr Type kLookObject{.kind = Kind::Object, .keys = kLookKeys};
constexpr const Type* kLookTypes[] = {&kLookName, &kLookObject};
constexpr Type kLook{.kind = Kind::Either, .types = kLookTypes};
constexpr Type kStrength{.kind = Kind::Number, .least = 1e-3, .most = 1e9, .unit = "N/m"};
constexpr Key kClothKeys[] = {
    {"name", &kShortText, "For messages"},
    {"grid", &kGrid, "Nodes along i and j; all grids together have at most 67108864"},
    {"size", &kSize, "Width along i and height along j of a grid"},
    {"plane", &kPlane, "A grid hangs (\"xy\": j runs down) or lies flat (\"xz\": j runs along +z)", "\"xy\""},
    {"bump", &kBump, "How far the middle of a grid stands out along its normal at the start", "0"},
    {"mesh", &kMeshName, kMeshWords},
    {"panels", &kPanels, "Sheets that make up the cloth, instead of a grid or a mesh"},
    {"seams", &kSeams, "Runs of the rim that are sewn together; only in weft run"},
    {"transform", &kTransform, "From the sheet centred on the origin, or the mesh, to the world", "{}"},
    {"density", &kDensity, "Mass per rest area; without it and node_mass that of the fabric's name"},
    {"node_mass", &kNodeMass, "Mass of every node alike"},
    {"fabric", &kFabric,
     "A measured cloth by its name or its moduli, instead of springs; projective_dynamics where it is flat "
     "at "
     "rest and its energy yarn"},
    {"stiffness", &kStiffness, "Stiffness of the springs", "{}"},
    {"damping", &kDamping, "Damping along each spring", "0.25"},
    {"friction", &kFriction,
     "With cloth, and with colliders that give none; only proximity uses it; without it that of the fabric's "
     "name",
     "0.3", false, "fabric"},
    {"strain_limit", &kStrainLimit,
     "How far edges are stretched before they are stiffer, of their length; only multigrid and "
     "fem"},
    {"tethers", &kTethers, "How far nodes may be from pinned and moved ones; only xpbd and pbd"},
    {"strength", &kStrength, "The force per width that the cloth bears before it tears; only in weft run"},
    {"pressure", &kPressure, "Of the gas in a closed mesh"},
    {"pins", &kPinList, "Nodes that stay where they are", "[]"},
    {"motions", &kMotions, "Nodes that follow a given motion", "[]"},
    {"attachments", &kAttachments, "Nodes that go where a collider's surface goes", "[]"},
    {"grabs", &kGrabs, "Nodes that are pulled to a point for a while", "[]"},
    {"color", &kColor, "Red, green and blue"},
    {"look", &kLook, "How it takes light and what it is woven of, by name or by its numbers"},
    {"copies", &kCopies, "The same cloth again and again, each some way further; not with grabs"},
};
constexpr const char* kShapeWays[] = {"grid", "mesh", "panels"};
constexpr const char* kMassWays[] = {"density", "node_mass"};
constexpr OneOf kClothOneOf[] = {{kShapeWays}, {kMassWays, "fabric"}};
constexpr Needs kClothNeeds[] = {
    {"grid", "size"}, {"size", "grid"}, {"plane", "grid"}, {"bump", "grid"}, {"pressure", "mesh"}};
constexpr Type kCloth{
    .kind = Kind::Object, .name = "cloth", .keys = kClothKeys, .one_of = kClothOneOf, .needs = kClothNeeds};
constexpr const Type* kClothItem[] = {&kCloth};
constexpr Type kCloths{.kind = Kind::List, .count_most = 1000, .types = kClothItem};

// bodies
constexpr Type kCells{.kind = Kind::Numbers, .least = 1, .most = 4096, .whole = true, .count_least = 3};
constexpr Type kSides{.kind = Kind::Numbers, .least = kSmall, .most = kFar, .unit = "m", .count_least = 3};
constexpr Type kMassDensity{.kind = Kind::Number, .least = 1e-3, .most = 1e6, .unit = "kg/m³"};
constexpr Type kYoung{.kind = Kind::Number, .least = 1e-3, .most = 1e12, .unit = "Pa"};
constexpr Type kSolidPoisson{.kind = Kind::Number, .least = -0.9, .most = 0.499};
constexpr Type kSolidEnergy{.kind = Kind::Choice, .choices = kSolidEnergyNames};
constexpr Key kMaterialKeys[] = {
    {"young", &kYoung, "Young's modulus", nullptr, true},
    {"poisson", &kSolidPoisson, "Poisson's ratio; of energy \"neo_hookean\" at least 0.4", "0.45"},
    {"damping", &kDelay, "By the rate of a strain the body resists as by this time's worth of it", "0.001"},
    {"energy", &kSolidEnergy, "Of a stable neo-Hookean solid, or linear in the frame of the nearest rotation",
     "\"neo_hookean\""},
};
constexpr Type kMaterial{.kind = Kind::Object, .name = "material", .keys = kMaterialKeys};
constexpr Key kBodyKeys[] = {
    {"name", &kShortText, "For messages"},
    {"block", &kCells,
     "Cells along x, y and z, each of five tetrahedra; all blocks together have at most "
     "67108864 nodes"},
    {"size", &kSides, "Lengths of a block's edges"},
    {"tetrahedra", &kMeshName,
     "Path of a tetrahedral mesh relative to the scene: MSH, ELE beside NODE, or VTK"},
    {"surface", &kMeshName, "Name of a model, or path of a closed mesh, whose inside is filled"},
    {"cell", &kLength, "Of the lattice that fills a surface: the edge of its cubes, in the world"},
    {"transform", &kTransform, "From the block centred on the origin, or the mesh, to the world", "{}"},
    {"density", &kMassDensity, "Mass per rest volume", nullptr, true},
    {"material", &kMaterial, "What the body resists with", nullptr, true},
    {"friction", &kFriction,
     "With cloth and bodies, and with colliders that give none; only proximity uses it", "0.3"},
    {"pins", &kPinList, "Nodes that stay where they are", "[]"},
    {"motions", &kMotions, "Nodes that follow a given motion", "[]"},
    {"attachments", &kAttachments, "Nodes that go where a collider's surface goes", "[]"},
    {"grabs", &kGrabs, "Nodes that are pulled to a point for a while", "[]"},
    {"color", &kColor, "Red, green and blue"},
    {"copies", &kCopies, "The same body again and again, each some way further; not with grabs"},
};
constexpr const char* kBodyWays[] = {"block", "tetrahedra", "surface"};
constexpr OneOf kBodyOneOf[] = {{kBodyWays}};
constexpr Needs kBodyNeeds[] = {
    {"block", "size"}, {"size", "block"}, {"surface", "cell"}, {"cell", "surface"}};
constexpr Type kBody{
    .kind = Kind::Object, .name = "body", .keys = kBodyKeys, .one_of = kBodyOneOf, .needs = kBodyNeeds};
constexpr const Type* kBodyItem[] = {&kBody};
constexpr Type kBodies{.kind = Kind::List, .count_most = 1000, .types = kBodyItem};

// colliders
constexpr Type kMassOfBody{.kind = Kind::Number, .least = 1e-6, .most = 1e6, .unit = "kg"};
constexpr Type kStartSpeed{
    .kind = Kind::Numbers, .least = -1000, .most = 1000, .unit = "m/s", .count_least = 3};
constexpr Type kStartSpin{
    .kind = Kind::Numbers, .least = -1000, .most = 1000, .unit = "rad/s", .count_least = 3};
constexpr Key kRigidKeys[] = {
    {"density", &kMassDensity, "Mass per volume"},
    {"mass", &kMassOfBody, "Of the whole"},
    {"velocity", &kStartSpeed, "Of its centre of mass at the start", "[0, 0, 0]"},
    {"spin", &kStartSpin, "Angular velocity at the start", "[0, 0, 0]"},
};
constexpr const char* kRigidWays[] = {"density", "mass"};
constexpr OneOf kRigidOneOf[] = {{kRigidWays}};
constexpr Type kRigid{.kind = Kind::Object, .name = "rigid", .keys = kRigidKeys, .one_of = kRigidOneOf};
constexpr const char* kColliderKindNames[] = {"mesh", "sphere", "plane", "capsule", "box", "convex"};
constexpr Type kColliderKind{.kind = Kind::Choice, .choices = kColliderKindNames};
constexpr Type kColliderMaterial{.kind = Kind::Choice, .choices = kMaterialNames};
constexpr Key kColliderKeys[] = {
    {"kind", &kColliderKind, "The shape", nullptr, true},
    {"friction", &kFriction, "Without it the cloth's; only proximity uses it"},
    {"motion", &kColliderMotion, "Without it the collider stays; needs proximity"},
    {"rigid", &kRigid,
     "A mass that cloth and gravity move; spheres, boxes, capsules and convex hulls have one"},
    {"material", &kColliderMaterial, "What it looks like it is made of", "\"plaster\""},
};
constexpr Type kKeyframeTime{.kind = Kind::Number, .least = 1e-6, .most = kLate, .unit = "s"};
constexpr Key kKeyframeKeys[] = {
    {"time", &kKeyframeTime, "When", nullptr, true},
    {"mesh", &kMeshName, "The shape then: the same vertices and triangles elsewhere", nullptr, true},
};
constexpr Type kKeyframe{.kind = Kind::Object, .name = "keyframe", .keys = kKeyframeKeys};
constexpr const Type* kKeyframeItem[] = {&kKeyframe};
constexpr Type kKeyframes{.kind = Kind::List, .count_most = 1000, .types = kKeyframeItem};
constexpr Type kAnimationStart{.kind = Kind::Number, .least = 0, .most = kLate, .unit = "s"};
constexpr Type kAnimationSpeed{.kind = Kind::Number, .least = 0.001, .most = 1000};
constexpr Type kAnimationRate{.kind = Kind::Number, .least = 1, .most = 10000, .unit = "1/s"};
constexpr Key kAnimationKeys[] = {
    {"name", &kShortText, "Which of the file's animations; without it the first"},
    {"start", &kAnimationStart, "Where in it time 0 is", "0"},
    {"speed", &kAnimationSpeed, "Its seconds in a second", "1"},
    {"loop", &kTruth, "Whether it begins anew at its end; else it stays there", "true"},
    {"rate", &kAnimationRate, "Shapes a second that it is taken as; straight between", "60"},
};
constexpr Type kAnimation{.kind = Kind::Object, .name = "animation", .keys = kAnimationKeys};
constexpr Key kMeshColliderKeys[] = {
    {"mesh", &kMeshName, kMeshWords, nullptr, true},
    {"transform", &kTransform, "From the mesh to the world", "{}"},
    {"keyframes", &kKeyframes, "Shapes that it comes to, times rising; straight between; needs proximity",
     "[]"},
    {"animation", &kAnimation, "An animation of its GLB file, with the file's skins; needs proximity"},
};
constexpr Key kSphereKeys[] = {
    {"center", &kPoint, "Centre", nullptr, true},
    {"radius", &kLength, "Radius", nullptr, true},
};
constexpr Key kPlaneKeys[] = {
    {"point", &kPoint, "A point of the plane", nullptr, true},
    {"normal", &kDirection, "Out of the solid side; any length but zero", nullptr, true},
};
constexpr Key kCapsuleKeys[] = {
    {"a", &kPoint, "One end of the axis", nullptr, true},
    {"b", &kPoint, "The other end, not a itself", nullptr, true},
    {"radius", &kLength, "Greatest distance from the axis", nullptr, true},
};
constexpr Key kBoxColliderKeys[] = {
    {"center", &kPoint, "Centre", nullptr, true},
    {"size", &kSides, "Lengths of the edges along x, y and z, before it is rotated", nullptr, true},
    {"rotate", &kQuaternion, "Unit quaternion [x, y, z, w] (length within 0.001 of 1), about the centre",
     "[0, 0, 0, 1]"},
};
constexpr const Type* kPointItem[] = {&kPoint};
constexpr Type kHullPoints{.kind = Kind::List, .count_least = 4, .count_most = 100000, .types = kPointItem};
constexpr Key kConvexKeys[] = {
    {"mesh", &kMeshName, "Name of a model, or path of a mesh file: the hull is of its vertices"},
    {"points", &kHullPoints, "Instead of a mesh, the points that the hull is of; not all in a plane"},
    {"transform", &kTransform, "From the mesh or the points to the world", "{}"},
};
constexpr const char* kConvexWays[] = {"mesh", "points"};
constexpr OneOf kConvexOneOf[] = {{kConvexWays}};
constexpr Variant kColliderVariants[] = {{"mesh", kMeshColliderKeys}, {"sphere", kSphereKeys},
                                         {"plane", kPlaneKeys},       {"capsule", kCapsuleKeys},
                                         {"box", kBoxColliderKeys},   {"convex", kConvexKeys, kConvexOneOf}};
constexpr Type kCollider{
    .kind = Kind::Object, .name = "collider", .keys = kColliderKeys, .variants = kColliderVariants};
constexpr const Type* kColliderItem[] = {&kCollider};
constexpr Type kColliders{.kind = Kind::List, .count_most = 1000, .types = kColliderItem};

// camera and render
constexpr Type kFov{.kind = Kind::Number, .least = 1, .most = 170, .unit = "°"};
constexpr Key kCameraKeys[] = {
    {"eye", &kPoint, "Where the camera is", nullptr, true},
    {"target", &kPoint, "What it looks at, not the eye itself", nullptr, true},
    {"fov_degrees", &kFov, "Vertical field of view", "35"},
};
constexpr Type kCamera{.kind = Kind::Object, .keys = kCameraKeys};
constexpr Type kView{.kind = Kind::Choice, .choices = kViewNames};
constexpr Type kPicture{
    .kind = Kind::Numbers, .least = 16, .most = 16384, .whole = true, .unit = "pixels", .count_least = 2};
constexpr Type kSubdivide{.kind = Kind::Number, .most = 4, .whole = true};
constexpr Type kEnvironment{.kind = Kind::Choice, .choices = kEnvironmentNames};
constexpr Type kSunDegrees{.kind = Kind::Number, .least = 0.1, .most = 30, .unit = "°"};
constexpr Key kLightKeys[] = {
    {"environment", &kEnvironment, "Soft boxes in a studio, or a blue sky", "\"studio\""},
    {"direction", &kDirection, "To the sun or the key light; without it from the camera's left, above"},
    {"degrees", &kSunDegrees, "The angle that it covers: how soft its shadows are", "3"},
};
constexpr Type kLight{.kind = Kind::Object, .name = "light", .keys = kLightKeys};
constexpr Key kRenderKeys[] = {
    {"view", &kView, "What is drawn", "\"textured\""},
    {"size", &kPicture, "Width and height of the picture", "[1280, 720]"},
    {"subdivide", &kSubdivide, "How often each cell of the drawn and exported cloth is halved; grids only",
     "0"},
    {"light", &kLight, "What the picture is lit by", "{}"},
};
constexpr Type kRender{.kind = Kind::Object, .keys = kRenderKeys};

// the scene
constexpr const char* kFormatNames[] = {"weft-scene/1"};
constexpr Type kFormat{.kind = Kind::Choice, .choices = kFormatNames};
constexpr Key kSceneKeys[] = {
    {"format", &kFormat, "The format and its version", nullptr, true},
    {"title", &kShortText, "One line for people"},
    {"description", &kLongText, "What the scene shows"},
    {"gravity", &kAcceleration, "Acceleration of everything; y points up", "[0, -9.81, 0]"},
    {"external_force", &kForcePerMass, "Uniform force on each kilogram of cloth, beside gravity",
     "[0, 0, 0]"},
    {"drag", &kRate, "Air drag: acceleration = -drag * (velocity - wind)", "0"},
    {"wind", &kWind, "The moving air that drag pulls towards, and that pushes where there is \"air\"", "{}"},
    {"air", &kAir, "Pressure, lift and friction on every triangle; without it there are none"},
    {"time", &kTime, "Frames and steps", "{}"},
    {"solver", &kSolver, "How cloth moves", "{}"},
    {"contact", &kContact, "How cloth meets colliders", "{}"},
    {"cloths", &kCloths, "The sheets; a scene has at least one, or a body", "[]"},
    {"bodies", &kBodies, "Elastic bodies with volume", "[]"},
    {"colliders", &kColliders, "The obstacles", "[]"},
    {"camera", &kCamera, "Without it the whole scene is framed"},
    {"render", &kRender, "What a picture shows", "{}"},
};
constexpr Type kScene{.kind = Kind::Object, .keys = kSceneKeys};

}  // namespace

const Type& scene_type() { return kScene; }

}  // namespace weft::scene
