"""The page is for everybody: axe-core finds no serious violation in it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.analysis.browser import Browser

ROOT = Path(__file__).resolve().parents[2]
AXE = ROOT / "build" / "axe" / "node_modules" / "axe-core" / "axe.min.js"
# axe looks at every cell, and takes minutes: a row stays if it is among the first
# of its table or has a colour (class) that none before it had.
THINNED = """
for (const table of document.querySelectorAll("table")) {
  const seen = new Set();
  [...table.tBodies[0].rows].forEach((row, at) => {
    const looks = [...row.cells].map((cell) => cell.className);
    if (at >= 3 && looks.every((look) => seen.has(look))) row.remove();
    looks.forEach((look) => seen.add(look));
  });
}
"""
FOUND = """
axe.run(document, {resultTypes: ["violations"]}).then((found) => found.violations
  .filter((one) => one.impact === "serious" || one.impact === "critical")
  .map((one) => [one.id, one.nodes.length, one.nodes[0].target.join(" ")]))
"""


def axe_script(path: Path = AXE) -> str:
    if not path.is_file():
        pytest.fail(
            f"axe-core is not at {path}: ./reproduce test python fetches it with "
            "npm, or: mkdir -p build/axe && cp tests/axe/*.json build/axe/ && "
            "npm ci --prefix build/axe --ignore-scripts"
        )
    return path.read_text()


def violations(browser: Browser) -> Any:
    browser.run(THINNED + axe_script() + ";0")
    return browser.run(FOUND)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with Browser() as browser:
        yield browser


@pytest.mark.parametrize("width", [1200, 360])
@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_no_serious_violation(
    browser: Browser, page: Path, width: int, dark: bool
) -> None:
    browser.errors.clear()
    browser.look(width, 900, dark)
    browser.open(page.as_uri())
    assert violations(browser) == []
    assert browser.errors == []


def test_a_violation_would_be_seen(browser: Browser, tmp_path: Path) -> None:
    bad = tmp_path / "bad.html"
    bad.write_text("<!DOCTYPE html><html lang=en><title>a</title><select></select>")
    browser.open(bad.as_uri())
    assert "select-name" in [one[0] for one in violations(browser)]


def test_a_missing_axe_is_a_failure_that_says_how_to_get_it(tmp_path: Path) -> None:
    with pytest.raises(pytest.fail.Exception, match="npm ci"):
        axe_script(tmp_path / "axe.min.js")
