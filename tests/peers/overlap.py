"""All overlapping pairs of boxes, by libraries that others use: shapely's tree of flat footprints, FCL, trimesh.

Reads {"boxes": [{"center", "half", "axes"}, …], "tolerance"} (metres; axes: columns of the rotation), writes
{"peer": {"ms": …, "pairs": …, "note": …}} with the best of some runs. Building is not timed unless the name says so.
"""

import json
import sys
import time

import numpy as np


def best(run, times=7):
    least, found = float("inf"), None
    for _ in range(times):
        start = time.perf_counter()
        found = run()
        least = min(least, time.perf_counter() - start)
    return least * 1e3, found


def shapely_tree(boxes):
    import shapely

    corners = []
    for box in boxes:
        axes, half, center = (np.array(box[k]) for k in ("axes", "half", "center"))
        points = [axes.T @ (half * [i, j, k]) + center for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
        corners.append(shapely.MultiPoint([(p[0], p[2]) for p in points]).convex_hull)
    corners = np.array(corners)

    def run():
        tree = shapely.STRtree(corners)
        left, right = tree.query(corners, predicate="intersects")
        return int((left < right).sum())

    return run


def fcl_manager(boxes):
    import fcl

    objects = []
    for box in boxes:
        half = np.array(box["half"])
        transform = fcl.Transform(np.array(box["axes"]).T, np.array(box["center"]))
        objects.append(fcl.CollisionObject(fcl.Box(*(2 * half)), transform))
    manager = fcl.DynamicAABBTreeCollisionManager()
    manager.registerObjects(objects)
    manager.setup()

    def run():
        data = fcl.CollisionData(request=fcl.CollisionRequest(num_max_contacts=100 * len(boxes)))
        manager.collide(data, fcl.defaultCollisionCallback)
        return len({frozenset((id(c.o1), id(c.o2))) for c in data.result.contacts})

    return run


def trimesh_manager(boxes, build):
    import trimesh

    def made():
        manager = trimesh.collision.CollisionManager()
        for i, box in enumerate(boxes):
            transform = np.eye(4)
            transform[:3, :3] = np.array(box["axes"]).T
            transform[:3, 3] = box["center"]
            manager.add_object(str(i), trimesh.creation.box(2 * np.array(box["half"])), transform)
        return manager

    if build:
        return lambda: len(made().in_collision_internal(return_names=True)[1])
    manager = made()
    return lambda: len(manager.in_collision_internal(return_names=True)[1])


def main():
    boxes = json.load(sys.stdin)["boxes"]
    peers = {
        "shapely STRtree (flat footprints)": lambda: best(shapely_tree(boxes)),
        "python-fcl, query": lambda: best(fcl_manager(boxes)),
        "trimesh, query": lambda: best(trimesh_manager(boxes, False)),
        "trimesh, with building": lambda: best(trimesh_manager(boxes, True), 1),
    }
    out = {}
    for name, run in peers.items():
        try:
            ms, pairs = run()
            out[name] = {"ms": ms, "pairs": pairs}
        except ImportError as error:
            out[name] = {"missing": str(error)}
    json.dump(out, sys.stdout)


main()
