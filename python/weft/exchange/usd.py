"""Universal Scene Description, by usd-core."""

import importlib
import os
import pathlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Error, InputError, LimitError
from .meshes import Part, RunMeshes, Shape
from .whole_file import whole_file

MOST_BYTES_OF_TEXT = 1 << 30  # of places and normals: usd-core holds the text of a .usda file whole
_SAVED_EVERY = 1 << 27  # bytes of them, after which a .usdc file is saved: what is saved is no longer held


def write_usd(meshes: RunMeshes, path: pathlib.Path, ending: str, progress: bool) -> None:
    """Writes an animation, whole or not at all. `ending`: "usda" or "usdc", whatever the file's name ends in.

    Errors: InputError, the name has another ending, or a mesh cannot be read. LimitError, too large for text. Error,
    usd-core is missing, or the place cannot be written.
    """
    pxr = _usd(f"The format {ending}")
    size = 24 * meshes.vertices * len(meshes.frames)
    if ending == "usda" and size > MOST_BYTES_OF_TEXT:
        raise LimitError(
            f"{len(meshes.frames)} meshes of {meshes.vertices} vertices are {size} bytes, more than the limit of "
            f"{MOST_BYTES_OF_TEXT} for usda, which is held whole; usdc is not."
        )
    with whole_file(path, f".{ending}", (".usd",)) as temporary:
        try:
            stage = pxr.Usd.Stage.CreateNew(str(temporary))
        except pxr.Tf.ErrorException:
            raise Error(f"File {path} cannot be written: folder {path.parent} is read-only.") from None
        writer = _Writer(pxr, stage, meshes, path.stem)
        unsaved = 0
        try:
            for shape in meshes.shapes(progress):
                writer.add(shape)
                unsaved += 24 * meshes.vertices
                if ending == "usdc" and unsaved > _SAVED_EVERY:
                    stage.GetRootLayer().Save()
                    unsaved = 0
            stage.GetRootLayer().Save()
        except pxr.Tf.ErrorException as error:
            raise Error(f"File {path} cannot be written: {_reason(error)}.") from None


class _Writer:
    """A stage with a mesh for each part, whose points and normals have a value at each frame."""

    def __init__(self, pxr: Any, stage: Any, meshes: RunMeshes, name: str) -> None:
        self._pxr = pxr
        self._animated = len(meshes.frames) > 1
        pxr.UsdGeom.SetStageMetersPerUnit(stage, 1.0)
        pxr.UsdGeom.SetStageUpAxis(stage, pxr.UsdGeom.Tokens.y)
        if self._animated:
            stage.SetTimeCodesPerSecond(1 / meshes.frame_seconds)
            stage.SetFramesPerSecond(1 / meshes.frame_seconds)
            stage.SetStartTimeCode(meshes.frames[0])
            stage.SetEndTimeCode(meshes.frames[-1])
        root = pxr.UsdGeom.Xform.Define(stage, "/" + pxr.Tf.MakeValidIdentifier(name))
        stage.SetDefaultPrim(root.GetPrim())
        self._materials = pxr.UsdGeom.Scope.Define(stage, root.GetPath().AppendChild("materials")).GetPath()
        self._meshes: list[tuple[Part, Any]] = []
        taken = {"materials"}
        for part in meshes.parts:
            plain = pxr.Tf.MakeValidIdentifier(part.name)
            word, number = plain, 2
            while word in taken:
                word, number = f"{plain}_{number}", number + 1
            taken.add(word)
            mesh = pxr.UsdGeom.Mesh.Define(stage, root.GetPath().AppendChild(word))
            self._describe(mesh, part, meshes)
            self._dress(stage, mesh, part, word)
            self._meshes.append((part, mesh))

    def _describe(self, mesh: Any, part: Part, meshes: RunMeshes) -> None:
        """What does not change."""
        vt = self._pxr.Vt
        triangles = meshes.triangles[part.triangles].astype(np.int32) - np.int32(part.vertices.start)
        mesh.GetPrim().SetDisplayName(part.name)
        mesh.CreateFaceVertexCountsAttr(vt.IntArray.FromNumpy(np.full(len(triangles), 3, np.int32)))
        mesh.CreateFaceVertexIndicesAttr(vt.IntArray.FromNumpy(np.ascontiguousarray(triangles.reshape(-1))))
        mesh.CreateSubdivisionSchemeAttr(self._pxr.UsdGeom.Tokens.none)
        mesh.CreateOrientationAttr(self._pxr.UsdGeom.Tokens.rightHanded)
        mesh.CreateDoubleSidedAttr(True)
        mesh.CreatePointsAttr()
        mesh.CreateNormalsAttr()
        mesh.CreateExtentAttr()
        mesh.SetNormalsInterpolation(self._pxr.UsdGeom.Tokens.vertex)
        if meshes.texture is not None:
            texture = self._pxr.UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
                "st", self._pxr.Sdf.ValueTypeNames.TexCoord2fArray, self._pxr.UsdGeom.Tokens.vertex
            )
            texture.Set(vt.Vec2fArray.FromNumpy(np.ascontiguousarray(meshes.texture[part.vertices])))

    def _dress(self, stage: Any, mesh: Any, part: Part, word: str) -> None:
        """A material of the part's name."""
        shade, sdf = self._pxr.UsdShade, self._pxr.Sdf
        material = shade.Material.Define(stage, self._materials.AppendChild(word))
        material.GetPrim().SetDisplayName(part.name)
        shader = shade.Shader.Define(stage, material.GetPath().AppendChild("surface"))
        shader.CreateIdAttr("UsdPreviewSurface")
        shader.CreateInput("roughness", sdf.ValueTypeNames.Float).Set(1.0)
        if part.color is not None:
            color = self._pxr.Gf.Vec3f(*part.color)
            shader.CreateInput("diffuseColor", sdf.ValueTypeNames.Color3f).Set(color)
            mesh.CreateDisplayColorAttr([color])
        material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
        shade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)

    def add(self, shape: Shape) -> None:
        vt = self._pxr.Vt
        time = self._pxr.Usd.TimeCode(shape.frame) if self._animated else self._pxr.Usd.TimeCode.Default()
        for part, mesh in self._meshes:
            places = np.ascontiguousarray(shape.positions[part.vertices])
            mesh.GetPointsAttr().Set(vt.Vec3fArray.FromNumpy(places), time)
            normals = np.ascontiguousarray(shape.normals[part.vertices])
            mesh.GetNormalsAttr().Set(vt.Vec3fArray.FromNumpy(normals), time)
            corners = np.stack([places.min(axis=0), places.max(axis=0)])
            mesh.GetExtentAttr().Set(vt.Vec3fArray.FromNumpy(corners), time)


def read_usd(
    path: str | os.PathLike[str], prim: str = "/", time: float | None = None
) -> tuple[NDArray[np.float32], NDArray[np.uint32]]:
    """The visible meshes of a USD file as one, in weft's metres and with y up: positions (vertices, 3) [m], triangles.

        weft.World(scene, meshes={"figure": weft.read_usd("figure.usdc", prim="/World/figure")})

    prim   only meshes at this path and below
    time   the time code at which they are read; by default the first that a mesh has

    Instances stand where they stand in the scene; proxies and guides are left out. Polygons become fans; a subdivision
    surface is read as its cage. Errors: InputError, the file cannot be read as USD, there is no such prim, it has no
    mesh, or a mesh is wrong. Error, usd-core is missing.
    """
    pxr = _usd("Reading USD")
    name = os.fspath(path)
    if not pathlib.Path(name).is_file():
        raise InputError(f"File {name} cannot be read: there is no such file.")
    try:
        stage = pxr.Usd.Stage.Open(name)
    except pxr.Tf.ErrorException as error:
        raise InputError(f"File {name} cannot be read as USD: {_reason(error)}.") from None
    if not pxr.Sdf.Path.IsValidPathString(prim)[0] or not stage.GetPrimAtPath(prim):
        raise InputError(f'File {name} has no prim "{prim}".')
    geometry = pxr.UsdGeom
    shown = {geometry.Tokens.default_, geometry.Tokens.render}
    code = pxr.Usd.TimeCode.EarliestTime() if time is None else pxr.Usd.TimeCode(time)
    to_world = geometry.XformCache(code)
    positions: list[NDArray[np.float64]] = []
    triangles: list[NDArray[np.int64]] = []
    vertices = 0
    for one in pxr.Usd.PrimRange(stage.GetPrimAtPath(prim), pxr.Usd.TraverseInstanceProxies()):
        mesh = geometry.Mesh(one)
        if not mesh or mesh.ComputePurpose() not in shown:
            continue
        if mesh.ComputeVisibility(code) == geometry.Tokens.invisible:
            continue
        matrix = np.array(to_world.GetLocalToWorldTransform(one), np.float64)
        points, corners = _mesh(mesh, code, name)
        if (np.linalg.det(matrix[:3, :3]) < 0) != (mesh.GetOrientationAttr().Get() == geometry.Tokens.leftHanded):
            corners = corners[:, ::-1]
        positions.append(points @ matrix[:3, :3] + matrix[3, :3])
        triangles.append(corners + vertices)
        vertices += len(points)
    if not triangles or not sum(map(len, triangles)):
        raise InputError(f'File {name} has no visible mesh at or below "{prim}".')
    places = np.concatenate(positions) * geometry.GetStageMetersPerUnit(stage)
    if geometry.GetStageUpAxis(stage) == geometry.Tokens.z:
        places = np.stack([places[:, 0], places[:, 2], -places[:, 1]], axis=1)
    if not np.isfinite(places.astype(np.float32)).all():
        raise InputError(f"File {name} has a place that is not finite in single precision.")
    return places.astype(np.float32), np.concatenate(triangles).astype(np.uint32)


def _mesh(mesh: Any, code: Any, name: str) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Its own points, and its polygons as fans, without those that are holes."""
    counts, corners, holes = (
        np.array(attribute.Get(code) or [], np.int64)
        for attribute in (mesh.GetFaceVertexCountsAttr(), mesh.GetFaceVertexIndicesAttr(), mesh.GetHoleIndicesAttr())
    )
    points = np.array(mesh.GetPointsAttr().Get(code) or [], np.float64).reshape(-1, 3)
    where = f"File {name}, mesh {mesh.GetPath()}:"
    if (counts < 3).any():
        raise InputError(f"{where} a face has {counts[counts < 3][0]} corners, fewer than 3.")
    if counts.sum() != len(corners):
        raise InputError(f"{where} its faces have {counts.sum()} corners, but {len(corners)} are listed.")
    wrong = corners[(corners < 0) | (corners >= len(points))]
    if len(wrong):
        raise InputError(f"{where} a face names point {wrong[0]}, but there are {len(points)}, from 0.")
    first = np.cumsum(counts) - counts
    face = np.repeat(np.arange(len(counts)), counts - 2)
    face = face[~np.isin(face, holes)]
    step = np.arange(len(face)) - np.searchsorted(face, face)  # the triangle's number in its fan
    fans = np.stack([first[face], first[face] + step + 1, first[face] + step + 2], axis=1)
    return points, corners[fans].reshape(-1, 3)


def _usd(what: str) -> Any:
    try:
        for module in ("Gf", "Sdf", "Tf", "Usd", "UsdGeom", "UsdShade", "Vt"):
            importlib.import_module(f"pxr.{module}")
        return importlib.import_module("pxr")
    except ImportError:
        raise Error(f"{what} needs usd-core: pip install 'weft[usd]'.") from None


def _reason(error: Exception) -> str:
    """The last of what usd-core says, without where in its source it says it."""
    lines = [line.strip() for line in str(error).strip().splitlines() if line.strip()]
    return lines[-1].rpartition(" : '")[2].rstrip("'. ") if lines else "unknown"
