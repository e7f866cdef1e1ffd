"""A table as data, written as Markdown or as HTML."""

import html
import re

NOT_MEASURED = "not measured"
SHORT = 20  # rows: such a table is not divided on paper


class Table:
    """Columns are (title, "left" or "right"); a cell is text, `code` in backticks.

    The last cell of a short row spans the rest.
    """

    def __init__(self, columns, rows):
        self.columns, self.rows = columns, rows

    def markdown(self):
        yield "| " + " | ".join(title for title, _ in self.columns) + " |"
        yield "|" + "|".join("---:" if side == "right" else "---" for _, side in self.columns) + "|"
        for row in self.rows:
            yield "| " + " | ".join(row) + " |" + " |" * (len(self.columns) - len(row))

    def html(self, caption, name):
        """The caption is HTML; `name` makes the ids of the page."""
        short = ' class="short"' if len(self.rows) <= SHORT else ""
        yield (
            f'<div class="scroll" role="group" tabindex="0" aria-labelledby="{name}"><table{short}>'
            f'<caption id="{name}"><span class="words">{caption}</span></caption><thead><tr>'
        )
        yield "".join(f'<th scope="col" class="{side}">{cell_html(title)}</th>' for title, side in self.columns)
        yield "</tr></thead><tbody>"
        for row in self.rows:
            cells = []
            for k, ((_, side), text) in enumerate(zip(self.columns, row)):
                span = len(self.columns) - k if k == len(row) - 1 else 1
                spans = f' colspan="{span}"' if span > 1 else ""
                tag, scope = ("th", ' scope="row"') if k == 0 else ("td", "")
                cells.append(f'<{tag}{scope}{spans} class="{"left" if span > 1 else side}">{cell_html(text)}</{tag}>')
            yield "<tr>" + "".join(cells) + "</tr>"
        yield "</tbody></table></div>"


def cell_html(text):
    return re.sub(r"`([^`]*)`", r"<code>\1</code>", html.escape(text, quote=False))


def left(*titles):
    return [(title, "left") for title in titles]


def right(*titles):
    return [(title, "right") for title in titles]


def built(items, columns):
    """Columns are (title, side, cell of an item, or None where it was not measured).

    A column that no item has is left out; the second result names those.
    """
    texts = [[cell(item) for _, _, cell in columns] for item in items]
    seen = [any(row[k] is not None for row in texts) for k in range(len(columns))]
    table = Table(
        [column[:2] for column, one in zip(columns, seen) if one],
        [[NOT_MEASURED if text is None else text for text, one in zip(row, seen) if one] for row in texts],
    )
    return table, [column[0] for column, one in zip(columns, seen) if not one]
