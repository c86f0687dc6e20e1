"""Writes the files of this folder, as objathor and Holodeck write theirs: `python make.py` (needs numpy and msgpack).

An asset is a box of 2 by 1 by 0.5 m, turned by 90 degrees when it is loaded. The features are of three models in three
views (CLIP) and by their descriptions (Sentence-BERT).
"""
import gzip
import pickle
from pathlib import Path

import msgpack
import numpy as np

HERE = Path(__file__).parent
CORNERS = [{"x": x, "y": y, "z": z} for x in (-1.0, 1.0) for y in (0.0, 1.0) for z in (-0.25, 0.25)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = [corner for a, b, c, d in FACES for corner in (a, b, c, a, c, d)]
ASSET = {
    "name": "box",
    "vertices": CORNERS,
    "triangles": TRIANGLES,
    "normals": [],
    "uvs": [],
    # The same list twice: a pickle refers to it.
    "colliders": [{"vertices": CORNERS, "triangles": TRIANGLES}],
    "yRotOffset": np.float64(90.0),
    "physicalProperties": {"mass": 12, "drag": None, "large": 1 << 40, "isStatic": False},
}


def numbers(*shape):
    count = int(np.prod(shape))
    return np.cos(np.arange(count, dtype=np.float64) * 1.7 + len(shape)).reshape(shape)


UIDS = ["aa11", "bb22", "cc33"]
CLIP = {"uids": UIDS, "img_features": numbers(3, 3, 8).astype("<f2"), "text_features": numbers(3, 8).astype("<f2")}
SBERT = {"uids": UIDS, "text_features": numbers(3, 6).astype("<f4")}


def main():
    for protocol in (2, 4, 5):
        packed = gzip.compress(pickle.dumps(ASSET, protocol), mtime=0)
        (HERE / f"asset-{protocol}.pkl.gz").write_bytes(packed)
        (HERE / f"clip-{protocol}.pkl").write_bytes(pickle.dumps(CLIP, protocol))
        (HERE / f"sbert-{protocol}.pkl").write_bytes(pickle.dumps(SBERT, protocol))
    plain = {**ASSET, "yRotOffset": 90.0}
    (HERE / "asset.msgpack.gz").write_bytes(gzip.compress(msgpack.packb(plain), mtime=0))


if __name__ == "__main__":
    main()
