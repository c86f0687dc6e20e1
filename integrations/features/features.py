"""Writes the features that `scenelang synth --assets FOLDER` searches models with.

usage: features.py FOLDER QUERIES.json [--from OBJATHOR]

QUERIES.json is what `scenelang assets queries ROOM.scene … --format json` prints. The result is FOLDER/features, as the page
"Furniture" of the book describes it.
With --from, the vectors of the models are those of objathor: OBJATHOR has clip_features.pkl and sbert_features.pkl. A pickle
can run any program, so use files of people you trust. Without --from, FOLDER/features must have the vectors of the models
already (in these two files or as arrays), and only those of the queries are written anew.
Needs numpy; for the queries also open_clip_torch and sentence-transformers, whose networks must be on this machine. They are
those of objathor: ViT-L-14 (laion2b_s32b_b82k) and all-mpnet-base-v2.
"""
import argparse
import json
import pathlib
import pickle

import numpy as np


def models(objathor, folder):
    """Converts the pickles of objathor; rows of both are brought into the same order."""
    with open(objathor / "clip_features.pkl", "rb") as file:
        clip = pickle.load(file)
    with open(objathor / "sbert_features.pkl", "rb") as file:
        sbert = pickle.load(file)
    at = {name: row for row, name in enumerate(sbert["uids"])}
    both = [(row, name) for row, name in enumerate(clip["uids"]) if name in at]
    images = np.asarray(clip["img_features"])[[row for row, _ in both]]
    texts = np.asarray(sbert["text_features"])[[at[name] for _, name in both]]
    np.save(folder / "clip_models.npy", np.ascontiguousarray(images, "<f2"))
    np.save(folder / "sbert_models.npy", np.ascontiguousarray(texts, "<f4"))
    (folder / "names.json").write_text(json.dumps([name for _, name in both]), encoding="utf-8")
    return len(both)


def queries(texts, folder):
    """The vectors of the queries, from networks that are on this machine."""
    import open_clip
    import sentence_transformers
    import torch

    network, _, _ = open_clip.create_model_and_transforms("ViT-L-14", pretrained="laion2b_s32b_b82k")
    with torch.no_grad():
        clip = network.eval().encode_text(open_clip.get_tokenizer("ViT-L-14")(texts)).numpy()
    sbert = sentence_transformers.SentenceTransformer("all-mpnet-base-v2").encode(texts)
    np.save(folder / "clip_queries.npy", np.ascontiguousarray(clip, "<f4"))
    np.save(folder / "sbert_queries.npy", np.ascontiguousarray(sbert, "<f4"))
    (folder / "queries.json").write_text(json.dumps(texts), encoding="utf-8")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("queries", type=pathlib.Path)
    arguments.add_argument("--from", dest="objathor", type=pathlib.Path)
    given = arguments.parse_args()
    folder = given.folder / "features"
    folder.mkdir(parents=True, exist_ok=True)
    if given.objathor:
        print(f"{models(given.objathor, folder)} models")
    texts = json.loads(given.queries.read_text(encoding="utf-8"))
    queries(texts, folder)
    print(f"{len(texts)} queries")


if __name__ == "__main__":
    main()
