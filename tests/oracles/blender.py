"""Imports GLB and USD files in Blender, and compares the bounds of every object with the layout.

usage: blender.py LAYOUT.json FILE.glb FILE.usda …

Needs the package bpy, which is Blender as a library; without it, nothing is judged. Bounds are those of what is drawn, closed,
in the frame of the object in the layout (left-handed, y up), where they are given by `scale`. Of a GLB file, Blender must also
have as many objects as the scene has nodes, and each must be of its object by its custom properties; USD objects are found by
their names. Prints one JSON object. Exit 0: all agree to 0.1 mm; 1: findings; 2: no Blender, or a file cannot be read.
"""
import contextlib
import json
import math
import os
import re
import struct
import sys

TOLERANCE = 1e-4

try:
    import bpy
    import numpy as np
except ImportError as problem:
    print(f"skipped: Blender is not installed (pip install bpy): {problem}", file=sys.stderr)
    sys.exit(2)

# Blender is right-handed with z up, and looks at the front of a thing along +y: (x, y, z) of the layout is (-x, -z, y) there.
FRAME = np.array([[-1.0, 0, 0], [0, 0, 1], [0, -1, 0]])


@contextlib.contextmanager
def quiet():
    """Importers print to standard output, which is for the verdict."""
    sys.stdout.flush()
    kept = os.dup(1)
    os.dup2(2, 1)
    try:
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array({"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
                     "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis], float)


def identifiers(names):
    """Names in USD: letters, digits and single underscores; a number where two would be the same."""
    found = {}
    for name in names:
        plain = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")
        plain = plain if re.match("[A-Za-z]", plain) else f"n_{plain}".rstrip("_")
        candidate, number = plain, 2
        while candidate.lower() in found:
            candidate, number = f"{plain}_{number}", number + 1
        found[candidate.lower()] = name
    return found


def world_points(thing):
    """The points of a mesh, in the frame of the layout."""
    flat = np.empty(3 * len(thing.data.vertices))
    thing.data.vertices.foreach_get("co", flat)
    world = np.array(thing.matrix_world)
    return (flat.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3]) @ FRAME.T


def ancestors(thing):
    """An object and everything above it."""
    while thing is not None:
        yield thing
        thing = thing.parent


def owner_in_glb(thing):
    """The object of the layout that a mesh is of: a part that opens is below its object."""
    own = [above["scenelang"] for above in ancestors(thing) if "scenelang" in above]
    return next((told["id"] for told in own if "id" in told), None)


def owner_in_usd(thing, names):
    """The same in USD: what is directly below `Objects`. Blender adds a number to a name that it already has."""
    chain = list(ancestors(thing))
    for below, above in zip(chain, chain[1:]):
        if re.sub(r"\.\d{3,}$", "", above.name) == "Objects":
            return names.get(re.sub(r"\.\d{3,}$", "", below.name).lower(), below.name)
    return None


def nodes_of_glb(path):
    """How many nodes the scene of a file has."""
    with open(path, "rb") as file:
        data = file.read()
    document = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])
    below = lambda i: 1 + sum(below(child) for child in document["nodes"][i].get("children", ()))
    return sum(below(i) for i in document["scenes"][document.get("scene", 0)]["nodes"])


def judge(path, layout, found):
    """Imports a file; what it has, and by how much it differs from the layout. What is wrong is added to `found`."""
    label, is_glb = os.path.basename(path), path.endswith(".glb")
    with quiet():
        bpy.ops.wm.read_factory_settings(use_empty=True)
        if is_glb:
            done = bpy.ops.import_scene.gltf(filepath=path)
        else:
            # By default an object of one mesh would get the name of the mesh.
            done = bpy.ops.wm.usd_import(filepath=path, merge_parent_xform=False)
        bpy.context.view_layer.update()
    if done != {"FINISHED"}:
        raise ValueError(f"{path}: Blender could not import it")
    names, points = identifiers(layout), {}
    # Nodes that are in no scene, such as the meshes of colliders, are in a collection that the view layer leaves out.
    things = list(bpy.context.view_layer.objects)
    for thing in (thing for thing in things if thing.type == "MESH"):
        owner = owner_in_glb(thing) if is_glb else owner_in_usd(thing, names)
        if owner is not None:
            points.setdefault(owner, []).append(world_points(thing))
    found += [f"{label}: lacks {name}" for name in layout if name not in points]
    found += [f"{label}: {name} is not in the layout" for name in points if name not in layout]
    nodes = nodes_of_glb(path) if is_glb else None
    if is_glb and nodes != len(things):
        found.append(f"{label}: {nodes} nodes, and {len(things)} objects in Blender")
    most = 0.0
    for name in points.keys() & layout.keys():
        thing = layout[name]
        x, y, z = thing.get("rot", [0, 0, 0])
        local = (np.concatenate(points[name]) - thing["pos"]) @ (turn("y", y) @ turn("z", z) @ turn("x", x))
        w, h, d = thing["scale"]
        wanted = np.array([[-w / 2, 0, -d / 2], [w / 2, h, d / 2]])
        apart = float(np.abs([local.min(axis=0), local.max(axis=0)] - wanted).max())
        most = max(most, apart)
        if not apart <= TOLERANCE:
            found.append(f"{label}: the bounds of {name} differ by {apart:.5f} m")
    meshes = sum(thing.type == "MESH" for thing in things)
    counts = {"nodes": nodes, "imported": len(things), "meshes": meshes, "objects": len(points)}
    return {**counts, "greatest_difference": round(most, 7)}


def main():
    if len(sys.argv) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    found = []
    try:
        with open(sys.argv[1], encoding="utf-8") as file:
            layout = json.load(file)["objects"]
        files = {os.path.basename(path): judge(path, layout, found) for path in sys.argv[2:]}
    except Exception as problem:  # whatever it is, the verdict is: a file cannot be read
        print(f"cannot read: {type(problem).__name__}: {problem}", file=sys.stderr)
        return 2
    print(json.dumps({"blender": bpy.app.version_string, "layout": len(layout), "files": files, "found": sorted(found)}))
    return 1 if found or not layout else 0


if __name__ == "__main__":
    sys.exit(main())
