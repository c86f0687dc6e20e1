"""Validates USD files with all validators of Pixar's own library and, where it can be installed, with NVIDIA's asset validator.

usage: usd.py FILE.usda FILE.usdz …

Also reads back what an engine needs: rigid bodies have a mass and colliders, every body has labels, a file needs no other than
the pictures beside it or in its package, and what has a material with pictures has places on them.
Prints one JSON object a file. Exit 0: no issue; 1: issues; 2: a file cannot be opened.
"""
import json
import logging
import os
import sys

from pxr import Usd, UsdGeom, UsdLux, UsdPhysics, UsdSemantics, UsdShade, UsdUtils, UsdValidation

try:
    from omni.asset_validator import UsdAsciiPerformanceChecker, ValidationEngine
except ImportError:  # it is not there for the latest Python
    ValidationEngine = None


def bodies(stage):
    wrong, loose = [], 0
    for prim in [p for folder in ("Objects", "Building") for p in stage.GetPrimAtPath(f"/World/{folder}").GetChildren()]:
        labels = {name: list(UsdSemantics.LabelsAPI(prim, name).GetLabelsAttr().Get() or []) for name in ("category", "instance")}
        if not all(len(values) == 1 and values[0] for values in labels.values()):
            wrong.append(f"{prim.GetPath()}: labels {labels}")
        colliders = [p for p in Usd.PrimRange(prim) if p.HasAPI(UsdPhysics.CollisionAPI)]
        if prim.HasAPI(UsdPhysics.RigidBodyAPI):
            loose += 1
            mass = UsdPhysics.MassAPI(prim).GetMassAttr().Get()
            if not mass or mass <= 0 or not colliders:
                wrong.append(f"{prim.GetPath()}: mass {mass}, {len(colliders)} colliders")
    return wrong, loose


def pictures(stage, path):
    """Where the pictures of materials are that cannot be found, or are elsewhere; meshes without places on their pictures."""
    own = os.path.abspath(path)
    folder = f"{own}[textures/" if own.endswith(".usdz") else os.path.join(os.path.dirname(own), "textures", "")
    layers, assets, unresolved = UsdUtils.ComputeAllDependencies(path)
    wrong = [f"needs another file: {asset}" for asset in assets if not asset.startswith(folder)]
    if unresolved or len(layers) != 1:
        wrong.append(f"needs other files: {layers} {unresolved}")
    textured = 0
    for mesh in (p for p in stage.TraverseAll() if p.IsA(UsdGeom.Mesh)):
        material = UsdShade.MaterialBindingAPI(mesh).ComputeBoundMaterial()[0]
        shaders = [UsdShade.Shader(p) for p in material.GetPrim().GetChildren()] if material else []
        if not any(s.GetIdAttr().Get() == "UsdUVTexture" for s in shaders):
            continue
        textured += 1
        places = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st")
        if len(places.ComputeFlattened() or []) != len(UsdGeom.Mesh(mesh).GetFaceVertexIndicesAttr().Get()):
            wrong.append(f"{mesh.GetPath()}: places {places.GetInterpolation()}")
    return wrong, textured


def judge(path, context, engine):
    stage = Usd.Stage.Open(path)
    issues = [f"{e.GetName()}: {e.GetMessage()}" for e in context.Validate(stage)]
    if engine:
        issues += [f"{i.rule.__name__ if i.rule else ''}: {i.message} {i.at}" for i in engine.validate(path).issues()]
    wrong, loose = bodies(stage)
    elsewhere, textured = pictures(stage, path)
    wrong += elsewhere
    if UsdGeom.GetStageMetersPerUnit(stage) != 1 or UsdGeom.GetStageUpAxis(stage) != "Y":
        wrong.append("not in metres with y up")
    lights = sum(1 for p in stage.Traverse() if p.HasAPI(UsdLux.LightAPI))
    print(json.dumps({
        "file": path, "prims": sum(1 for _ in stage.Traverse()), "loose": loose, "lights": lights, "textured": textured,
        "issues": issues, "wrong": wrong,
    }))
    return bool(issues or wrong)


def main():
    registry = UsdValidation.ValidationRegistry()
    validators = registry.GetOrLoadAllValidators()
    context = UsdValidation.ValidationContext(validators)
    logging.disable(logging.CRITICAL)
    engine = ValidationEngine(init_rules=True) if ValidationEngine else None
    if engine:
        # It asks for binary files, which cannot be read by people or compared in a repository.
        engine.disable_rule(UsdAsciiPerformanceChecker)
    print(json.dumps({"validators": len(validators)}))
    try:
        found = [judge(path, context, engine) for path in sys.argv[1:]]
    except Exception as problem:  # whatever it is, the verdict is: it cannot be opened
        print(f"cannot open: {type(problem).__name__}: {problem}", file=sys.stderr)
        return 2
    return 1 if any(found) or not found else 0


if __name__ == "__main__":
    sys.exit(main())
