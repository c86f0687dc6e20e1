"""Writes an exported scene again with a library of others, and may move one object.

usage: rewrite.py LIBRARY FILE OUT [NAME DX DY DZ]     exit 0 written, 1 no such object, 2 cannot write

LIBRARY is what reads FILE and writes OUT:
  pyyaml       each scene and prefab of a Unity project, in block style
  unityparser  the scenes of a Unity project, numbers as Python's floats
  trimesh      a GLB file
  usd          a USD layer
  usd-over     a USD layer above FILE that says nothing but the move
The object is moved by metres, along the axes of the file (x of a GLB or USD file is that of a layout, negated).
"""
import os
import re
import shutil
import sys

HEADER = re.compile(r"^(--- !u!\d+ &-?\d+(?: stripped)?)$", re.M)
AXES = "xyz"


def files(project, *ends):
    for folder, _, names in sorted(os.walk(project)):
        yield from (os.path.join(folder, name) for name in sorted(names) if name.endswith(ends))


def parts(text):
    """The head of a Unity file, and the headers and bodies of its documents."""
    head, *rest = HEADER.split(text)
    return head, list(zip(rest[::2], rest[1::2]))


def move_in_scene(documents, name, by):
    """Moves a game object that stands in the scene or is an instance of a prefab."""
    owners = {
        header.split("&")[1]
        for header, document in documents
        if "GameObject" in document and document["GameObject"].get("m_Name") == name
    }
    for _, document in documents:
        transform = document.get("Transform")
        if transform and str(transform.get("m_GameObject", {}).get("fileID")) in owners:
            place = transform["m_LocalPosition"]
            place.update({axis: float(place[axis]) + far for axis, far in zip(AXES, by)})
            return True
        changes = document.get("PrefabInstance", {}).get("m_Modification", {}).get("m_Modifications", [])
        if any(change["propertyPath"] == "m_Name" and change["value"] == name for change in changes):
            for change in changes:
                if change["propertyPath"].startswith("m_LocalPosition."):
                    far = by[AXES.index(change["propertyPath"][-1])]
                    change["value"] = float(change["value"]) + far
            return True
    return False


def pyyaml(source, out, name, by):
    import yaml

    shutil.copytree(source, out)
    found = False
    for path in files(out, ".unity", ".prefab"):
        with open(path, encoding="utf-8") as file:
            head, bodies = parts(file.read())
        documents = [(header, yaml.safe_load(body)) for header, body in bodies]
        if path.endswith(".unity") and name:
            found |= move_in_scene(documents, name, by)
        texts = [f"{h}\n{yaml.safe_dump(d, sort_keys=False, default_flow_style=False)}" for h, d in documents]
        with open(path, "w", encoding="utf-8") as file:
            file.write(head + "".join(texts))
    return found


def unityparser(source, out, name, by):
    from unityparser import UnityDocument

    shutil.copytree(source, out)
    found = False
    for path in files(out, ".unity"):
        scene = UnityDocument.load_yaml(path)
        owners = {e.anchor for e in scene.filter(class_names=("GameObject",)) if getattr(e, "m_Name", None) == name}
        for transform in scene.filter(class_names=("Transform",)):
            owner = getattr(transform, "m_GameObject", {}).get("fileID")
            if name and str(owner) in owners:
                for axis, far in zip(AXES, by):
                    transform.m_LocalPosition[axis] = float(transform.m_LocalPosition[axis]) + far
                found = True
        scene.dump_yaml()
    return found


def trimesh(source, out, name, by):
    import numpy
    import trimesh as library

    scene = library.load(source)
    if name in scene.graph.nodes:
        place, _ = scene.graph[name]
        moved = numpy.array(place)
        moved[:3, 3] += by
        scene.graph.update(name, scene.graph.transforms.parents[name], matrix=moved)
    scene.export(out)
    return name in scene.graph.nodes


def move_prim(stage, name, by):
    from pxr import Gf

    for prim in stage.Traverse():
        own = prim.GetCustomDataByKey("scenelang") or {}
        if name and own.get("id") == name:
            place = prim.GetAttribute("xformOp:translate")
            place.Set(Gf.Vec3d(place.Get()) + Gf.Vec3d(*by))
            return True
    return False


def usd(source, out, name, by):
    from pxr import Usd

    stage = Usd.Stage.Open(source)
    found = move_prim(stage, name, by)
    stage.GetRootLayer().Export(out)
    return found


def usd_over(source, out, name, by):
    from pxr import Sdf, Usd

    layer = Sdf.Layer.CreateNew(out)
    layer.subLayerPaths.append(os.path.relpath(source, os.path.dirname(out) or "."))
    stage = Usd.Stage.Open(layer)
    found = move_prim(stage, name, by)
    layer.Save()
    return found


LIBRARIES = {"pyyaml": pyyaml, "unityparser": unityparser, "trimesh": trimesh, "usd": usd, "usd-over": usd_over}


def main(arguments):
    if len(arguments) not in (3, 7) or arguments[0] not in LIBRARIES:
        sys.exit(__doc__)
    library, source, out = arguments[:3]
    name, by = (arguments[3], [float(far) for far in arguments[4:]]) if len(arguments) == 7 else (None, None)
    try:
        found = LIBRARIES[library](source, out, name, by)
    except ImportError as missing:
        print(f"cannot write: {missing}", file=sys.stderr)
        return 2
    if name and not found:
        print(f"no object `{name}` in {source}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
