"""What writes Alembic: `python -m weft.exchange.alembic_writer`, with its values as JSON (alembic.py)."""

import contextlib
import importlib
import json
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Error, InputError, LimitError
from .meshes import Part, RunMeshes, Shape


class _Writer:
    """An archive with a mesh for each part, which has a sample for each of the run's meshes."""

    def __init__(self, path: str, name: str, meshes: RunMeshes) -> None:
        self._geometry: Any = importlib.import_module("alembic3d.AbcGeom")
        self._imath: Any = importlib.import_module("imath")
        archive = importlib.import_module("alembic3d.Abc").CreateArchiveWithInfo(path, "weft", f"run {name}")
        times = archive.addTimeSampling(_times(meshes))
        root = self._geometry.OXform(archive.getTop(), name)
        self._parts: list[tuple[Part, Any, NDArray[np.int32], Any]] = []
        for part in meshes.parts:
            schema = self._geometry.OPolyMesh(root, part.name.replace("/", "_")).getSchema()
            schema.setTimeSampling(times)
            # Clockwise, as Alembic has it.
            corners = (meshes.triangles[part.triangles, ::-1] - np.uint32(part.vertices.start)).astype(np.int32)
            texture = None if meshes.texture is None else self._floats("V2fArray", meshes.texture[part.vertices])
            self._parts.append((part, schema, np.ascontiguousarray(corners.reshape(-1)), texture))

    def _floats(self, kind: str, values: NDArray[np.float32]) -> Any:
        return getattr(self._imath, f"{kind}FromBuffer")(np.ascontiguousarray(values))

    def add(self, shape: Shape) -> None:
        scope = self._geometry.GeometryScope.kVertexScope
        for part, schema, corners, texture in self._parts:
            places = self._floats("V3fArray", shape.positions[part.vertices])
            normals = self._geometry.ON3fGeomParamSample(self._floats("V3fArray", shape.normals[part.vertices]), scope)
            if schema.getNumSamples() == 0:
                counts = self._imath.IntArrayFromBuffer(np.full(len(corners) // 3, 3, np.int32))
                indices = self._imath.IntArrayFromBuffer(corners)
                uvs = self._geometry.OV2fGeomParamSample()
                if texture is not None:
                    uvs = self._geometry.OV2fGeomParamSample(texture, scope)
                sample = self._geometry.OPolyMeshSchemaSample(places, indices, counts, uvs, normals)
                self._add_material(schema, part.name, len(corners) // 3)
            else:
                sample = self._geometry.OPolyMeshSchemaSample()
                sample.setPositions(places)
                sample.setNormals(normals)
            schema.set(sample)

    def _add_material(self, schema: Any, name: str, faces: int) -> None:
        """A set of all faces: what programs take for a material's name."""
        all_faces = self._imath.IntArrayFromBuffer(np.arange(faces, dtype=np.int32))
        sample = self._geometry.OFaceSetSchemaSample(all_faces)
        schema.createFaceSet(name.replace("/", "_")).getSchema().set(sample)


def _times(meshes: RunMeshes) -> Any:
    """A frame's number times its length [s]."""
    core: Any = importlib.import_module("alembic3d.AbcCoreAbstract")
    steps = set(np.diff(meshes.frames).tolist())
    start = meshes.frames[0] * meshes.frame_seconds
    if len(steps) <= 1:
        return core.TimeSampling(max(steps, default=1) * meshes.frame_seconds, start)
    times = core.TimeVector()
    times.extend([frame * meshes.frame_seconds for frame in meshes.frames])
    return core.TimeSampling(core.TimeSamplingType(core.AcyclicFlag.kAcyclic), times)


def _write(run: str, path: str, name: str, first: int | None, last: int | None, every: int, progress: bool) -> None:
    with contextlib.closing(RunMeshes(run, first, last, every)) as meshes:
        try:
            writer = _Writer(path, name, meshes)
            for shape in meshes.shapes(progress):
                writer.add(shape)
        except RuntimeError as error:
            said = [line for line in str(error).splitlines() if line.strip()]
            raise Error(f"File {path} cannot be written: {said[-1].rstrip('.') if said else 'unknown'}.") from None


def _main(words: str) -> int:
    try:
        _write(*json.loads(words))
    except KeyboardInterrupt:
        return 130
    except Error as error:
        print(f"weft: {error}")
        return 3 if isinstance(error, InputError) else 4 if isinstance(error, LimitError) else 1
    return 0


if __name__ == "__main__":
    sys.exit(_main(sys.argv[1]))
