// Made by scripts/make_scene_types.ts from the JSON Schema of scenes: `weft schema`.

/** A scene: docs/scene.md. */
export interface SceneObject {
  /** The format and its version. */
  readonly format: "weft-scene/1";
  /** One line for people. */
  readonly title?: string | undefined;
  /** What the scene shows. */
  readonly description?: string | undefined;
  /** Acceleration of everything; y points up [m/s²]. Default: [0,-9.81,0] */
  readonly gravity?: readonly [number, number, number] | undefined;
  /** Uniform force on each kilogram of cloth, beside gravity [N/kg]. Default: [0,0,0] */
  readonly external_force?: readonly [number, number, number] | undefined;
  /** Air drag: acceleration = -drag * (velocity - wind) [1/s]. Default: 0 */
  readonly drag?: number | undefined;
  /** The moving air that drag pulls towards, and that pushes where there is "air". Default: {} */
  readonly wind?: {
    /** The mean [m/s]. Default: [0,0,0] */
    readonly velocity?: readonly [number, number, number] | undefined;
    /** Strength of the gusts, as a part of the mean. Default: 0 */
    readonly gusts?: number | undefined;
    /** Length of the gusts along the wind [m]. Default: 1 */
    readonly wavelength?: number | undefined;
  } | undefined;
  /** Pressure, lift and friction on every triangle; without it there are none. */
  readonly air?: {
    /** Density of the air [kg/m³]. Default: 1.225 */
    readonly density?: number | undefined;
    /** Pressure on a sheet across the flow, by the dynamic pressure. Default: 1.17 */
    readonly pressure?: number | undefined;
    /** Normal force on a sheet by its small angle to the flow. Default: 1.48 */
    readonly lift?: number | undefined;
    /** Friction on both faces of a sheet along the flow. Default: 0.01 */
    readonly friction?: number | undefined;
  } | undefined;
  /** Frames and steps. Default: {} */
  readonly time?: {
    /** Simulated time of one frame (1/60 s) [s]. Default: 0.016666666666666666 */
    readonly frame?: number | undefined;
    /** Steps in a frame; "auto" asks the solver how many are stable. Default: "auto" */
    readonly substeps?: number | "auto" | undefined;
    /** Frames of a run. Default: 90 */
    readonly frames?: number | undefined;
  } | undefined;
  /** How cloth moves. Default: {} */
  readonly solver?: {
    /** The method. Default: "auto" */
    readonly kind: "mass_spring";
    /** Gather over each node's springs, or scatter from each spring by atomic adds. Default: "node_centric" */
    readonly forces?: "node_centric" | "spring_centric" | "spring_blocks" | undefined;
  } | {
    /** The method. Default: "auto" */
    readonly kind: "multigrid";
    /** What a substep may leave of its linear system's residual, by what it began with. Default: 0.01 */
    readonly residual?: number | undefined;
  } | {
    /** The method. Default: "auto" */
    readonly kind: "xpbd";
    /** Sweeps over all elements in a substep; more substeps do more for the same work. Default: 1 */
    readonly iterations?: number | undefined;
  } | {
    /** The method. Default: "auto" */
    readonly kind: "pbd";
    /** Sweeps over all elements in a substep; more make cloth stiffer. Default: 10 */
    readonly iterations?: number | undefined;
  } | {
    /** The method. Default: "auto" */
    readonly kind: "vbd";
    /** Sweeps over all nodes in a substep. Default: 10 */
    readonly iterations?: number | undefined;
  } | {
    /** The method. Default: "auto" */
    readonly kind: "projective_dynamics";
    /** Iterations over all nodes in a substep. Default: 20 */
    readonly iterations?: number | undefined;
  } | {
    /** The method. Default: "auto" */
    readonly kind: "fem";
    /** Newton steps in a substep at most. Default: 4 */
    readonly iterations?: number | undefined;
    /** What a substep may leave of its equation's residual, by what it began with. Default: 0.01 */
    readonly residual?: number | undefined;
  } | {
    /** The method. Default: "auto" */
    readonly kind?: "auto" | undefined;
    /** Gather over each node's springs, or scatter from each spring by atomic adds. Default: "node_centric" */
    readonly forces?: "node_centric" | "spring_centric" | "spring_blocks" | undefined;
    /** What a substep may leave of its linear system's residual, by what it began with. Default: 0.01 */
    readonly residual?: number | undefined;
  } | undefined;
  /** How cloth meets colliders. Default: {} */
  readonly contact?: {
    /** How cloth meets colliders: not at all, all pairs, pairs from a tree, or before surfaces meet, cloth
     * too. Default: "proximity" */
    readonly method?: "none" | "paper" | "bvh" | "proximity" | undefined;
    /** Distance that contact keeps from a surface; above 0 for proximity [m]. Default: 0.005 */
    readonly thickness?: number | undefined;
    /** Whether cloth meets cloth; only proximity uses it. Default: true */
    readonly self?: boolean | undefined;
    /** Part of the normal velocity that comes back; only proximity uses it. Default: 0 */
    readonly restitution?: number | undefined;
  } | undefined;
  /** The sheets; a scene has at least one, or a body. Default: [] */
  readonly cloths?: readonly (SceneCloth)[] | undefined;
  /** Elastic bodies with volume. Default: [] */
  readonly bodies?: readonly (SceneBody)[] | undefined;
  /** The obstacles. Default: [] */
  readonly colliders?: readonly (SceneCollider)[] | undefined;
  /** Without it the whole scene is framed. */
  readonly camera?: {
    /** Where the camera is [m]. */
    readonly eye: ScenePoint;
    /** What it looks at, not the eye itself [m]. */
    readonly target: ScenePoint;
    /** Vertical field of view [°]. Default: 35 */
    readonly fov_degrees?: number | undefined;
  } | undefined;
  /** What a picture shows. Default: {} */
  readonly render?: {
    /** What is drawn. Default: "textured" */
    readonly view?: "textured" | "wireframe" | "normals" | "stretch" | "velocity" | "contacts" | undefined;
    /** Width and height of the picture [pixels]. Default: [1280,720] */
    readonly size?: readonly [number, number] | undefined;
    /** How often each cell of the drawn and exported cloth is halved; grids only. Default: 0 */
    readonly subdivide?: number | undefined;
    /** What the picture is lit by. Default: {} */
    readonly light?: SceneLight | undefined;
  } | undefined;
}

export type SceneCloth = {
  /** For messages. */
  readonly name?: string | undefined;
  /** Nodes along i and j; all grids together have at most 67108864. */
  readonly grid?: readonly [number, number] | undefined;
  /** Width along i and height along j of a grid [m]. */
  readonly size?: readonly [number, number] | undefined;
  /** A grid hangs ("xy": j runs down) or lies flat ("xz": j runs along +z). Default: "xy" */
  readonly plane?: "xy" | "xz" | undefined;
  /** How far the middle of a grid stands out along its normal at the start [m]. Default: 0 */
  readonly bump?: number | undefined;
  /** Name of a model, or path of an OBJ, PLY (.ply.gz too), OFF, STL or GLB file relative to the scene. */
  readonly mesh?: string | undefined;
  /** Sheets that make up the cloth, instead of a grid or a mesh. */
  readonly panels?: readonly (ScenePanel)[] | undefined;
  /** Runs of the rim that are sewn together; only in weft run. */
  readonly seams?: readonly (SceneSeam)[] | undefined;
  /** From the sheet centred on the origin, or the mesh, to the world. Default: {} */
  readonly transform?: SceneTransform | undefined;
  /** Mass per rest area; without it and node_mass that of the fabric's name [kg/m²]. */
  readonly density?: number | undefined;
  /** Mass of every node alike [kg]. */
  readonly node_mass?: number | undefined;
  /** A measured cloth by its name or its moduli, instead of springs; projective_dynamics where it is flat
   * at rest and its energy yarn. */
  readonly fabric?: SceneFabricName | {
    /** A measured fabric, from which the numbers come that are not given here. */
    readonly name?: SceneFabricName | undefined;
    /** Young's modulus of a strip along the warp, force per width [N/m]. */
    readonly warp?: number | undefined;
    /** The same along the weft; without it the warp's [N/m]. */
    readonly weft?: number | undefined;
    /** Shear modulus [N/m]. */
    readonly shear?: number | undefined;
    /** Weft's contraction by warp's extension; its square below warp / weft. Default: 0 */
    readonly poisson?: number | undefined;
    /** What a strip along the warp resists curvature with, moment per width [N·m]. */
    readonly bending_warp?: number | undefined;
    /** The same along the weft; without it the warp's [N·m]. */
    readonly bending_weft?: number | undefined;
    /** Moment per width by twice the twist; without it half the geometric mean of both [N·m]. */
    readonly bending_twist?: number | undefined;
    /** By the rate of a strain or bend the cloth resists as by this time's worth of it [s]. Default: 0.0001 */
    readonly damping?: number | undefined;
    /** What strains are: of the yarns, Green's, or of an isotropic stable solid. Default: "yarn" */
    readonly energy?: "yarn" | "green" | "neo_hookean" | undefined;
    /** The warp of a mesh, before its transform; a grid's goes along i. Default: [1,0,0] */
    readonly warp_direction?: SceneDirection | undefined;
    /** Angles at the edges of a mesh that nothing bends: its own, or flat. Default: "mesh" */
    readonly rest_angles?: "mesh" | "flat" | undefined;
    /** When a bend stays; without it the cloth springs back from every one. */
    readonly plastic?: ScenePlastic | undefined;
  } | undefined;
  /** Stiffness of the springs. Default: {} */
  readonly stiffness?: {
    /** Springs along the threads, or along the edges of a mesh [N/m]. Default: 5000 */
    readonly structural?: number | undefined;
    /** Springs along the diagonals [N/m]. Default: 2000 */
    readonly shear?: number | undefined;
    /** Springs over two cells, or over an edge of a mesh [N/m]. Default: 500 */
    readonly bend?: number | undefined;
    /** Resistance of a grid to curvature, beside the bend springs [N·m]. Default: 0 */
    readonly bending?: number | undefined;
  } | undefined;
  /** Damping along each spring [N·s/m]. Default: 0.25 */
  readonly damping?: number | undefined;
  /** With cloth, and with colliders that give none; only proximity uses it; without it that of the
   * fabric's name. Default: 0.3 */
  readonly friction?: number | undefined;
  /** How far edges are stretched before they are stiffer, of their length; only multigrid and fem. */
  readonly strain_limit?: number | undefined;
  /** How far nodes may be from pinned and moved ones; only xpbd and pbd. */
  readonly tethers?: SceneTethers | undefined;
  /** The force per width that the cloth bears before it tears; only in weft run [N/m]. */
  readonly strength?: number | undefined;
  /** Of the gas in a closed mesh. */
  readonly pressure?: ScenePressure | undefined;
  /** Nodes that stay where they are. Default: [] */
  readonly pins?: readonly (SceneSelector)[] | undefined;
  /** Nodes that follow a given motion. Default: [] */
  readonly motions?: readonly (SceneMotion)[] | undefined;
  /** Nodes that go where a collider's surface goes. Default: [] */
  readonly attachments?: readonly (SceneAttachment)[] | undefined;
  /** Nodes that are pulled to a point for a while. Default: [] */
  readonly grabs?: readonly (SceneGrab)[] | undefined;
  /** Red, green and blue. */
  readonly color?: readonly [number, number, number] | undefined;
  /** How it takes light and what it is woven of, by name or by its numbers. */
  readonly look?: SceneLookName | {
    /** A look by name, from which all comes that is not given here; without it the fabric's. */
    readonly name?: SceneLookName | undefined;
    /** How the threads cross. */
    readonly weave?: "plain" | "twill" | "satin" | "knit" | "none" | undefined;
    /** What their colours make. */
    readonly pattern?: "plain" | "check" | "stripes" | undefined;
    /** Threads, or of a knit columns of loops; without it and a name 150 over the sheet [1/cm]. */
    readonly threads_per_cm?: number | undefined;
    /** Red, green and blue of the weft; the warp has the cloth's color. */
    readonly weft?: readonly [number, number, number] | undefined;
    /** Red, green and blue of checks and stripes. */
    readonly stripe?: readonly [number, number, number] | undefined;
    /** How much fibres that stand up shine at a slant. */
    readonly sheen?: number | undefined;
    /** How bright the highlights of the threads are. */
    readonly gloss?: number | undefined;
    /** The part of the light not absorbed that goes through. */
    readonly translucency?: number | undefined;
  } | undefined;
  /** The same cloth again and again, each some way further; not with grabs. */
  readonly copies?: {
    /** How often it stands, the first included. */
    readonly count: number;
    /** From each copy to the next [m]. */
    readonly offset: ScenePoint;
  } | undefined;
};

export type ScenePanel = {
  /** Nodes along i and j. */
  readonly grid?: readonly [number, number] | undefined;
  /** Width along i and height along j of a grid [m]. */
  readonly size?: readonly [number, number] | undefined;
  /** As of a cloth that is a grid. Default: "xy" */
  readonly plane?: "xy" | "xz" | undefined;
  /** Name of a model, or path of an OBJ, PLY (.ply.gz too), OFF, STL or GLB file relative to the scene. */
  readonly mesh?: string | undefined;
  /** Places the panel; that of the cloth follows. Default: {} */
  readonly transform?: SceneTransform | undefined;
};

export type SceneTransform = {
  /** Factor on all lengths; applied first. Default: 1 */
  readonly scale?: number | undefined;
  /** Unit quaternion [x, y, z, w] (length within 0.001 of 1); applied second. Default: [0,0,0,1] */
  readonly rotate?: readonly [number, number, number, number] | undefined;
  /** Shift; applied last [m]. Default: [0,0,0] */
  readonly translate?: ScenePoint | undefined;
};

export type ScenePoint = readonly [number, number, number];

export type SceneSeam = {
  /** One row of nodes. */
  readonly first: SceneSeamRow;
  /** The row that is sewn to it. */
  readonly second: SceneSeamRow;
  /** Sewn the other way round than where the rows are nearer at the start. Default: false */
  readonly reversed?: boolean | undefined;
  /** What the threads pull with at most, by length of the seam [N/m]. Default: 20 */
  readonly force?: number | undefined;
  /** How fast they pull at most [m/s]. Default: 0.5 */
  readonly speed?: number | undefined;
  /** How near all pairs are when they become one [m]. Default: 0.0001 */
  readonly within?: number | undefined;
  /** When the threads begin to pull [s]. Default: 0 */
  readonly start?: number | undefined;
  /** How long after that the seam is waited for [s]. Default: 10 */
  readonly patience?: number | undefined;
};

export type SceneSeamRow = {
  /** Its place in panels, from 0. Default: 0 */
  readonly panel?: number | undefined;
  /** What has of the panel's rim one run: a selector or a list of them. */
  readonly nodes: "top_left" | "top_right" | "bottom_left" | "bottom_right" | "top" | "bottom" | "left" | "right"
    | "corners" | "edges" | {
    /** Nodes whose rest position in the world lies in the box. */
    readonly box?: {
      /** Least corner [m]. */
      readonly min: ScenePoint;
      /** Greatest corner, nowhere below min [m]. */
      readonly max: ScenePoint;
    } | undefined;
    /** Nodes by index: j * nx + i on a grid, the file's order on a mesh. */
    readonly nodes?: readonly (number)[] | undefined;
    /** Nodes whose rest position in the world is near a point. */
    readonly near?: {
      /** Centre [m]. */
      readonly point: ScenePoint;
      /** Greatest distance from it [m]. */
      readonly radius: number;
    } | undefined;
  } | readonly (SceneSelector)[];
};

export type SceneSelector = "top_left" | "top_right" | "bottom_left" | "bottom_right" | "top" | "bottom" | "left"
  | "right" | "corners" | "edges" | {
  /** Nodes whose rest position in the world lies in the box. */
  readonly box?: {
    /** Least corner [m]. */
    readonly min: ScenePoint;
    /** Greatest corner, nowhere below min [m]. */
    readonly max: ScenePoint;
  } | undefined;
  /** Nodes by index: j * nx + i on a grid, the file's order on a mesh. */
  readonly nodes?: readonly (number)[] | undefined;
  /** Nodes whose rest position in the world is near a point. */
  readonly near?: {
    /** Centre [m]. */
    readonly point: ScenePoint;
    /** Greatest distance from it [m]. */
    readonly radius: number;
  } | undefined;
};

export type SceneFabricName = "denim_11oz" | "ponte_roma" | "interlock" | "rib_knit" | "sweater_knit" | "blanket"
  | "trousers" | "jacket" | "tablecloth" | "swimsuit" | "cotton_broad" | "wool_tropical" | "polyester_tropical"
  | "polyester_faille";

export type SceneDirection = readonly [number, number, number];

export type ScenePlastic = {
  /** Up to which curvature the cloth springs back [1/m]. */
  readonly yield_curvature: number;
  /** How much that grows by all curvature that the cloth has kept. Default: 0 */
  readonly hardening?: number | undefined;
};

export type SceneTethers = {
  /** By which a tether is longer than the way along the cloth at rest, as a part of it. Default: 0 */
  readonly slack?: number | undefined;
};

export type ScenePressure = {
  /** Above the pressure outside, at the volume at rest [Pa]. */
  readonly gauge: number;
  /** The pressure outside [Pa]. Default: 101325 */
  readonly ambient?: number | undefined;
  /** Ideal gas at constant temperature, p V = const, or the gauge pressure at any volume. Default:
   * "isothermal" */
  readonly law?: "isothermal" | "constant" | undefined;
};

export type SceneMotion = {
  /** How the nodes move. */
  readonly kind: "line";
  /** The nodes that move: a selector or a list of them. */
  readonly nodes: "top_left" | "top_right" | "bottom_left" | "bottom_right" | "top" | "bottom" | "left" | "right"
    | "corners" | "edges" | {
    /** Nodes whose rest position in the world lies in the box. */
    readonly box?: {
      /** Least corner [m]. */
      readonly min: ScenePoint;
      /** Greatest corner, nowhere below min [m]. */
      readonly max: ScenePoint;
    } | undefined;
    /** Nodes by index: j * nx + i on a grid, the file's order on a mesh. */
    readonly nodes?: readonly (number)[] | undefined;
    /** Nodes whose rest position in the world is near a point. */
    readonly near?: {
      /** Centre [m]. */
      readonly point: ScenePoint;
      /** Greatest distance from it [m]. */
      readonly radius: number;
    } | undefined;
  } | readonly (SceneSelector)[];
  /** Any length but zero. */
  readonly direction: SceneDirection;
  /** Full speed [m/s]. */
  readonly speed: number;
  /** Where the motion ends; without it there is no end [m]. */
  readonly distance?: number | undefined;
  /** When the motion begins [s]. Default: 0 */
  readonly start?: number | undefined;
  /** Time in which the speed rises from 0, and falls to 0 before the end [s]. Default: 0 */
  readonly ramp?: number | undefined;
} | {
  /** How the nodes move. */
  readonly kind: "path";
  /** The nodes that move: a selector or a list of them. */
  readonly nodes: "top_left" | "top_right" | "bottom_left" | "bottom_right" | "top" | "bottom" | "left" | "right"
    | "corners" | "edges" | {
    /** Nodes whose rest position in the world lies in the box. */
    readonly box?: {
      /** Least corner [m]. */
      readonly min: ScenePoint;
      /** Greatest corner, nowhere below min [m]. */
      readonly max: ScenePoint;
    } | undefined;
    /** Nodes by index: j * nx + i on a grid, the file's order on a mesh. */
    readonly nodes?: readonly (number)[] | undefined;
    /** Nodes whose rest position in the world is near a point. */
    readonly near?: {
      /** Centre [m]. */
      readonly point: ScenePoint;
      /** Greatest distance from it [m]. */
      readonly radius: number;
    } | undefined;
  } | readonly (SceneSelector)[];
  /** [time in s, [x, y, z] in m from the rest position], times rising; straight between. */
  readonly points: readonly (readonly [number, ScenePoint])[];
} | {
  /** How the nodes move. */
  readonly kind: "rotation";
  /** The nodes that move: a selector or a list of them. */
  readonly nodes: "top_left" | "top_right" | "bottom_left" | "bottom_right" | "top" | "bottom" | "left" | "right"
    | "corners" | "edges" | {
    /** Nodes whose rest position in the world lies in the box. */
    readonly box?: {
      /** Least corner [m]. */
      readonly min: ScenePoint;
      /** Greatest corner, nowhere below min [m]. */
      readonly max: ScenePoint;
    } | undefined;
    /** Nodes by index: j * nx + i on a grid, the file's order on a mesh. */
    readonly nodes?: readonly (number)[] | undefined;
    /** Nodes whose rest position in the world is near a point. */
    readonly near?: {
      /** Centre [m]. */
      readonly point: ScenePoint;
      /** Greatest distance from it [m]. */
      readonly radius: number;
    } | undefined;
  } | readonly (SceneSelector)[];
  /** Any length but zero; the rotation is right-handed. */
  readonly axis: SceneDirection;
  /** A point of the axis, in the world [m]. */
  readonly center: ScenePoint;
  /** Full speed [rad/s]. */
  readonly speed: number;
  /** Where the rotation ends; without it there is no end [rad]. */
  readonly angle?: number | undefined;
  /** When the motion begins [s]. Default: 0 */
  readonly start?: number | undefined;
  /** Time in which the speed rises from 0, and falls to 0 before the end [s]. Default: 0 */
  readonly ramp?: number | undefined;
} | {
  /** How the nodes move. */
  readonly kind: "given";
  /** The nodes that move: a selector or a list of them. */
  readonly nodes: "top_left" | "top_right" | "bottom_left" | "bottom_right" | "top" | "bottom" | "left" | "right"
    | "corners" | "edges" | {
    /** Nodes whose rest position in the world lies in the box. */
    readonly box?: {
      /** Least corner [m]. */
      readonly min: ScenePoint;
      /** Greatest corner, nowhere below min [m]. */
      readonly max: ScenePoint;
    } | undefined;
    /** Nodes by index: j * nx + i on a grid, the file's order on a mesh. */
    readonly nodes?: readonly (number)[] | undefined;
    /** Nodes whose rest position in the world is near a point. */
    readonly near?: {
      /** Centre [m]. */
      readonly point: ScenePoint;
      /** Greatest distance from it [m]. */
      readonly radius: number;
    } | undefined;
  } | readonly (SceneSelector)[];
  /** The most that a program may move a node, or a point of a collider, by [m/s]. */
  readonly speed: number;
};

export type SceneAttachment = {
  /** The nodes that go with it: a selector or a list of them. */
  readonly nodes: "top_left" | "top_right" | "bottom_left" | "bottom_right" | "top" | "bottom" | "left" | "right"
    | "corners" | "edges" | {
    /** Nodes whose rest position in the world lies in the box. */
    readonly box?: {
      /** Least corner [m]. */
      readonly min: ScenePoint;
      /** Greatest corner, nowhere below min [m]. */
      readonly max: ScenePoint;
    } | undefined;
    /** Nodes by index: j * nx + i on a grid, the file's order on a mesh. */
    readonly nodes?: readonly (number)[] | undefined;
    /** Nodes whose rest position in the world is near a point. */
    readonly near?: {
      /** Centre [m]. */
      readonly point: ScenePoint;
      /** Greatest distance from it [m]. */
      readonly radius: number;
    } | undefined;
  } | readonly (SceneSelector)[];
  /** Its place in colliders, from 0. */
  readonly collider: number;
  /** How far from its surface a node may be at time 0 [m]. Default: 0.05 */
  readonly reach?: number | undefined;
};

export type SceneGrab = {
  /** The node that is grabbed: a selector of exactly one free node. */
  readonly node: SceneSelector;
  /** When it is taken [s]. Default: 0 */
  readonly start?: number | undefined;
  /** When it is let go; without it never [s]. */
  readonly end?: number | undefined;
  /** Where it is pulled, times rising; straight between, still before and after. */
  readonly path: readonly ({
    /** When [s]. */
    readonly time: number;
    /** Where, in the world [m]. */
    readonly point: ScenePoint;
  })[];
};

export type SceneLookName = "woven" | "cotton" | "canvas" | "linen" | "denim" | "gabardine" | "silk" | "taffeta"
  | "chiffon" | "wool" | "velvet" | "jersey" | "sweater" | "paper" | "rubber";

export type SceneBody = {
  /** For messages. */
  readonly name?: string | undefined;
  /** Cells along x, y and z, each of five tetrahedra; all blocks together have at most 67108864 nodes. */
  readonly block?: readonly [number, number, number] | undefined;
  /** Lengths of a block's edges [m]. */
  readonly size?: readonly [number, number, number] | undefined;
  /** Path of a tetrahedral mesh relative to the scene: MSH, ELE beside NODE, or VTK. */
  readonly tetrahedra?: string | undefined;
  /** Name of a model, or path of a closed mesh, whose inside is filled. */
  readonly surface?: string | undefined;
  /** Of the lattice that fills a surface: the edge of its cubes, in the world [m]. */
  readonly cell?: number | undefined;
  /** From the block centred on the origin, or the mesh, to the world. Default: {} */
  readonly transform?: SceneTransform | undefined;
  /** Mass per rest volume [kg/m³]. */
  readonly density: number;
  /** What the body resists with. */
  readonly material: SceneMaterial;
  /** With cloth and bodies, and with colliders that give none; only proximity uses it. Default: 0.3 */
  readonly friction?: number | undefined;
  /** Nodes that stay where they are. Default: [] */
  readonly pins?: readonly (SceneSelector)[] | undefined;
  /** Nodes that follow a given motion. Default: [] */
  readonly motions?: readonly (SceneMotion)[] | undefined;
  /** Nodes that go where a collider's surface goes. Default: [] */
  readonly attachments?: readonly (SceneAttachment)[] | undefined;
  /** Nodes that are pulled to a point for a while. Default: [] */
  readonly grabs?: readonly (SceneGrab)[] | undefined;
  /** Red, green and blue. */
  readonly color?: readonly [number, number, number] | undefined;
  /** The same body again and again, each some way further; not with grabs. */
  readonly copies?: {
    /** How often it stands, the first included. */
    readonly count: number;
    /** From each copy to the next [m]. */
    readonly offset: ScenePoint;
  } | undefined;
};

export type SceneMaterial = {
  /** Young's modulus [Pa]. */
  readonly young: number;
  /** Poisson's ratio; of energy "neo_hookean" at least 0.4. Default: 0.45 */
  readonly poisson?: number | undefined;
  /** By the rate of a strain the body resists as by this time's worth of it [s]. Default: 0.001 */
  readonly damping?: number | undefined;
  /** Of a stable neo-Hookean solid, or linear in the frame of the nearest rotation. Default:
   * "neo_hookean" */
  readonly energy?: "neo_hookean" | "corotated" | undefined;
};

export type SceneCollider = {
  /** The shape. */
  readonly kind: "mesh";
  /** Without it the cloth's; only proximity uses it. */
  readonly friction?: number | undefined;
  /** Without it the collider stays; needs proximity. */
  readonly motion?: SceneColliderMotion | undefined;
  /** A mass that cloth and gravity move; spheres, boxes, capsules and convex hulls have one. */
  readonly rigid?: SceneRigid | undefined;
  /** What it looks like it is made of. Default: "plaster" */
  readonly material?: "plaster" | "marble" | "metal" | undefined;
  /** Name of a model, or path of an OBJ, PLY (.ply.gz too), OFF, STL or GLB file relative to the scene. */
  readonly mesh: string;
  /** From the mesh to the world. Default: {} */
  readonly transform?: SceneTransform | undefined;
  /** Shapes that it comes to, times rising; straight between; needs proximity. Default: [] */
  readonly keyframes?: readonly (SceneKeyframe)[] | undefined;
  /** An animation of its GLB file, with the file's skins; needs proximity. */
  readonly animation?: SceneAnimation | undefined;
} | {
  /** The shape. */
  readonly kind: "sphere";
  /** Without it the cloth's; only proximity uses it. */
  readonly friction?: number | undefined;
  /** Without it the collider stays; needs proximity. */
  readonly motion?: SceneColliderMotion | undefined;
  /** A mass that cloth and gravity move; spheres, boxes, capsules and convex hulls have one. */
  readonly rigid?: SceneRigid | undefined;
  /** What it looks like it is made of. Default: "plaster" */
  readonly material?: "plaster" | "marble" | "metal" | undefined;
  /** Centre [m]. */
  readonly center: ScenePoint;
  /** Radius [m]. */
  readonly radius: number;
} | {
  /** The shape. */
  readonly kind: "plane";
  /** Without it the cloth's; only proximity uses it. */
  readonly friction?: number | undefined;
  /** Without it the collider stays; needs proximity. */
  readonly motion?: SceneColliderMotion | undefined;
  /** A mass that cloth and gravity move; spheres, boxes, capsules and convex hulls have one. */
  readonly rigid?: SceneRigid | undefined;
  /** What it looks like it is made of. Default: "plaster" */
  readonly material?: "plaster" | "marble" | "metal" | undefined;
  /** A point of the plane [m]. */
  readonly point: ScenePoint;
  /** Out of the solid side; any length but zero. */
  readonly normal: SceneDirection;
} | {
  /** The shape. */
  readonly kind: "capsule";
  /** Without it the cloth's; only proximity uses it. */
  readonly friction?: number | undefined;
  /** Without it the collider stays; needs proximity. */
  readonly motion?: SceneColliderMotion | undefined;
  /** A mass that cloth and gravity move; spheres, boxes, capsules and convex hulls have one. */
  readonly rigid?: SceneRigid | undefined;
  /** What it looks like it is made of. Default: "plaster" */
  readonly material?: "plaster" | "marble" | "metal" | undefined;
  /** One end of the axis [m]. */
  readonly a: ScenePoint;
  /** The other end, not a itself [m]. */
  readonly b: ScenePoint;
  /** Greatest distance from the axis [m]. */
  readonly radius: number;
} | {
  /** The shape. */
  readonly kind: "box";
  /** Without it the cloth's; only proximity uses it. */
  readonly friction?: number | undefined;
  /** Without it the collider stays; needs proximity. */
  readonly motion?: SceneColliderMotion | undefined;
  /** A mass that cloth and gravity move; spheres, boxes, capsules and convex hulls have one. */
  readonly rigid?: SceneRigid | undefined;
  /** What it looks like it is made of. Default: "plaster" */
  readonly material?: "plaster" | "marble" | "metal" | undefined;
  /** Centre [m]. */
  readonly center: ScenePoint;
  /** Lengths of the edges along x, y and z, before it is rotated [m]. */
  readonly size: readonly [number, number, number];
  /** Unit quaternion [x, y, z, w] (length within 0.001 of 1), about the centre. Default: [0,0,0,1] */
  readonly rotate?: readonly [number, number, number, number] | undefined;
} | {
  /** The shape. */
  readonly kind: "convex";
  /** Without it the cloth's; only proximity uses it. */
  readonly friction?: number | undefined;
  /** Without it the collider stays; needs proximity. */
  readonly motion?: SceneColliderMotion | undefined;
  /** A mass that cloth and gravity move; spheres, boxes, capsules and convex hulls have one. */
  readonly rigid?: SceneRigid | undefined;
  /** What it looks like it is made of. Default: "plaster" */
  readonly material?: "plaster" | "marble" | "metal" | undefined;
  /** Name of a model, or path of a mesh file: the hull is of its vertices. */
  readonly mesh?: string | undefined;
  /** Instead of a mesh, the points that the hull is of; not all in a plane. */
  readonly points?: readonly (ScenePoint)[] | undefined;
  /** From the mesh or the points to the world. Default: {} */
  readonly transform?: SceneTransform | undefined;
};

export type SceneColliderMotion = {
  /** How the collider moves. */
  readonly kind: "line";
  /** Any length but zero. */
  readonly direction: SceneDirection;
  /** Full speed [m/s]. */
  readonly speed: number;
  /** Where the motion ends; without it there is no end [m]. */
  readonly distance?: number | undefined;
  /** When the motion begins [s]. Default: 0 */
  readonly start?: number | undefined;
  /** Time in which the speed rises from 0, and falls to 0 before the end [s]. Default: 0 */
  readonly ramp?: number | undefined;
} | {
  /** How the collider moves. */
  readonly kind: "path";
  /** [time in s, [x, y, z] in m from the rest position], times rising; straight between. */
  readonly points: readonly (readonly [number, ScenePoint])[];
} | {
  /** How the collider moves. */
  readonly kind: "rotation";
  /** Any length but zero; the rotation is right-handed. */
  readonly axis: SceneDirection;
  /** A point of the axis, in the world [m]. */
  readonly center: ScenePoint;
  /** Full speed [rad/s]. */
  readonly speed: number;
  /** Where the rotation ends; without it there is no end [rad]. */
  readonly angle?: number | undefined;
  /** When the motion begins [s]. Default: 0 */
  readonly start?: number | undefined;
  /** Time in which the speed rises from 0, and falls to 0 before the end [s]. Default: 0 */
  readonly ramp?: number | undefined;
} | {
  /** How the collider moves. */
  readonly kind: "given";
  /** The most that a program may move a node, or a point of a collider, by [m/s]. */
  readonly speed: number;
};

export type SceneRigid = {
  /** Mass per volume [kg/m³]. */
  readonly density?: number | undefined;
  /** Of the whole [kg]. */
  readonly mass?: number | undefined;
  /** Of its centre of mass at the start [m/s]. Default: [0,0,0] */
  readonly velocity?: readonly [number, number, number] | undefined;
  /** Angular velocity at the start [rad/s]. Default: [0,0,0] */
  readonly spin?: readonly [number, number, number] | undefined;
};

export type SceneKeyframe = {
  /** When [s]. */
  readonly time: number;
  /** The shape then: the same vertices and triangles elsewhere. */
  readonly mesh: string;
};

export type SceneAnimation = {
  /** Which of the file's animations; without it the first. */
  readonly name?: string | undefined;
  /** Where in it time 0 is [s]. Default: 0 */
  readonly start?: number | undefined;
  /** Its seconds in a second. Default: 1 */
  readonly speed?: number | undefined;
  /** Whether it begins anew at its end; else it stays there. Default: true */
  readonly loop?: boolean | undefined;
  /** Shapes a second that it is taken as; straight between [1/s]. Default: 60 */
  readonly rate?: number | undefined;
};

export type SceneLight = {
  /** Soft boxes in a studio, or a blue sky. Default: "studio" */
  readonly environment?: "studio" | "sky" | undefined;
  /** To the sun or the key light; without it from the camera's left, above. */
  readonly direction?: SceneDirection | undefined;
  /** The angle that it covers: how soft its shadows are [°]. Default: 3 */
  readonly degrees?: number | undefined;
};
