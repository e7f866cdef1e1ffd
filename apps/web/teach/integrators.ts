// The engine's methods as a book on integrators calls them, where nothing touches.
import type { SceneObject } from "weft-cloth";

export type Integrator = NonNullable<SceneObject["solver"]> & { readonly kind: string };

export const SEMI_IMPLICIT_EULER: Integrator = { kind: "mass_spring" };
/** As the engine has it for cloth. */
export const BDF2: Integrator = { kind: "multigrid" };
/** On a single spring, whatever its sweeps are (docs/solvers). */
export const IMPLICIT_EULER: Integrator = { kind: "vbd" };
