"""The site that ./dev docs builds: links lead somewhere, no page asks another server, a search finds answers."""

import functools
import html.parser
import http.server
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest
import urllib.parse
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parents[2]
FETCHED = {"script": "src", "img": "src", "video": "src", "source": "src", "iframe": "src", "object": "data"}
NOT_FETCHED = {"canonical", "prev", "next"}  # of links in a head
FIRST = 3  # pages that a search finds
# What a newcomer asks, and the page that a search must find for these words, among the FIRST.
QUESTIONS = {
    "windows macos firefox safari": "answers.html",
    "try without building": "answers.html",
    "first own scene": "answers.html",
    "garment figure animated": "answers.html",
    "cotton silk denim leather": "answers.html",
    "which solver nodes time step": "answers.html",
    "blender": "how-to/export.html",
    "three.js shared device": "answers.html",
    "c++ library": "cpp.html",
    "python numpy": "how-to/python.html",
    "checkpoint resume": "how-to/resume.html",
    "cloth explodes": "answers.html",
    "passes through obstacle": "answers.html",
    "ordinary gpu fast": "answers.html",
    "real cloth theory": "answers.html",
    "seams tearing plasticity": "answers.html",
    "light background transparency 4k": "answers.html",
    "runs repeatable": "answers.html",
    "friction thickness self-contact": "answers.html",
    "no webgpu adapter was found": "answers.html",
    "add a solver": "answers.html",
}


class Page(html.parser.HTMLParser):
    """A page's links, the anchors that it has, what it fetches, its head's policy and its paragraphs."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.anchors: set[str] = set()
        self.fetched: list[str] = []
        self.policy = ""
        self.paragraphs: list[str] = []
        self.inside = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        has = {key: value or "" for key, value in attributes}
        self.anchors |= {has[key] for key in ("id", "name") if key in has}
        if tag == "a" and "href" in has:
            self.links.append(has["href"])
        if tag == "link" and has.get("rel") not in NOT_FETCHED:
            self.fetched.append(has["href"])
        if FETCHED.get(tag) in has:
            self.fetched.append(has[FETCHED[tag]])
        self.fetched += re.findall(r"url\(['\"]?([^'\")]+)", has.get("style", ""))
        if has.get("http-equiv") == "Content-Security-Policy":
            self.policy = has["content"]
        self.inside = tag
        if tag == "p":
            self.paragraphs.append("")

    def handle_data(self, data: str) -> None:
        if self.inside == "p" and self.paragraphs:
            self.paragraphs[-1] += data


def is_elsewhere(link: str) -> bool:
    return bool(urllib.parse.urlsplit(link).netloc)


def broken(site: pathlib.Path, pages: dict[str, Page]) -> list[str]:
    """Links and pictures of the pages that lead nowhere on the site."""
    found = []
    for name, page in pages.items():
        for link in page.links + page.fetched:
            parts = urllib.parse.urlsplit(link)
            if parts.netloc or parts.scheme in ("data", "mailto"):
                continue
            path = (site / name).parent / urllib.parse.unquote(parts.path) if parts.path else site / name
            path = pathlib.Path(os.path.normpath(path))
            path = path / "index.html" if path.is_dir() else path
            target = pages.get(path.relative_to(site).as_posix()) if path.is_relative_to(site) else None
            anchor = urllib.parse.unquote(parts.fragment)
            if not path.is_file() or anchor and target and anchor not in target.anchors | {"__tabbed"}:
                found.append(f"{name}: {link}")
    return found


def asked_elsewhere(page: Page) -> list[str]:
    return [link for link in page.fetched if is_elsewhere(link)]


def misread(page: Page) -> list[str]:
    """Paragraphs in which a list or a table was read as text."""
    return [text for text in page.paragraphs if re.search(r"^(?:[-*] |\| )|```", text, re.MULTILINE)]


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.site = pathlib.Path(cls.folder.name) / "site"
        words = [sys.executable, "-m", "mkdocs", "build", "--quiet", "--site-dir", str(cls.site)]
        made = subprocess.run(
            words, cwd=ROOT, env=os.environ | {"NO_MKDOCS_2_WARNING": "1"}, capture_output=True, text=True, check=False
        )
        if made.returncode != 0 or made.stderr:
            raise AssertionError(f"mkdocs ended with {made.returncode}:\n{made.stdout}{made.stderr}")
        cls.pages = {
            path.relative_to(cls.site).as_posix(): Page(path.read_text("utf-8"))
            for path in sorted(cls.site.rglob("*.html"))
            if path.name != "404.html"  # its links are those of a site at a server's root
        }

    def test_every_link_leads_somewhere(self):
        self.assertGreater(len(self.pages), 40)
        self.assertEqual(broken(self.site, self.pages), [])
        pages = {"index.html": Page('<a href="no_such.html">a</a><a href="tutorial.html#no-such">b</a>')}
        self.assertEqual(len(broken(self.site, self.pages | pages)), 2)

    def test_no_page_fetches_anything_from_elsewhere_and_its_policy_forbids_it(self):
        for name, page in self.pages.items():
            self.assertEqual(asked_elsewhere(page), [], name)
            self.assertIn("default-src 'self'", page.policy, name)
            self.assertNotRegex(page.policy, r"https?:", name)
        for path in self.site.rglob("*.css"):
            self.assertNotRegex(path.read_text("utf-8"), r"@import|url\(['\"]?(?:https?:)?//", path.name)
        for text in ('<script src="//a.org/a.js">', '<link rel="stylesheet" href="https://a.org/a.css">'):
            self.assertNotEqual(asked_elsewhere(Page(text)), [])

    def test_lists_and_tables_are_read_as_github_reads_them(self):
        for name, page in self.pages.items():
            self.assertEqual(misread(page), [], name)
        self.assertEqual(len(misread(Page("<p>A list:\n- one\n- two</p><p>A table:\n| a |\n|---|</p><p>-1</p>"))), 2)

    def test_a_search_finds_an_answer_to_each_question(self):
        asked = searched(f"{self.site.as_uri()}/how-to/film.html", *QUESTIONS)
        self.assertEqual(asked["complaints"], [])
        for words, page in QUESTIONS.items():
            paths = (urllib.parse.unquote(urllib.parse.urlsplit(link).path) for link in asked["found"][words])
            found = list(dict.fromkeys(os.path.relpath(path, self.site) for path in paths))[:FIRST]
            with self.subTest(words):
                self.assertIn(page, found)

    def test_it_works_on_a_server_too(self):
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=self.site))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        asked = searched(f"http://127.0.0.1:{server.server_port}/answers.html", "leather")
        self.assertEqual(asked["complaints"], [])
        self.assertIn("answers.html", asked["found"]["leather"][0])


def searched(page: str, *questions: str) -> dict[str, Any]:
    """What search_site.ts says."""
    words = [ROOT / ".setup/bin/node", "tests/docs/search_site.ts", page, *questions]
    return json.loads(subprocess.run(words, cwd=ROOT, stdout=subprocess.PIPE, check=True, timeout=300).stdout)


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, format: str, *words: object) -> None:
        pass


if __name__ == "__main__":
    unittest.main()
