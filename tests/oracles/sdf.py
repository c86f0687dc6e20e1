"""Reads an SDF world: its structure by an XML parser, and by Gazebo's own checker where it is installed.

usage: sdf.py FILE.sdf

Prints one JSON object. Exit 0: sound; 1: findings; 2: not XML.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np


def numbers(element, path, count):
    text = element.findtext(path)
    found = [float(v) for v in text.split()] if text else []
    return found if len(found) == count and np.isfinite(found).all() else None


def structure(root, folder):
    wrong = []
    world = root.find("world")
    if root.tag != "sdf" or not root.get("version") or world is None or not world.get("name"):
        return ["no world"], 0
    names = [e.get("name") for e in world if e.tag in ("model", "light")]
    wrong += [f"the name {n}" for n in names if not re.fullmatch(r"[A-Za-z]\w*", n or "", re.ASCII) or n == "world"]
    wrong += ["names are not unique"] if len(set(names)) != len(names) else []
    for model in world.findall("model"):
        name, links = model.get("name"), model.findall("link")
        if numbers(model, "pose", 6) is None or model.findtext("static") not in ("true", "false") or not links:
            wrong.append(f"{name}: pose, static or link")
        for link in links:
            parts = [e.get("name") for e in link if e.tag in ("collision", "visual")]
            if len(set(parts)) != len(parts) or None in parts:
                wrong.append(f"{name}: names of its parts")
            for part in link.findall("collision") + link.findall("visual"):
                wrong += [f"{name}: {w}" for w in geometry(part, folder)]
            if model.findtext("static") == "false":
                wrong += [f"{name}: {w}" for w in inertia(link)]
    return wrong, len(world.findall("model"))


def geometry(part, folder):
    shape = part.find("geometry")
    kind = list(shape)[0].tag if shape is not None and len(shape) == 1 else None
    if kind == "box":
        size = numbers(shape, "box/size", 3)
        return [] if size and min(size) > 0 else ["a box without a size"]
    if kind == "cylinder":
        size = (numbers(shape, "cylinder/radius", 1) or [0]) + (numbers(shape, "cylinder/length", 1) or [0])
        return [] if min(size) > 0 else ["a cylinder without a size"]
    if kind == "mesh":
        uri = shape.findtext("mesh/uri") or ""
        return [] if os.path.isfile(os.path.join(folder, uri)) else [f"no file {uri!r}"]
    return [f"an unknown geometry {kind}"]


def inertia(link):
    mass = numbers(link, "inertial/mass", 1)
    values = [numbers(link, f"inertial/inertia/{k}", 1) for k in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")]
    if not mass or mass[0] <= 0 or None in values:
        return ["no mass or no inertia"]
    xx, xy, xz, yy, yz, zz = (v[0] for v in values)
    moments = np.sort(np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
    possible = moments[0] > 0 and moments[2] <= (moments[0] + moments[1]) * (1 + 1e-6)
    return [] if possible else [f"moments that no body has: {moments}"]


def main():
    path = sys.argv[1]
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as problem:
        print(f"not XML: {problem}", file=sys.stderr)
        return 2
    wrong, models = structure(root, os.path.dirname(path))
    checker = "none"
    for command in (["gz", "sdf", "-k", path], ["ign", "sdf", "-k", path]):
        if shutil.which(command[0]):
            ended = subprocess.run(command, capture_output=True, text=True)
            checker = command[0]
            said = ended.stdout + ended.stderr
            # "Library error" speaks of the checker's own libraries.
            if ended.returncode or "Valid." not in said or re.search(r"^(\x1b\[\S*m)*(Error|Warning)", said, re.M):
                wrong.append(f"{command[0]}: {said}".strip())
            break
    print(json.dumps({"models": models, "checker": checker, "wrong": wrong}))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
