"""Follows the steps of the Dockerfile without a container tool, and furnishes a room with what they make: try-image.py FOLDER

FOLDER has the archive that was packed for this machine. What the recipe copies is put into an empty folder, which is then the
whole file system of the program, as it is in a container. A binary that is not static gets the libraries that it is linked
with, since what `./x build` makes without a target is for this machine alone; in a release nothing is added.
"""

import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
CPUS = {"x86_64": "amd64", "aarch64": "arm64", "arm64": "arm64"}


def unpacked(folder, context, where):
    """The context as `.github/workflows/release.yml` lays it out: the binary of the archive below the name of its platform."""
    machine = platform.machine()
    found = sorted(folder.glob(f"scenelang-{machine}-unknown-linux-*.tar.gz"))
    if not found:
        sys.exit(f"error: there is no archive for {machine} in {folder}; pack.py archive makes it")
    to = context / where
    to.mkdir(parents=True)
    with tarfile.open(found[0]) as archive:
        for member in archive.getmembers():
            member.name = member.name.split("/", 1)[1]
            archive.extract(member, to, filter="data")


def instructions():
    """The lines of the recipe: a word and the rest."""
    text = (HERE / "Dockerfile").read_text().replace("\\\n", " ")
    for line in text.splitlines():
        if line.strip() and not line.lstrip().startswith("#"):
            word, _, rest = line.strip().partition(" ")
            yield word.upper(), rest.strip()


def follow(context, root, variables):
    """Does what the recipe says; the working folder and the command that a container starts with."""
    folder, entry = "/", []
    for word, rest in instructions():
        rest = re.sub(r"\$\{(\w+)\}", lambda name: variables[name[1]], rest)
        if word == "FROM":
            if rest != "scratch":
                sys.exit(f"error: FROM {rest}: this script only knows images that begin with nothing")
        elif word == "ARG":
            if rest not in variables:
                sys.exit(f"error: ARG {rest}: nobody gives it a value")
        elif word == "COPY":
            *options, source, target = rest.split()
            made = root / target.lstrip("/")
            made.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(context / source, made)
            for option in options:
                name, _, value = option.partition("=")
                if name != "--chmod":
                    sys.exit(f"error: COPY {option}: this script does not know it")
                made.chmod(int(value, 8))
        elif word == "WORKDIR":
            folder = rest
            (root / rest.lstrip("/")).mkdir(parents=True, exist_ok=True)
        elif word == "ENTRYPOINT":
            entry = json.loads(rest)
        else:
            sys.exit(f"error: {word}: this script does not know it")
    return folder, entry


def libraries(binary):
    """Files that a binary is linked with; none of a static one."""
    told = subprocess.run(["ldd", binary], capture_output=True, text=True).stdout
    return [Path(path) for path in re.findall(r"(/\S+) \(0x", told)]


def into(root, work):
    """The command that takes a folder for the whole file system, or None."""
    enter = ["unshare", f"--root={root}", f"--wd={work}"]
    tried = [enter] if os.geteuid() == 0 else [[*enter, "--map-root-user"], ["sudo", "-n", *enter]]
    for command in tried:
        try:
            # It comes to the program that is not there only if it may change the root.
            ended = subprocess.run([*command, "/nothing"], capture_output=True)
        except FileNotFoundError:
            continue
        if ended.returncode == 127:
            return command
    return None


def main():
    folder = Path(sys.argv[1]).resolve()
    where = f"linux/{CPUS[platform.machine()]}"
    # What was run by sudo made files that only root may remove.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as made:
        context, root = Path(made) / "context", Path(made) / "root"
        root.mkdir()
        unpacked(folder, context, where)
        work, entry = follow(context, root, {"TARGETPLATFORM": where})
        needed = libraries(root / entry[0].lstrip("/"))
        for library in needed:
            to = root / str(library).lstrip("/")
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(library, to)
            to.chmod(0o755)
        command = into(root, work)
        if command is None:
            print("note: nobody here may change the root, so the container's program is not run")
            return
        for arguments in (["synth", "a study with a desk", "-o", "room", "--only", "glb,plan"], ["check", "room/room.glb"]):
            ended = subprocess.run([*command, *entry, *arguments], capture_output=True, text=True, env={})
            if ended.returncode != 0:
                sys.exit(f"error: {' '.join(entry + arguments)}: exit code {ended.returncode}\n{ended.stdout}{ended.stderr}")
        if not (root / work.lstrip("/") / "room/room.glb").is_file():
            sys.exit("error: the program wrote nothing where a container's volume is")
        print(f"the image furnishes a room ({'static' if not needed else 'with the libraries of this machine'})")


if __name__ == "__main__":
    main()
