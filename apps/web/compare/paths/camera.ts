// The scene's camera for what three.js draws, or helps to draw.
import { PerspectiveCamera } from "three";
import type { Sheet } from "../sheet.js";
import { HEIGHT, WIDTH } from "./path.js";

export function cameraOf({ camera }: Sheet): PerspectiveCamera {
  const made = new PerspectiveCamera(camera.fov_degrees, WIDTH / HEIGHT, 1, 5000);
  made.position.set(...camera.eye);
  made.lookAt(...camera.target);
  made.updateMatrixWorld();
  return made;
}
