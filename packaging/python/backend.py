"""Builds the wheel of a checkout for this machine: what pip calls, see PEP 517. It needs Cargo and nothing from a registry of
Python: maturin packs either a module or a binary, and the wheel has both."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "packaging"))
import pack  # noqa: E402


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Compiles command line and module, as `cargo build --release` does, and packs them."""
    subprocess.run(
        ["cargo", "build", "--release", "--locked", "-p", "scenelang-cli", "-p", "scenelang-python"],
        cwd=ROOT,
        check=True,
        # Wherever pip was told to install to, what is built stays in the checkout.
        env={name: value for name, value in os.environ.items() if name != "CARGO_BUILD_TARGET"},
    )
    target = pack.target_of("local")
    built = ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "release"
    module = {"win32": "scenelang_python.dll", "darwin": "libscenelang_python.dylib"}.get(target["os"], "libscenelang_python.so")
    name, data = pack.wheel(target, (built / pack.executable(target)).read_bytes(), (built / module).read_bytes())
    (Path(wheel_directory) / name).write_bytes(data)
    return name


def build_sdist(sdist_directory, config_settings=None):
    """There is none: the crates are not in this folder."""
    raise NotImplementedError("install from a checkout of the whole repository, or a wheel of a release")
