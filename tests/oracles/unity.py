"""Judges a Unity project folder without Unity: is every link in it whole?

usage: unity.py PROJECT      exit 0 sound, 1 findings, 2 cannot judge

1. Files: what every project has; each asset and folder with its .meta, none without; GUIDs well-formed and unique.
2. Links: in each scene, material and prefab, anchors are unique; a reference within the file meets a document, one to
   another file meets a known GUID and the id that kind of file has; game objects and components, parents and
   children name each other; SceneRoots lists the transforms without parent; rotations are unit quaternions.
3. Prefabs: each has one root; an instance says what is different of objects and fields that its prefab has; its transform
   is listed by its parent; what stands for an object of an instance (`stripped`) is of the same class as that one.
4. Text: unityparser reads the file and writes back the same bytes.
"""
import os
import re
import sys
import tempfile
from collections import Counter

REQUIRED = ["Assets", "Packages/manifest.json", "ProjectSettings/ProjectVersion.txt"]
YAML = (".unity", ".mat", ".prefab", ".asset")
BUILT_IN = re.compile(r"0000000000000000[def]000000000000000")
# The id Unity gives the one mesh of an OBJ file without groups, the file's root object, and so on by kind of file.
OBJ_MESH = -2432090755550338912
MAIN_ID = {".cs": {11500000}, ".mat": {2100000}, ".obj": {OBJ_MESH}, ".txt": {4900000}, ".json": {4900000}}
GAME_OBJECT, TRANSFORM, PREFAB_INSTANCE, SCENE_ROOTS = 1, 4, 1001, 1660057539
WHOLE_PREFAB = 100100000

HEADER = re.compile(r"--- !u!(\d+) &(-?\d+)( stripped)?$")
REFERENCE = re.compile(r"\{fileID: (-?\d+)(?:, guid: ([0-9a-fA-F]+), type: \d+)?\}")


class Document:
    """One object of a Unity file: its class, its anchor, its lines."""

    def __init__(self, kind, anchor, stripped):
        self.kind, self.anchor, self.stripped, self.lines = kind, anchor, stripped, []

    def reference(self, name):
        """File id and guid in `name: {fileID: …, guid: …}`; both may be None."""
        for line in self.lines:
            if line.strip().startswith(name + ":"):
                found = REFERENCE.search(line)
                return (int(found[1]), found[2]) if found else (None, None)
        return None, None

    def field(self, name):
        """The file id in `name: {fileID: …}`, or None."""
        return self.reference(name)[0]

    def has(self, name):
        return any(line.startswith(f"  {name}:") for line in self.lines)

    def listed(self, name):
        """The file ids of the list `name:`."""
        out, inside = [], False
        for line in self.lines:
            if line.strip().startswith(name + ":"):
                inside = True
            elif inside and line.lstrip().startswith("- "):
                out += [int(m[1]) for m in REFERENCE.finditer(line)]
            elif inside:
                break
        return out


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        text = file.read()
    documents = []
    for line in text.split("\n"):
        found = HEADER.match(line)
        if found:
            documents.append(Document(int(found[1]), int(found[2]), bool(found[3])))
        elif documents:
            lines = documents[-1].lines
            # A reference that was too long for a line goes on in the next one.
            if lines and re.search(r"\{fileID: [^}]*$", lines[-1]):
                lines[-1] += " " + line.strip()
            else:
                lines.append(line)
    return text, documents


def check_files(project, say):
    """GUID → path of every asset."""
    for name in REQUIRED:
        if not os.path.exists(os.path.join(project, name)):
            say(name, "is missing")
    assets = {}
    for folder, folders, files in os.walk(os.path.join(project, "Assets")):
        for name in folders + [f for f in files if not f.endswith(".meta")]:
            if name + ".meta" not in files:
                say(os.path.join(folder, name), "has no .meta")
        for name in (f for f in files if f.endswith(".meta")):
            path = os.path.join(folder, name)
            if not os.path.exists(path[:-5]):
                say(path, "belongs to nothing")
                continue
            with open(path, encoding="utf-8") as file:
                found = re.search(r"^guid: (.*)$", file.read(), re.M)
            guid = found[1].strip() if found else ""
            if not re.fullmatch(r"[0-9a-f]{32}", guid):
                say(path, f"has the malformed guid '{guid}'")
            elif guid in assets:
                say(path, f"has the guid of {assets[guid]}")
            else:
                assets[guid] = path[:-5]
    return assets


def check_references(path, documents, assets, say):
    anchors = {d.anchor for d in documents}
    for document in documents:
        for line in document.lines:
            for target, guid in REFERENCE.findall(line):
                target = int(target)
                if not guid:
                    if target and target not in anchors:
                        say(path, f"&{document.anchor} refers to {target}, which is not in the file")
                elif BUILT_IN.fullmatch(guid):
                    continue
                elif guid not in assets:
                    say(path, f"&{document.anchor} refers to the unknown guid {guid}")
                else:
                    # Of prefabs, see below.
                    wanted = MAIN_ID.get(os.path.splitext(assets[guid])[1].lower())
                    if wanted is not None and target not in wanted:
                        say(path, f"&{document.anchor} asks {assets[guid]} for {target}; it has {sorted(wanted)}")


def parent_of(transform, by_anchor):
    """The file id of the transform that one is below, or None: that of an instance says its instance."""
    if not transform.stripped:
        return transform.field("m_Father")
    instance = by_anchor.get(transform.field("m_PrefabInstance"))
    return instance.field("m_TransformParent") if instance else None


def changes(instance):
    """Target, its guid, path and value of each change of an instance."""
    out = []
    for line in instance.lines:
        key, _, value = line.strip().removeprefix("- ").partition(":")
        if key == "target":
            found = REFERENCE.search(value)
            out.append([int(found[1]), found[2], None, None])
        elif key == "propertyPath":
            out[-1][2] = value.strip().strip("'\"")
        elif key == "value":
            out[-1][3] = value.strip()
    return out


def check_prefab(path, documents, say):
    roots = [d for d in documents if d.kind == TRANSFORM and not d.stripped and not d.field("m_Father")]
    if len(roots) != 1:
        say(path, f"has {len(roots)} roots")
    if any(d.kind == SCENE_ROOTS for d in documents):
        say(path, "is no scene, and has SceneRoots")


def check_instance(path, instance, documents, prefabs, say):
    who = f"the instance &{instance.anchor}"
    source, guid = instance.reference("m_SourcePrefab")
    if source != WHOLE_PREFAB or guid not in prefabs:
        return say(path, f"{who} is of no prefab")
    prefab = {d.anchor: d for d in prefabs[guid]}
    told, turned, sizes = set(), {}, {}
    for target, of, name, value in changes(instance):
        if of != guid or target not in prefab:
            say(path, f"{who} changes {target}, which its prefab does not have")
            continue
        if (target, name) in told:
            say(path, f"{who} changes {name} of {target} twice")
        told.add((target, name))
        field, _, rest = name.partition(".")
        if not prefab[target].has(field):
            say(path, f"{who} changes {name}, which {target} does not have")
        if field == "m_LocalRotation":
            turned.setdefault(target, []).append(float(value))
        if rest == "Array.size":
            sizes[target, field] = int(value)
        entry = re.fullmatch(r"Array\.data\[(\d+)\]", rest)
        if entry and int(entry[1]) >= sizes.get((target, field), 0):
            say(path, f"{who} changes {name}, which is beyond the end of the list")
    for target, numbers in turned.items():
        if len(numbers) != 4 or abs(sum(n * n for n in numbers) - 1) > 1e-4:
            say(path, f"{who} has no unit quaternion: {numbers}")
    parent = instance.field("m_TransformParent")
    own = [d for d in documents if d.kind == TRANSFORM and d.stripped and d.field("m_PrefabInstance") == instance.anchor]
    listed = [d.listed("m_Children") for d in documents if d.kind == TRANSFORM and d.anchor == parent]
    if parent and (len(listed) != 1 or len(own) != 1 or own[0].anchor not in listed[0]):
        say(path, f"{who} is not among the children of its parent")


def check_stripped(path, document, by_anchor, prefabs, say):
    who = f"the stripped &{document.anchor}"
    instance = by_anchor.get(document.field("m_PrefabInstance"))
    source, guid = document.reference("m_CorrespondingSourceObject")
    if instance is None or instance.kind != PREFAB_INSTANCE:
        say(path, f"{who} is of no instance")
    elif instance.reference("m_SourcePrefab")[1] != guid:
        say(path, f"{who} is of another prefab than its instance")
    elif not any(d.anchor == source and d.kind == document.kind for d in prefabs.get(guid, [])):
        say(path, f"{who} stands for {source}, which the prefab does not have")


def check_graph(path, documents, prefabs, say):
    by_anchor = {d.anchor: d for d in documents}
    if path.endswith(".prefab"):
        check_prefab(path, documents, say)
    for document in documents:
        if document.kind == PREFAB_INSTANCE:
            check_instance(path, document, documents, prefabs, say)
        if document.stripped:
            check_stripped(path, document, by_anchor, prefabs, say)
            continue
        if document.kind == GAME_OBJECT:
            for component in document.listed("m_Component"):
                if component in by_anchor and by_anchor[component].field("m_GameObject") != document.anchor:
                    say(path, f"component &{component} does not name its game object &{document.anchor}")
        owner = by_anchor.get(document.field("m_GameObject") or 0)
        if owner and document.anchor not in owner.listed("m_Component"):
            say(path, f"game object &{owner.anchor} does not list its component &{document.anchor}")
        if document.kind == TRANSFORM:
            for child in document.listed("m_Children"):
                if child in by_anchor and parent_of(by_anchor[child], by_anchor) != document.anchor:
                    say(path, f"transform &{child} does not name its parent &{document.anchor}")
            parent = by_anchor.get(document.field("m_Father") or 0)
            if parent and document.anchor not in parent.listed("m_Children"):
                say(path, f"transform &{parent.anchor} does not list its child &{document.anchor}")
            turned = next((line for line in document.lines if "m_LocalRotation:" in line), None)
            numbers = re.findall(r"[xyzw]: (-?[\d.eE+-]+)", turned or "")
            if len(numbers) != 4 or abs(sum(float(n) ** 2 for n in numbers) - 1) > 1e-4:
                say(path, f"transform &{document.anchor} has no unit quaternion: {turned}")
        if document.kind == SCENE_ROOTS:
            free = {d.anchor for d in documents if d.kind == TRANSFORM and not parent_of(d, by_anchor)}
            if set(document.listed("m_Roots")) != free:
                say(path, "SceneRoots does not list exactly the transforms without parent")
    if path.endswith(".unity") and not any(d.kind == SCENE_ROOTS for d in documents):
        say(path, "has no SceneRoots")


def check_text(path, text, parser, say):
    if not text.startswith("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"):
        say(path, "does not open with Unity's two header lines")
    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(folder, "copy")
        parser.load_yaml(path).dump_yaml(copy)
        with open(copy, encoding="utf-8", newline="") as file:
            if file.read() != text:
                say(path, "changes when unityparser reads and writes it")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        from unityparser import UnityDocument
    except ImportError as problem:
        print(f"cannot judge: {problem}", file=sys.stderr)
        return 2
    findings = []
    say = lambda path, what: findings.append(f"{path}: {what}")
    assets = check_files(sys.argv[1], say)
    judged = Counter()
    prefabs = {guid: read(path)[1] for guid, path in assets.items() if path.endswith(".prefab")}
    for path in sorted(assets.values()):
        if not path.endswith(YAML):
            continue
        text, documents = read(path)
        judged.update(files=1, documents=len(documents), instances=sum(d.kind == PREFAB_INSTANCE for d in documents))
        for anchor, times in Counter(d.anchor for d in documents).items():
            if times > 1:
                say(path, f"has the anchor &{anchor} {times} times")
        check_references(path, documents, assets, say)
        check_graph(path, documents, prefabs, say)
        check_text(path, text, UnityDocument, say)
    if not judged["files"]:
        say(sys.argv[1], "holds no scene")
    print("\n".join(findings[:50]))
    print(f"{len(assets)} assets, {judged['files']} files, {judged['documents']} documents, "
          f"{judged['instances']} instances of {len(prefabs)} prefabs, {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
