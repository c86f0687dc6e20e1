#!/usr/bin/env python3
"""Works on the lines of a manifest with Ray: each task is one shard of `scenelang batch`.

    python scenelang_ray.py manifest.jsonl -o out --shards 64
    python scenelang_ray.py manifest.jsonl -o s3://bucket/scenes --shards 64 --address auto

It needs Python 3.9, the package ray, and on each machine the program scenelang (--binary says where). With a folder, all
machines have to see it; for anything else (s3://, gs://, …) it needs the package fsspec, and that of the store. Programs
that lines name as files are seen from the folder of the manifest, which then has to be the same on all machines. What is
done already is kept: the same command goes on from there.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import ray


def is_store(output):
    """Whether the output is no folder of a file system."""
    return "://" in output


def opened(output):
    """The store, and where in it."""
    import fsspec

    store, root = fsspec.core.url_to_fs(output)
    if "file" in (store.protocol if isinstance(store.protocol, tuple) else (store.protocol,)):
        store.makedirs(root, exist_ok=True)
    return store, root


def summary_of(index, of):
    """As scenelang calls the summary of a shard."""
    return f"summary-{index:05}-of-{of:05}.json"


def batch(binary, arguments):
    """Runs `scenelang batch`. Exit code 1 says that some lines failed, which the summary has; anything else is ours."""
    ended = subprocess.run([binary, "batch", *arguments], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 1):
        raise RuntimeError(f"scenelang batch ended with {ended.returncode}: {ended.stderr.strip()}")
    return ended.stdout


def shard(binary, manifest, output, index, of, more):
    """One shard into a folder, or into a store by way of a folder of the machine."""
    def work(folder):
        batch(binary, [manifest, "-o", str(folder), "--shard", f"{index}/{of}", *more])
        return json.loads((pathlib.Path(folder) / summary_of(index, of)).read_text())

    if not is_store(output):
        return work(output)
    store, root = opened(output)
    with tempfile.TemporaryDirectory() as folder:
        # What an earlier try has stored is done.
        if store.exists(root):
            for path in store.ls(root, detail=False):
                name = path.rsplit("/", 1)[-1]
                if not name.startswith("summary-"):
                    store.get_file(path, os.path.join(folder, name))
        found = work(folder)
        # The summary last: a shard that has one is complete.
        names = [name for name in sorted(os.listdir(folder)) if not name.startswith((".", "summary-"))]
        for name in [*names, summary_of(index, of)]:
            store.pipe_file(f"{root}/{name}", (pathlib.Path(folder) / name).read_bytes())
        return found


def merge(binary, output):
    """One list of all results."""
    if not is_store(output):
        return batch(binary, ["merge", output])
    store, root = opened(output)
    with tempfile.TemporaryDirectory() as folder:
        for path in store.ls(root, detail=False):
            name = path.rsplit("/", 1)[-1]
            if name.startswith("summary-") or name.endswith(".result.json"):
                store.get_file(path, os.path.join(folder, name))
        said = batch(binary, ["merge", folder])
        for name in ("results.jsonl", "summary.json"):
            store.pipe_file(f"{root}/{name}", (pathlib.Path(folder) / name).read_bytes())
        return said


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("manifest")
    parser.add_argument("-o", "--output", required=True, help="a folder, or a store such as s3://bucket/scenes")
    parser.add_argument("--shards", type=int, default=16, help="into how many tasks the lines are split")
    parser.add_argument("--cpus", type=int, default=1, help="lines at once in each task")
    parser.add_argument("--retries", type=int, default=3, help="how often a task is tried again whose worker died")
    parser.add_argument("--address", help="of a Ray cluster; without it, one is started on this machine")
    parser.add_argument("--binary", default="scenelang")
    parser.add_argument("more", nargs="*", help="options of `scenelang batch`, after --")
    args = parser.parse_args()
    ray.init(address=args.address, log_to_driver=False)
    output = args.output if is_store(args.output) else os.path.abspath(args.output)
    more = ["--jobs", str(args.cpus), *args.more]
    task = ray.remote(num_cpus=args.cpus, max_retries=args.retries, retry_exceptions=True)(shard)
    open_tasks = [
        task.remote(args.binary, os.path.abspath(args.manifest), output, index, args.shards, more)
        for index in range(args.shards)
    ]
    done = lines = failed = 0
    while open_tasks:
        ready, open_tasks = ray.wait(open_tasks)
        for found in ray.get(ready):
            done, lines, failed = done + 1, lines + found["lines"], failed + found["failed"]
        print(f"{done} of {args.shards} shards, {lines} lines, {failed} failed", file=sys.stderr)
    print(merge(args.binary, output), end="")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
