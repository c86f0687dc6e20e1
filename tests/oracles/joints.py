"""Reads the joints of a scene from each format that it was written in, and compares them with the layout.

usage: joints.py LAYOUT.json FILE …

Each FILE is in one format, known by its name: MJCF (.xml), USD (.usda, .usdz), SDF (.sdf), URDF (.urdf, one object), GLB (.glb,
with KHR_physics_rigid_bodies) or a Unity project (a folder). Joints are matched by object and part. Each must have the type,
the world direction of the axis, the axis line and the limits that the layout gives it, in the frame of the layout (left-handed,
y up, metres and radians); where a format gives a joint a frame on both of its bodies, these must coincide while it is closed.
Prints one JSON object. Exit 0: all agree to 1e-4; 1: some do not; 2: a file cannot be read.
"""
import json
import os
import re
import struct
import sys
import xml.etree.ElementTree as ElementTree
from typing import NamedTuple

import mujoco
import numpy as np
import yaml
from pxr import Usd, UsdGeom, UsdPhysics

from bounds import MIRROR, SWAP, euler, instantiated, quaternion, sdf_pose, turn

TOLERANCE = 1e-4
UNLIMITED = (-np.inf, np.inf)
SAME = np.eye(3)  # the frame of the layout itself


class Joint(NamedTuple):
    """A joint in the frame of the layout, closed."""

    motion: str  # hinge or slide; anything else is reported
    axis: np.ndarray
    point: np.ndarray  # on the axis
    limits: np.ndarray
    apart: float = 0.0  # difference between its frames on the two bodies


def joint(frame, motion, axis, point, limits, apart=0.0):
    """A joint in another frame, which `frame` mirrors into that of the layout. A reflection reverses the sense of rotation."""
    axis = frame @ np.asarray(axis, float)
    sign = np.linalg.det(frame) if motion == "hinge" else 1
    return Joint(motion, sign * axis / np.linalg.norm(axis), frame @ np.asarray(point, float), np.asarray(limits, float), apart)


def in_radians(motion, limits):
    return np.radians(limits) if motion == "hinge" else np.array(limits, float)


def rigid(matrix, at):
    """A rotation (or any linear map) and a translation as one matrix."""
    whole = np.eye(4)
    whole[:3, :3], whole[:3, 3] = matrix, at
    return whole


def move(matrix, point):
    return matrix[:3, :3] @ np.asarray(point, float) + matrix[:3, 3]


def difference(first, second):
    """The greatest difference of two frames, in metres or of the directions of their axes."""
    units = [m[:3, :3] / np.linalg.norm(m[:3, :3], axis=0) for m in (first, second)]
    return max(float(np.linalg.norm(first[:3, 3] - second[:3, 3])), float(np.abs(units[0] - units[1]).max()))


# The layout


class Layout:
    """The joints of a layout by `object/part`, and the poses of its objects."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            objects = json.load(file)["objects"]
        self.poses, self.parts, self.joints = {}, {}, {}
        for name, thing in objects.items():
            pose = rigid(euler(thing.get("rot", [0, 0, 0])), thing["pos"])
            joints = (thing.get("asset") or {}).get("joints") or []
            self.poses[name], self.parts[name] = pose, [own["name"] for own in joints]
            for own in joints:
                motion = own["motion"]
                axis, point = pose[:3, :3] @ own["axis"], move(pose, own["anchor"])
                self.joints[f"{name}/{own['name']}"] = joint(SAME, motion, axis, point, in_radians(motion, own["limits"]))

    def name(self, owner, written, reserved):
        """`object/part` for a part whose name was written as an identifier; one that is unknown keeps it."""
        taken = {reserved}
        for part in self.parts.get(owner, ()):
            candidate, number = identifier(part), 2
            while candidate.lower() in taken:
                candidate, number = f"{identifier(part)}_{number}", number + 1
            taken.add(candidate.lower())
            if candidate == written:
                return f"{owner}/{part}"
        return f"{owner}/{written}"


def identifier(name):
    plain = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")
    return plain if re.match("[A-Za-z]", plain) else f"n_{plain}".rstrip("_")


# MJCF


def read_mjcf(path, layout):
    model = mujoco.MjModel.from_xml_path(path)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    kinds = {int(mujoco.mjtJoint.mjJNT_HINGE): "hinge", int(mujoco.mjtJoint.mjJNT_SLIDE): "slide"}
    for i in range(model.njnt):
        kind = int(model.jnt_type[i])
        if kind != mujoco.mjtJoint.mjJNT_FREE:
            closed = data.qpos[model.jnt_qposadr[i]]
            limits = model.jnt_range[i] - closed if model.jnt_limited[i] else UNLIMITED
            yield model.joint(i).name, joint(SWAP, kinds.get(kind, "ball"), data.xaxis[i], data.xanchor[i], limits)


# USD


def read_usd(path, layout):
    stage = Usd.Stage.Open(path)
    if UsdGeom.GetStageUpAxis(stage) != "Y" or UsdGeom.GetStageMetersPerUnit(stage) != 1:
        raise ValueError(f"{path}: not in metres with y up")
    cache = UsdGeom.XformCache()

    def frame(body, pos, rot):
        (target,) = body.GetTargets()
        # Gf multiplies rows.
        world = np.array(cache.GetLocalToWorldTransform(stage.GetPrimAtPath(target))).T
        return world @ rigid(quaternion(*rot.Get().GetImaginary(), rot.Get().GetReal()), pos.Get())

    kinds = {"PhysicsRevoluteJoint": ("hinge", UsdPhysics.RevoluteJoint),
             "PhysicsPrismaticJoint": ("slide", UsdPhysics.PrismaticJoint)}
    for prim in stage.Traverse():
        if not prim.IsA(UsdPhysics.Joint) or prim.IsA(UsdPhysics.FixedJoint):
            continue
        if prim.GetTypeName() not in kinds:
            raise ValueError(f"{prim.GetPath()}: a {prim.GetTypeName()} is not supported")
        motion, kind = kinds[prim.GetTypeName()]
        own = kind(prim)
        limits = in_radians(motion, [own.GetLowerLimitAttr().Get(), own.GetUpperLimitAttr().Get()])
        fixed = frame(own.GetBody0Rel(), own.GetLocalPos0Attr(), own.GetLocalRot0Attr())
        moving = frame(own.GetBody1Rel(), own.GetLocalPos1Attr(), own.GetLocalRot1Attr())
        piece = stage.GetPrimAtPath(own.GetBody1Rel().GetTargets()[0])
        thing = piece.GetParent()
        name = layout.name(thing.GetDisplayName() or thing.GetName(), piece.GetName(), "base")
        axis = fixed[:3, "XYZ".index(own.GetAxisAttr().Get())]
        yield name, joint(MIRROR, motion, axis, fixed[:3, 3], limits, difference(fixed, moving))


# SDF and URDF

XML_MOTIONS = {"revolute": "hinge", "continuous": "hinge", "prismatic": "slide"}


def read_sdf(path, layout):
    root = ElementTree.parse(path).getroot()
    version = [int(number) for number in root.get("version").split(".")]
    unusual = [e.tag for e in root.iter() if {"relative_to", "expressed_in", "degrees", "rotation_format"} & set(e.attrib)]
    # Before 1.7 poses and axes could be in other frames.
    if version < [1, 7] or unusual:
        raise ValueError(f"{path}: version {version} or frames of {unusual} are not supported")
    for model in root.iter("model"):
        owner = model.findtext("{https://github.com/scenelang/scenelang}id") or model.get("name")
        links = {link.get("name"): rigid(*sdf_pose(model)) @ rigid(*sdf_pose(link)) for link in model.findall("link")}
        for own in model.findall("joint"):
            if own.get("type") == "fixed":
                continue
            child = own.findtext("child")
            frame = links[child] @ rigid(*sdf_pose(own))
            axis = frame[:3, :3] @ [float(v) for v in own.findtext("axis/xyz").split()]
            limits = [float(own.findtext(f"axis/limit/{k}", str(v))) for k, v in zip(("lower", "upper"), UNLIMITED)]
            motion = XML_MOTIONS.get(own.get("type"), own.get("type"))
            yield layout.name(owner, child, "link"), joint(SWAP, motion, axis, frame[:3, 3], limits)


def urdf_object(path, layout):
    name = ElementTree.parse(path).getroot().get("name")
    (owner,) = [owner for owner in layout.parts if identifier(owner) == name]
    return owner


def read_urdf(path, layout):
    root, owner = ElementTree.parse(path).getroot(), urdf_object(path, layout)
    joints = {own.find("child").get("link"): own for own in root.findall("joint")}

    def origin(own):
        found = {} if own.find("origin") is None else own.find("origin").attrib
        place, rpy = ([float(v) for v in found.get(k, "0 0 0").split()] for k in ("xyz", "rpy"))
        roll, pitch, yaw = np.degrees(rpy)
        return rigid(turn("z", yaw) @ turn("y", pitch) @ turn("x", roll), place)

    def frame(link):
        own = joints.get(link)
        return np.eye(4) if own is None else frame(own.find("parent").get("link")) @ origin(own)

    # A robot is in the frame of its object, which stands at its pose in the layout.
    pose = layout.poses[owner]
    for child, own in joints.items():
        if own.get("type") == "fixed":
            continue
        axis = frame(child)[:3, :3] @ [float(v) for v in own.find("axis").get("xyz").split()]
        limits = [float(own.find("limit").get(k)) for k in ("lower", "upper")] if own.get("type") != "continuous" else UNLIMITED
        local = joint(SWAP, XML_MOTIONS.get(own.get("type"), own.get("type")), axis, frame(child)[:3, 3], limits)
        world = local._replace(axis=pose[:3, :3] @ local.axis, point=move(pose, local.point))
        yield layout.name(owner, child, "base_link"), world


# GLB


def read_glb(path, layout):
    with open(path, "rb") as file:
        data = file.read()
    document = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])
    nodes = document["nodes"]
    parents = {child: i for i, node in enumerate(nodes) for child in node.get("children", ())}
    bodies = [node.get("extensions", {}).get("KHR_physics_rigid_bodies", {}) for node in nodes]

    def frame(i):
        if "matrix" in nodes[i]:
            local = np.array(nodes[i]["matrix"]).reshape(4, 4).T
        else:
            turned = quaternion(*nodes[i].get("rotation", [0, 0, 0, 1])) * nodes[i].get("scale", [1, 1, 1])
            local = rigid(turned, nodes[i].get("translation", [0, 0, 0]))
        return frame(parents[i]) @ local if i in parents else local

    for i, body in enumerate(bodies):
        if "joint" not in body:
            continue
        own = body["joint"]
        described = document["extensions"]["KHR_physics_rigid_bodies"]["physicsJoints"][own["joint"]]
        motion, axis, limits = one_freedom(described["limits"])
        piece = own["connectedNode"]
        while "motion" not in bodies[piece] and piece in parents:
            piece = parents[piece]
        extras = nodes[piece].get("extras", {}).get("scenelang", {})
        name = f"{extras['of']}/{extras['joint']}" if "joint" in extras else nodes[piece].get("name", str(piece))
        # Limits are those of the connected node, which moves, in the frame of the node with the joint.
        fixed, moving = frame(i), frame(own["connectedNode"])
        yield name, joint(MIRROR, motion, fixed[:3, axis], fixed[:3, 3], limits, difference(fixed, moving))


def one_freedom(limits):
    """Type, axis and limits of a joint of which just one axis is free."""
    ranges = {(motion, axis): UNLIMITED for motion in ("hinge", "slide") for axis in range(3)}
    for limit in limits:
        motion = "hinge" if "angularAxes" in limit else "slide"
        for axis in limit.get("angularAxes") or limit["linearAxes"]:
            if ranges[motion, axis] != UNLIMITED:
                raise ValueError(f"more than one limit of an axis: {limits}")
            ranges[motion, axis] = (limit.get("min", -np.inf), limit.get("max", np.inf))
    free = [(*key, range) for key, range in ranges.items() if range != (0, 0)]
    return free[0] if len(free) == 1 else (f"joint with {len(free)} free axes", 0, UNLIMITED)


# Unity

UNITY_KINDS = ("GameObject", "Transform", "Rigidbody", "HingeJoint", "ConfigurableJoint", "MonoBehaviour", "PrefabInstance")


def unity_documents(path):
    """Kind and fields of the documents of a file, by anchor; those that only stand for another are left out."""
    with open(path, encoding="utf-8") as file:
        parts = re.split(r"^--- !u!\d+ &(-?\d+)(.*)$", file.read(), flags=re.M)
    documents = {}
    for anchor, stripped, text in zip(parts[1::3], parts[2::3], parts[3::3]):
        if not stripped and text.strip().split(":")[0] in UNITY_KINDS:
            ((kind, fields),) = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)).items()
            documents[int(anchor)] = (kind, fields)
    return documents


def xyz(fields):
    return np.array([fields[k] for k in "xyz"], float)


def unity_frame(documents, at, above):
    """The world frame of a transform, or of what all of these documents are below."""
    if not at:
        return above
    fields = documents[at][1]
    turned = quaternion(*(float(fields["m_LocalRotation"][k]) for k in "xyzw")) * xyz(fields["m_LocalScale"])
    return unity_frame(documents, fields["m_Father"]["fileID"], above) @ rigid(turned, xyz(fields["m_LocalPosition"]))


def unity_joints(documents, above):
    """The joints among some documents: as components, and as the scripts beside these have them."""
    owned = {}
    for anchor, (kind, fields) in documents.items():
        if "m_GameObject" in fields:
            owned.setdefault(fields["m_GameObject"]["fileID"], []).append((anchor, kind, fields))
    transforms = {owner: anchor for owner, all in owned.items() for anchor, kind, _ in all if kind == "Transform"}
    for owner, all in owned.items():
        for _, _, fields in all:
            if "motion" not in fields or "pivot" not in fields:
                continue
            name, frame = str(fields["id"]), unity_frame(documents, transforms[owner], above)
            outer = unity_frame(documents, documents[transforms[owner]][1]["m_Father"]["fileID"], above)
            motion = ("hinge", "slide")[int(fields["motion"])]
            limits = in_radians(motion, [float(fields["min"]), float(fields["max"])])
            axis, pivot = outer[:3, :3] @ xyz(fields["axis"]), move(outer, xyz(fields["pivot"]))
            yield "scripts", name, joint(SAME, motion, axis, pivot, limits)
            for own in [f for _, kind, f in all if kind in ("HingeJoint", "ConfigurableJoint")]:
                body = own["m_ConnectedBody"]["fileID"]
                base = transforms[documents[body][1]["m_GameObject"]["fileID"]] if body else 0
                connected = unity_frame(documents, base, above if body else np.eye(4))
                yield "components", name, unity_component(own, frame, connected)


def unity_component(own, frame, connected):
    axis, point = frame[:3, :3] @ xyz(own["m_Axis"]), move(frame, xyz(own["m_Anchor"]))
    offset = point - move(connected, xyz(own["m_ConnectedAnchor"]))
    if "m_UseLimits" in own:
        reach = 360 if own.get("m_ExtendedLimits") else 177  # Unity cuts off what is beyond
        limits = np.radians(np.clip([own["m_Limits"]["min"], own["m_Limits"]["max"]], -reach, reach))
        return joint(SAME, "hinge", axis, point, limits if own["m_UseLimits"] else UNLIMITED, float(np.linalg.norm(offset)))
    modes = {way: int(own[f"m_{way}Motion"]) for way in ("X", "Y", "Z", "AngularX", "AngularY", "AngularZ")}
    free = [way for way, mode in modes.items() if mode]
    # The limit is how far the anchors may be from each other along the axis, to either side.
    axis = axis / np.linalg.norm(axis)
    along = float(offset @ axis)
    reach = float(own["m_LinearLimit"]["limit"]) if modes["X"] == 1 else np.inf
    apart = float(np.linalg.norm(offset - along * axis))
    motion = "slide" if free == ["X"] else f"joint free in {free}"
    return joint(SAME, motion, axis, point, [-reach - along, reach - along], apart)


def read_unity(folder):
    files, prefabs = {}, {}
    for at, _, names in os.walk(folder):
        for name in (name for name in names if name.endswith(".prefab.meta")):
            with open(os.path.join(at, name), encoding="utf-8") as file:
                files[re.search(r"^guid: (\w+)", file.read(), re.M).group(1)] = os.path.join(at, name[: -len(".meta")])
    scenes = os.path.join(folder, "Assets/Scenes")
    (scene,) = [os.path.join(scenes, name) for name in os.listdir(scenes) if name.endswith(".unity")]
    documents = unity_documents(scene)
    found = list(unity_joints(documents, np.eye(4)))
    for kind, fields in documents.values():
        if kind == "PrefabInstance":
            guid, parent = fields["m_SourcePrefab"]["guid"], fields["m_Modification"]["m_TransformParent"]["fileID"]
            if guid not in prefabs:
                prefabs[guid] = unity_documents(files[guid])
            found += unity_joints(instantiated(prefabs[guid], fields), unity_frame(documents, parent, np.eye(4)))
    return found


READERS = {".xml": read_mjcf, ".usda": read_usd, ".usdz": read_usd, ".sdf": read_sdf, ".urdf": read_urdf, ".glb": read_glb}


def readings(path, layout):
    """Label, names that are expected, and joints; the components and the scripts of a Unity project are two readings."""
    label, expected = os.path.basename(os.path.normpath(path)), list(layout.joints)
    if os.path.isdir(path):
        found = read_unity(path)
        for kind in ("components", "scripts"):
            yield f"{label} ({kind})", expected, [(name, own) for by, name, own in found if by == kind]
        return
    reader = READERS.get(os.path.splitext(path)[1])
    if reader is None:
        raise ValueError(f"{path}: unknown format")
    if reader is read_urdf:
        owner = urdf_object(path, layout)
        expected = [f"{owner}/{part}" for part in layout.parts[owner]]
    yield label, expected, list(reader(path, layout))


def compare(own, wanted):
    """How much a joint differs from that of the layout, by property, and what is wrong with it in words."""
    shown = lambda values: "(" + ", ".join(f"{v:.5g}" for v in values) + ")"
    off, turned = float(np.linalg.norm(np.cross(own.point - wanted.point, wanted.axis))), np.linalg.norm(own.axis - wanted.axis)
    properties = {
        "axis": (float(turned), f"the axis is {shown(own.axis)} instead of {shown(wanted.axis)}"),
        "anchor": (off, f"the anchor is {shown(own.point)}, {off:.5f} m from the axis through {shown(wanted.point)}"),
        "limits": (float(np.abs(own.limits - wanted.limits).max()),
                   f"the limits are {shown(own.limits)} instead of {shown(wanted.limits)}"),
        "frames": (own.apart, f"the frames on its two bodies differ by {own.apart:.5f}"),
    }
    wrong = [f"it is a {own.motion}, not a {wanted.motion}"] if own.motion != wanted.motion else []
    wrong += [words for much, words in properties.values() if not much <= TOLERANCE]
    return {key: much for key, (much, _) in properties.items()}, wrong


def main():
    if len(sys.argv) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        layout = Layout(sys.argv[1])
        files = [reading for path in sys.argv[2:] for reading in readings(path, layout)]
    except Exception as problem:  # whatever it is, the verdict is: a file cannot be read
        print(f"cannot read: {type(problem).__name__}: {problem}", file=sys.stderr)
        return 2
    found, formats = [], {}
    for label, expected, joints in files:
        names = [name for name, _ in joints]
        found += [f"{label}: lacks {name}" for name in expected if name not in names]
        found += [f"{label}: {name} is not in the layout" for name in names if name not in expected]
        found += [f"{label}: {name} is there {names.count(name)} times" for name in sorted(set(names)) if names.count(name) > 1]
        greatest = dict.fromkeys(("axis", "anchor", "limits", "frames"), 0.0)
        for name, own in joints:
            if name in expected:
                differences, wrong = compare(own, layout.joints[name])
                found += [f"{label}: {name}: {what}" for what in wrong]
                greatest = {key: max(greatest[key], much) for key, much in differences.items()}
        formats[label] = {"joints": len(joints), **{key: round(much, 8) for key, much in greatest.items()}}
    print(json.dumps({"joints": len(layout.joints), "formats": formats, "found": found}))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
