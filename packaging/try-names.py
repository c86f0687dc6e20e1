"""Whoever names the archives of a release by other means than `pack.py` must name them as it does: the Homebrew formula, the
metadata of `cargo binstall`, and the platforms of the npm package. Every archive is packed here, of a binary that is none."""

import hashlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

import pack


def expect(holds, what):
    if not holds:
        sys.exit(f"error: {what}")


def members(archive):
    if archive.suffix == ".zip":
        return zipfile.ZipFile(archive).namelist()
    with tarfile.open(archive) as tar:
        return tar.getnames()


def formula(folder, archives):
    """The formula names archives that are there, by their sums, and Ruby can read it."""
    text = pack.formula(pack.sums(folder))
    named = re.findall(r'url "\S+/(\S+)"\s+sha256 "(\w+)"', text)
    expect({name for name, _ in named} == {a.name for a in archives if a.suffix != ".zip"}, f"the formula names {named}")
    for name, digest in named:
        expect(hashlib.sha256((folder / name).read_bytes()).hexdigest() == digest, f"the formula has another sum for {name}")
    if shutil.which("ruby"):
        subprocess.run(["ruby", "-c"], input=text, text=True, check=True, stdout=subprocess.DEVNULL)


def binstall(archives):
    """What `cargo binstall` would fetch and take out, for every target, and for those of Linux that are not static."""
    about = tomllib.loads((pack.ROOT / "crates/cli/Cargo.toml").read_text())["package"]["metadata"]["binstall"]
    names = {archive.name: archive for archive in archives}
    static = [target for target in pack.TARGETS if target.endswith("-linux-musl")]
    for target in [*pack.TARGETS, *(target.replace("-musl", "-gnu") for target in static)]:
        said = {**about, **about["overrides"].get(target, {})}
        suffix = ".exe" if "windows" in target else ""
        values = {"repo": pack.REPOSITORY, "version": pack.VERSION, "target": target, "bin": "scenelang", "binary-ext": suffix}
        fill = lambda text: re.sub(r"\{ ([\w-]+) \}", lambda name: values[name[1]], text)
        name = fill(said["pkg-url"]).rsplit("/", 1)[1]
        expect(name in names, f"cargo binstall asks for {name}, which is not packed")
        expect(said["pkg-fmt"] == {".gz": "tgz", ".zip": "zip"}[names[name].suffix], f"cargo binstall takes {name} for a {said['pkg-fmt']}")
        expect(fill(said["bin-dir"]) in members(names[name]), f"{name} has no {fill(said['bin-dir'])}")


def main():
    with tempfile.TemporaryDirectory() as made:
        folder, archives = Path(made), []
        for target in pack.TARGETS.values():
            name, data = pack.archive(target, target["target"].encode())
            (folder / name).write_bytes(data)
            archives.append(folder / name)
        formula(folder, archives)
        binstall(archives)
    print(f"the formula and cargo binstall name the {len(archives)} archives as they are packed")


if __name__ == "__main__":
    main()
