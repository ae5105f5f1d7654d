# SPDX-License-Identifier: BSD-3-Clause
"""Markdown tables, and the generated blocks of the documents that hold them."""
from pathlib import Path


def figure(value, digits=3):
    """A number with that many decimals; "-" for what is not known; yes and no; text as it is."""
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.{digits}f}"
    return str(value)


def markdown(head, rows):
    """A table of cells that are texts or numbers. Raises ValueError where a row is not as long as the head."""
    for row in rows:
        if len(row) != len(head):
            raise ValueError(f"a row has {len(row)} cells, the head {len(head)}: {row}")
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(figure(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def replace_block(text, name, content):
    """`text` with what stands between <!-- NAME --> and <!-- end of NAME --> replaced. Raises ValueError where there are no
    such lines, once and in that order."""
    start, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->"
    if text.count(start) != 1 or text.count(end) != 1 or text.index(start) > text.index(end):
        raise ValueError(f"the document has no block '{name}': it begins with {start.strip()} and ends with {end}")
    before, rest = text.split(start)
    after = rest.split(end)[1]
    return before + start + content.rstrip("\n") + "\n" + end + after


def write_blocks(file, blocks):
    """Replaces the blocks, a dictionary of names and contents, of a document in place."""
    text = Path(file).read_text(encoding="utf-8")
    for name, content in blocks.items():
        text = replace_block(text, name, content)
    Path(file).write_text(text, encoding="utf-8")
