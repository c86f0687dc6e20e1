"""Reads every format that a scene was written in, and holds the world bounds of its objects against each other.

usage: bounds.py LAYOUT.json FOLDER

FOLDER has what `scenelang export --all-formats` wrote of the layout. Each reader below knows one format, by its own
description, and gives the points of each object in the frame of the layout (left-handed, y up). What is drawn must agree
among the formats that draw (GLB, Unity, USD, OBJ, SDF), the solid among those that collide, and with the layout.
Prints one JSON object. Exit 0: all agree to 0.1 mm; 1: some do not; 2: a file cannot be read.
"""
import copy
import glob
import json
import math
import os
import re
import struct
import sys
import xml.etree.ElementTree as ElementTree

import mujoco
import numpy as np
import yaml
from pxr import Usd, UsdGeom

TOLERANCE = 1e-4
SIDES = 24  # of a cylinder as a solid
ROUND = 0.001  # metres by which a cylinder may exceed its prism; else the prism is what is written
MIRROR = np.diag([-1.0, 1, 1])  # y up, right-handed
SWAP = np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])  # z up, right-handed


def bounds(points):
    return np.array([np.min(points, axis=0), np.max(points, axis=0)])


def corners(size):
    return np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]) * size


def round_points(matrix, at, radius, height, axis):
    """Points that span the bounds of a cylinder about a local axis, in the frame that `matrix` turns to."""
    along = matrix[:, axis]
    reach = np.abs(along) * height / 2 + radius * np.sqrt(np.maximum(0, 1 - along**2))
    return np.array([at - reach, at + reach])


def quaternion(x, y, z, w):
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array({"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
                     "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis], float)


def euler(rot):
    return turn("y", rot[1]) @ turn("z", rot[2]) @ turn("x", rot[0])


# The layout


def read_layout(path):
    with open(path, encoding="utf-8") as file:
        layout = json.load(file)
    found = {}
    for name, thing in layout["objects"].items():
        w, h, d = thing["scale"]
        whole = [{"shape": "box", "pos": [0, h / 2, 0], "size": [w, h, d]}]
        matrix, pos = euler(thing.get("rot", [0, 0, 0])), np.array(thing["pos"], float)
        parts = [part_points(p, matrix, pos) for p in (thing.get("asset") or {}).get("parts") or whole]
        found[name] = np.concatenate(parts)
    return found


def part_points(part, matrix, pos):
    if part["shape"] == "hull":
        return np.array(part["points"]) @ matrix.T + pos
    own, at = matrix @ euler(part.get("rot", [0, 0, 0])), pos + matrix @ np.array(part["pos"], float)
    if part["shape"] == "box":
        return corners(part["size"]) @ own.T + at
    radius, height = part["radius"], part["height"]
    if radius * (1 - math.cos(math.pi / SIDES)) <= ROUND:
        return round_points(own, at, radius, height, 1)
    angles = np.arange(SIDES) * 2 * math.pi / SIDES
    ring = [[radius * math.cos(a), y, radius * math.sin(a)] for a in angles for y in (-height / 2, height / 2)]
    return np.array(ring) @ own.T + at


# GLB


def read_glb(path):
    data = open(path, "rb").read()
    length = struct.unpack_from("<I", data, 12)[0]
    document, binary = json.loads(data[20 : 20 + length]), data[28 + length :]
    found = {}
    for node in document["nodes"]:
        own = node.get("extras", {}).get("scenelang", {})
        if "id" not in own:
            continue
        matrix = quaternion(*node.get("rotation", [0, 0, 0, 1]))
        pos = np.array(node.get("translation", [0, 0, 0]))
        points = []
        for primitive in document["meshes"][node["mesh"]]["primitives"]:
            accessor = document["accessors"][primitive["attributes"]["POSITION"]]
            view = document["bufferViews"][accessor["bufferView"]]
            at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            flat = np.frombuffer(binary, "<f4", accessor["count"] * 3, at)
            points.append(flat.reshape(-1, 3) @ matrix.T + pos)
        found[own["id"]] = np.concatenate(points) @ MIRROR
    return found


# Unity


def obj_points(path):
    """The points of a file, by `o`; points before the first belong to no name."""
    found, name = {}, None
    for line in open(path, encoding="utf-8"):
        word, _, rest = line.rstrip("\n").partition(" ")
        if word == "o":
            name = rest
        elif word == "v":
            found.setdefault(name, []).append([float(v) for v in rest.split()])
    return {name: np.array(points) for name, points in found.items()}


def unity_documents(path):
    """Kind and fields of the documents of a file, by anchor; those that only stand for another are left out."""
    parts = re.split(r"^--- !u!\d+ &(-?\d+)(.*)$", open(path, encoding="utf-8").read(), flags=re.M)
    documents = {}
    for anchor, stripped, text in zip(parts[1::3], parts[2::3], parts[3::3]):
        kinds = ("GameObject", "Transform", "MeshFilter", "MonoBehaviour", "PrefabInstance")
        if not stripped and text.strip().split(":")[0] in kinds:
            (kind, fields), = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)).items()
            documents[int(anchor)] = (kind, fields)
    return documents


def instantiated(prefab, instance):
    """The documents of a prefab with the changes of an instance; what is in lists is not needed."""
    documents = copy.deepcopy(prefab)
    for change in instance["m_Modification"]["m_Modifications"]:
        *keys, last = change["propertyPath"].split(".")
        if "Array" in keys or change["target"]["fileID"] not in documents:
            continue
        fields = documents[change["target"]["fileID"]][1]
        for key in keys:
            fields = fields[key]
        fields[last] = change["value"]
    return documents


def unity_objects(documents, files):
    """The points of each object among some documents."""

    def components(owner):
        return {documents[c["component"]["fileID"]][0]: documents[c["component"]["fileID"]][1]
                for c in owner["m_Component"] if c["component"]["fileID"] in documents}

    def drawn(owner):
        """The points of an object and of its moving parts, in the frame of its parent."""
        own = components(owner)
        place = own["Transform"]
        points = []
        if "MeshFilter" in own:
            points.append(obj_points(files[own["MeshFilter"]["m_Mesh"]["guid"]])[None] @ MIRROR)  # as Unity's importer does
        for child in place["m_Children"]:
            points += drawn(documents[documents[child["fileID"]][1]["m_GameObject"]["fileID"]][1])
        matrix = quaternion(*(place["m_LocalRotation"][k] for k in "xyzw"))
        return [p @ matrix.T + [place["m_LocalPosition"][k] for k in "xyz"] for p in points]

    for kind, fields in documents.values():
        if kind == "MonoBehaviour" and "boundsMin" in fields:
            owner = documents[fields["m_GameObject"]["fileID"]][1]
            yield str(fields["id"]), np.concatenate(drawn(owner))


def read_unity(folder):
    files, prefabs = {}, {}
    for at, _, names in os.walk(folder):
        for name in names:
            if name.endswith((".obj.meta", ".prefab.meta")):
                text = open(os.path.join(at, name), encoding="utf-8").read()
                files[re.search(r"^guid: (\w+)", text, re.M).group(1)] = os.path.join(at, name[: -len(".meta")])
    scenes = os.path.join(folder, "Assets/Scenes")
    scene = next(os.path.join(scenes, n) for n in os.listdir(scenes) if n.endswith(".unity"))
    documents = unity_documents(scene)
    found = dict(unity_objects(documents, files))
    for kind, fields in documents.values():
        if kind == "PrefabInstance":
            guid = fields["m_SourcePrefab"]["guid"]
            if guid not in prefabs:
                prefabs[guid] = unity_documents(files[guid])
            found.update(unity_objects(instantiated(prefabs[guid], fields), files))
    return found


# OBJ


def read_obj(path):
    return {name: points @ MIRROR for name, points in obj_points(path).items()}


# MJCF


def read_mjcf(path, told):
    model = mujoco.MjModel.from_xml_path(path)
    with open(told, encoding="utf-8") as file:
        ids = {name: body["id"] for name, body in json.load(file)["bodies"].items() if body["id"]}
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    found = {}
    for g in range(model.ngeom):
        name = ids.get(model.body(model.geom_bodyid[g]).name)
        if name is None:
            continue
        matrix, at, size = data.geom_xmat[g].reshape(3, 3), data.geom_xpos[g], model.geom_size[g]
        if model.geom_type[g] == mujoco.mjtGeom.mjGEOM_BOX:
            points = corners(2 * size) @ matrix.T + at
        elif model.geom_type[g] == mujoco.mjtGeom.mjGEOM_CYLINDER:
            points = round_points(matrix, at, size[0], 2 * size[1], 2)
        else:
            mesh = model.mesh(model.geom_dataid[g])
            first, count = mesh.vertadr[0], mesh.vertnum[0]
            points = model.mesh_vert[first : first + count] @ matrix.T + at
        found.setdefault(name, []).append(points @ SWAP)
    return {name: np.concatenate(points) for name, points in found.items()}


# USD


def read_usd(path):
    stage = Usd.Stage.Open(path)
    cache, drawn, solid = UsdGeom.XformCache(), {}, {}
    for body in stage.GetPrimAtPath("/World/Objects").GetChildren():
        for prim in Usd.PrimRange(body):
            if not prim.IsA(UsdGeom.Gprim):
                continue
            # Gf multiplies rows.
            world = np.array(cache.GetLocalToWorldTransform(prim))
            matrix, at = world[:3, :3].T, world[3, :3]
            if prim.IsA(UsdGeom.Mesh):
                points = np.array(UsdGeom.Mesh(prim).GetPointsAttr().Get()) @ matrix.T + at
            elif prim.IsA(UsdGeom.Cube):
                points = corners([UsdGeom.Cube(prim).GetSizeAttr().Get()] * 3) @ matrix.T + at
            else:
                own = UsdGeom.Cylinder(prim)
                axis = "XYZ".index(own.GetAxisAttr().Get())
                points = round_points(matrix, at, own.GetRadiusAttr().Get(), own.GetHeightAttr().Get(), axis)
            into = solid if UsdGeom.Imageable(prim).ComputePurpose() == "guide" else drawn
            into.setdefault(body.GetDisplayName(), []).append(points @ MIRROR)
    return tuple({name: np.concatenate(points) for name, points in all.items()} for all in (drawn, solid))


# SDF


def sdf_pose(element):
    values = [float(v) for v in (element.findtext("pose") or "0 0 0 0 0 0").split()]
    roll, pitch, yaw = np.degrees(values[3:])
    return turn("z", yaw) @ turn("y", pitch) @ turn("x", roll), np.array(values[:3])


def read_sdf(path):
    name_of, drawn, solid = "{https://github.com/scenelang/scenelang}id", {}, {}
    for model in ElementTree.parse(path).getroot().find("world").findall("model"):
        matrix, at = sdf_pose(model)
        for part in [part for link in model.findall("link") for part in link]:
            if part.tag not in ("collision", "visual"):
                continue
            own, off = sdf_pose(part)
            own, off = matrix @ own, matrix @ off + at
            shape = part.find("geometry")
            if shape.find("box") is not None:
                points = corners([float(v) for v in shape.findtext("box/size").split()]) @ own.T + off
            elif shape.find("cylinder") is not None:
                radius, length = (float(shape.findtext(f"cylinder/{k}")) for k in ("radius", "length"))
                points = round_points(own, off, radius, length, 2)
            else:
                (points,) = obj_points(os.path.join(os.path.dirname(path), shape.findtext("mesh/uri"))).values()
                points = points @ own.T + off
            into = solid if part.tag == "collision" else drawn
            into.setdefault(model.findtext(name_of), []).append(points @ SWAP)
    return tuple({name: np.concatenate(points) for name, points in all.items()} for all in (drawn, solid))


def compare(what, readings, names, found):
    """The greatest difference among some formats; those that differ are added to `found`."""
    most = 0.0
    (first, wanted), *others = readings.items()
    for label, reading in readings.items():
        found += [f"{what}: {label} lacks {name}" for name in names if name not in reading]
    for label, reading in others:
        for name in names:
            if name in reading and name in wanted:
                apart = float(np.abs(bounds(reading[name]) - bounds(wanted[name])).max())
                most = max(most, apart)
                if not apart <= TOLERANCE:
                    found.append(f"{what}: {name} differs by {apart:.5f} m between {first} and {label}")
    return most


def main():
    layout, folder = sys.argv[1:]

    def one(pattern):
        (path,) = glob.glob(os.path.join(glob.escape(folder), pattern))
        return path

    try:
        told = read_layout(layout)
        usd, usdz, sdf = read_usd(one("*.usda")), read_usd(one("*.usdz")), read_sdf(one("sdf/*.sdf"))
        drawn = {
            "glb": read_glb(one("*.glb")), "unity": read_unity(one("unity")), "usd": usd[0], "usdz": usdz[0],
            "obj": read_obj(one("obj/*.obj")), "sdf": sdf[0],
        }
        mjcf = read_mjcf(one("*.mjcf.xml"), one("*.mjcf.json"))
        solid = {"layout": told, "mjcf": mjcf, "usd": usd[1], "usdz": usdz[1], "sdf": sdf[1]}
    except Exception as problem:  # whatever it is, the verdict is: a file cannot be read
        print(f"cannot read: {type(problem).__name__}: {problem}", file=sys.stderr)
        return 2
    found = []
    most = {what: compare(what, readings, told, found) for what, readings in (("drawn", drawn), ("solid", solid))}
    print(json.dumps({"objects": len(told), "greatest_difference": {k: round(v, 7) for k, v in most.items()}, "found": found}))
    return 1 if found or not told else 0


if __name__ == "__main__":
    sys.exit(main())
