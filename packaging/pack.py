"""Packs binaries that were built for others to install: archives, wheels, npm packages, a Homebrew formula, checksums.

    pack.py archive --binary FILE --target TARGET -o FOLDER   NAME-TARGET.tar.gz (.zip for Windows)
    pack.py wheel --binary FILE --target TARGET -o FOLDER     a wheel for pip with the command line
    pack.py wheel --binary FILE --module FILE …               the same with the Python module, for Python 3.11 and later
    pack.py npm --binary FILE --target TARGET -o FOLDER       the npm package of one platform
    pack.py npm -o FOLDER                                     the npm package that picks it
    pack.py formula --sums SHA256SUMS -o FILE                 a Homebrew formula
    pack.py sums FOLDER                                       FOLDER/SHA256SUMS, of all files in it

`--target local` is the machine that this runs on. The same binary makes the same bytes.
"""

import argparse
import base64
import gzip
import hashlib
import io
import json
import platform
import re
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
TARGETS = {entry["target"]: entry for entry in json.loads((HERE / "targets.json").read_text())}
PACKAGE = tomllib.loads((ROOT / "Cargo.toml").read_text())["workspace"]["package"]
VERSION, REPOSITORY = PACKAGE["version"], PACKAGE["repository"]
ABOUT = "Scenes as programs: check, solve and build 3D scenes from their requirements"
SCOPE = "@scenelang"
# Files have no time of their own, so that the same content is the same archive.
EPOCH = (2020, 1, 1, 0, 0, 0)


def target_of(name):
    """What is known of a target; `local` is this machine."""
    if name != "local":
        if name not in TARGETS:
            sys.exit(f"error: there is no target {name}; there are {', '.join(TARGETS)}, local")
        return TARGETS[name]
    system, machine = platform.system().lower(), platform.machine().lower()
    cpu = {"x86_64": "x64", "amd64": "x64", "aarch64": "arm64", "arm64": "arm64"}.get(machine, machine)
    os = {"windows": "win32"}.get(system, system)
    found = next((t for t in TARGETS.values() if (t["os"], t["cpu"]) == (os, cpu)), None)
    if found is None:
        sys.exit(f"error: nothing is packed for {system} on {machine}")
    # Not static: it is for this machine alone, and pip is told so.
    local = {"target": f"{machine}-unknown-linux-gnu", "wheel": f"linux_{machine}", "module": f"linux_{machine}"}
    return {**found, **local} if os == "linux" else found


def executable(target):
    return "scenelang.exe" if target["os"] == "win32" else "scenelang"


def licences():
    return [(name, (ROOT / name).read_bytes()) for name in ("LICENSE-APACHE", "LICENSE-MIT", "LICENSE-WORDNET")]


def zipped(files):
    """A zip of (name, bytes, mode)."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data, mode in files:
            info = zipfile.ZipInfo(name, EPOCH)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = (0o100000 | mode) << 16
            archive.writestr(info, data)
    return out.getvalue()


def tarred(files):
    """A tar.gz of (name, bytes, mode)."""
    out = io.BytesIO()
    with gzip.GzipFile(fileobj=out, mode="wb", mtime=0, filename="") as packed, tarfile.open(fileobj=packed, mode="w") as tar:
        for name, data, mode in files:
            info = tarfile.TarInfo(name)
            info.size, info.mode = len(data), mode
            tar.addfile(info, io.BytesIO(data))
    return out.getvalue()


def archive(target, binary):
    folder = f"scenelang-{target['target']}"
    files = [(f"{folder}/{executable(target)}", binary, 0o755)]
    files += [(f"{folder}/{name}", data, 0o644) for name, data in licences()]
    files.append((f"{folder}/README.md", (ROOT / "README.md").read_bytes(), 0o644))
    if target["os"] == "win32":
        return f"{folder}.zip", zipped(files)
    return f"{folder}.tar.gz", tarred(files)


def package(target, module):
    """The Python package, with what is compiled of it."""
    source = ROOT / "crates/python/scenelang"
    files = [(f"scenelang/{path.name}", path.read_bytes(), 0o644) for path in sorted(source.iterdir()) if path.is_file()]
    name = "_native.pyd" if target["os"] == "win32" else "_native.abi3.so"
    return [*files, (f"scenelang/{name}", module, 0o755)]


def wheel(target, binary, module=None):
    stem = f"scenelang-{VERSION}"
    # pip takes the one with the module where it can. The other is for older Pythons and other C libraries.
    platforms = target.get("module", target["wheel"]) if module else target["wheel"]
    python, interface, least = ("cp311", "abi3", "3.11") if module else ("py3", "none", "3.9")
    tag = f"{python}-{interface}-{platforms}"
    metadata = f"""\
Metadata-Version: 2.4
Name: scenelang
Version: {VERSION}
Summary: {ABOUT}
License-Expression: {PACKAGE["license"]}
Project-URL: Source, {REPOSITORY}
Requires-Python: >={least}
Description-Content-Type: text/markdown

The command line of [scenelang]({REPOSITORY}) and its Python module: `pip install scenelang`, then `scenelang --help` and
[`import scenelang`]({REPOSITORY}/blob/main/docs/python.md). NumPy is used where it is installed.
"""
    about = "Wheel-Version: 1.0\nGenerator: scenelang packaging\nRoot-Is-Purelib: false\n"
    about += "".join(f"Tag: {python}-{interface}-{part}\n" for part in platforms.split("."))
    files = package(target, module) if module else []
    files.append((f"{stem}.data/scripts/{executable(target)}", binary, 0o755))
    files += [(f"{stem}.dist-info/licenses/{name}", data, 0o644) for name, data in licences()]
    files += [(f"{stem}.dist-info/METADATA", metadata.encode(), 0o644), (f"{stem}.dist-info/WHEEL", about.encode(), 0o644)]
    record = ""
    for name, data, _ in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    record += f"{stem}.dist-info/RECORD,,\n"
    files.append((f"{stem}.dist-info/RECORD", record.encode(), 0o644))
    return f"{stem}-{tag}.whl", zipped(files)


def npm_name(target):
    return f"{SCOPE}/{target['os']}-{target['cpu']}"


def npm_about(name, **more):
    return {
        "name": name,
        "version": VERSION,
        "description": ABOUT,
        "license": "(Apache-2.0 OR MIT)",
        "repository": {"type": "git", "url": f"git+{REPOSITORY}.git"},
        **more,
    }


def npm_packed(about, files):
    text = json.dumps(about, indent=2) + "\n"
    all_files = [("package/package.json", text.encode(), 0o644)]
    all_files += [(f"package/{name}", data, mode) for name, data, mode in files]
    all_files += [(f"package/{name}", data, 0o644) for name, data in licences()]
    stem = about["name"].lstrip("@").replace("/", "-")
    return f"{stem}-{VERSION}.tgz", tarred(all_files)


def npm_platform(target, binary):
    about = npm_about(npm_name(target), os=[target["os"]], cpu=[target["cpu"]], preferUnplugged=True)
    return npm_packed(about, [(f"bin/{executable(target)}", binary, 0o755)])


def npm_main():
    parts = {npm_name(target): VERSION for target in TARGETS.values()}
    about = npm_about("scenelang", bin={"scenelang": "bin/scenelang.js"}, engines={"node": ">=18"}, optionalDependencies=parts)
    return npm_packed(about, [
        ("bin/scenelang.js", (HERE / "npm/scenelang.js").read_bytes(), 0o755),
        ("README.md", (HERE / "npm/README.md").read_bytes(), 0o644),
    ])


def formula(sums):
    """The formula for the archives whose sums these are."""
    known = dict(reversed(line.split(maxsplit=1)) for line in sums.splitlines() if line.strip())
    known = {name.lstrip("*").strip(): digest for name, digest in known.items()}
    blocks = {}
    for target in TARGETS.values():
        if target["os"] == "win32":
            continue
        name = f"scenelang-{target['target']}.tar.gz"
        if name not in known:
            sys.exit(f"error: the sums do not have {name}")
        cpu = "on_arm" if target["cpu"] == "arm64" else "on_intel"
        blocks.setdefault(target["os"], []).append(
            f'    {cpu} do\n      url "{REPOSITORY}/releases/download/v{VERSION}/{name}"\n      sha256 "{known[name]}"\n    end\n'
        )
    system = {"darwin": "on_macos", "linux": "on_linux"}
    body = "\n".join(f"  {system[os]} do\n{''.join(parts)}  end\n" for os, parts in blocks.items())
    return f'''class Scenelang < Formula
  desc "{ABOUT}"
  homepage "{REPOSITORY}"
  version "{VERSION}"
  license any_of: ["Apache-2.0", "MIT"]

{body}
  def install
    bin.install "scenelang"
    generate_completions_from_executable(bin/"scenelang", "completions")
    system bin/"scenelang", "man", "-o", "pages"
    man1.install Dir["pages/*.1"]
  end

  test do
    (testpath/"room.scene").write "object desk;\\ndesk.category <- \\"desk\\";\\n"
    system bin/"scenelang", "check", "room.scene"
  end
end
'''


def sums(folder):
    files = sorted(p for p in folder.iterdir() if p.is_file() and p.name != "SHA256SUMS")
    return "".join(f"{hashlib.sha256(p.read_bytes()).hexdigest()}  {p.name}\n" for p in files)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["archive", "wheel", "npm", "formula", "sums"])
    parser.add_argument("folder", nargs="?", type=Path)
    parser.add_argument("--binary", type=Path)
    parser.add_argument("--module", type=Path)
    parser.add_argument("--target", default="local")
    parser.add_argument("--sums", type=Path)
    parser.add_argument("-o", "--output", type=Path)
    args = parser.parse_args()
    if not re.fullmatch(r"\d+\.\d+\.\d+", VERSION):
        sys.exit(f"error: {VERSION} is no version that all of these know")
    if args.what == "sums":
        (args.folder / "SHA256SUMS").write_text(sums(args.folder))
        return
    if args.what == "formula":
        args.output.write_text(formula(args.sums.read_text()))
        return
    if args.what == "npm" and args.binary is None:
        name, data = npm_main()
    else:
        target, binary = target_of(args.target), args.binary.read_bytes()
        if args.what == "wheel":
            name, data = wheel(target, binary, args.module and args.module.read_bytes())
        else:
            name, data = {"archive": archive, "npm": npm_platform}[args.what](target, binary)
    args.output.mkdir(parents=True, exist_ok=True)
    (args.output / name).write_bytes(data)
    print(args.output / name)


if __name__ == "__main__":
    main()
