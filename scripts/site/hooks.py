"""What mkdocs calls while it builds the site: pages made from the code, and Markdown as GitHub has it.

WEFT in the environment names the program whose help and schema the site shows.
"""

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from generated import files as generated_files
from markdown_of_github import MEDIA, inside, mended, titled
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page


def on_files(files: Files, config: MkDocsConfig) -> Files:
    root = Path(config.config_file_path).parent
    for path in sorted((root / MEDIA).rglob("h100/*.*")):
        files.append(File.generated(config, f"media/{path.relative_to(root / MEDIA)}", abs_src_path=str(path)))
    for path, text in generated_files(root, os.environ["WEFT"]):
        files.append(File.generated(config, path, content=text))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    path = page.file.src_uri
    return mended(titled(inside(markdown, path), path, dict(titles(config.nav))))


def titles(nav: Iterable[Any]) -> Iterator[tuple[str, str]]:
    """Of all pages of the navigation, which is lists of {title: page or list}."""
    for entry in nav:
        for title, there in entry.items():
            if isinstance(there, str):
                yield there, title
            else:
                yield from titles(there)
