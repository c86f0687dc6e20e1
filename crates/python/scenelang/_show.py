"""How things look in a notebook: the plan beside the list of constraints."""

from html import escape
from typing import Any

#: So many rows are shown; how many there are is said.
ROWS = 200
MARKS = {True: ("holds", "#2e7d32"), False: ("fails", "#c62828"), None: ("cannot be checked", "#6d6d6d")}


def margin(row: dict[str, Any]) -> str:
    """``+0.120 m``; nothing where there is no margin."""
    if row["margin"] is None:
        return ""
    return f"{row['margin']:+.3f} {'°' if row['unit'] == 'deg' else 'm'}"


def report(data: dict[str, Any], plan: str | None) -> str:
    """A report, and the plan of its layout if there is one."""
    worst = sorted(data["constraints"], key=lambda row: (row["satisfied"] is True, row["kind"] == "prefer"))
    body = "".join(_row(row) for row in worst[:ROWS])
    more = len(worst) - ROWS
    note = f"<p>… and {more} more</p>" if more > 0 else ""
    findings = "".join(
        f"<li><code>{escape(found['code'])}</code> {escape(found['message'])}</li>" for found in data["diagnostics"]
    )
    verdict = "all of it holds" if data["ok"] else "not all of it holds"
    table = (
        f"<p><b>{escape(data['file'])}</b>: {verdict}</p>"
        + (f"<ul>{findings}</ul>" if findings else "")
        + '<table style="text-align:left"><thead><tr><th>verdict</th><th>margin</th><th>kind</th><th>constraint</th></tr></thead>'
        + f"<tbody>{body}</tbody></table>{note}"
    )
    if plan is None:
        return f"<div>{table}</div>"
    return (
        '<div style="display:flex;flex-wrap:wrap;gap:1em;align-items:flex-start">'
        f'<div style="flex:1 1 24em;max-width:40em">{_scaled(plan)}</div><div style="flex:1 1 20em">{table}</div></div>'
    )


def _row(row: dict[str, Any]) -> str:
    word, color = MARKS[row["satisfied"]]
    text = " ".join(row["text"].split())
    return (
        f'<tr title="{escape(row["message"])}"><td style="color:{color}">{word}</td><td>{margin(row)}</td>'
        f"<td>{escape(row['kind'])}</td><td><code>{escape(text)}</code></td></tr>"
    )


def _scaled(svg: str) -> str:
    """A drawing that is as wide as its place."""
    start = svg.find("<svg")
    return svg[start:].replace("<svg", '<svg style="width:100%;height:auto"', 1)


def program(name: str, text: str, findings: list[dict[str, Any]]) -> str:
    """A program and what is found in its text."""
    found = "".join(f"<li><code>{escape(f['code'])}</code> {escape(f['message'])}</li>" for f in findings)
    return f"<div><p><b>{escape(name)}</b></p><pre>{escape(text)}</pre>" + (f"<ul>{found}</ul>" if found else "") + "</div>"
