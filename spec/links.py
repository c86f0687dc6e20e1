"""What mdBook runs on the chapters: links that work in the repository work in the book as well. Those to other folders of the
repository lead there, and those to a README.md to the index that mdBook makes of it. See `preprocessor` in book.toml."""

import json
import posixpath
import re
import sys

# Not followed by what only a link to the web has.
LINK = re.compile(r"\]\((?!\w+:)([^)#\s]+)((?:#[^)\s]*)?)\)")


def linked(chapter, repository):
    """The text of a chapter with links as the book needs them."""
    folder = posixpath.dirname(posixpath.join("spec/src", chapter["source_path"]))

    def link(found):
        path, heading = found.groups()
        target = posixpath.normpath(posixpath.join(folder, path))
        if not target.startswith("spec/src/"):
            path = f"{repository}/blob/main/{target}"
        elif posixpath.basename(path) == "README.md":
            path = path.removesuffix("README.md") + "index.md"
        return f"]({path}{heading})"

    return LINK.sub(link, chapter["content"])


def walk(items, repository):
    for item in items:
        chapter = item.get("Chapter") if isinstance(item, dict) else None
        if chapter:
            if chapter["source_path"]:
                chapter["content"] = linked(chapter, repository)
            walk(chapter["sub_items"], repository)


def main():
    if sys.argv[1:2] == ["supports"]:
        return
    sys.stdin.reconfigure(encoding="utf-8")
    sys.stdout.reconfigure(encoding="utf-8")
    context, book = json.load(sys.stdin)
    repository = context["config"]["output"]["html"]["git-repository-url"]
    walk(book.get("items") or book.get("sections"), repository)
    json.dump(book, sys.stdout)


if __name__ == "__main__":
    main()
