"""The page in a browser: it loads without an error, and its tables sort."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.analysis.browser import Browser

COLUMN = """
(title) => {
  const table = document.getElementById("cells-table");
  const headers = [...table.tHead.rows[0].cells];
  const at = headers.findIndex((h) => h.textContent.trim() === title);
  return {
    values: [...table.tBodies[0].rows].map((r) => r.cells[at].dataset.v ?? r.cells[at].textContent),
    sort: headers[at].getAttribute("aria-sort"),
    sorted: headers.filter((h) => h.hasAttribute("aria-sort")).length,
  };
}
"""
HEADER = """
(title) => [...document.querySelectorAll("#cells-table thead button")]
  .find((b) => b.textContent.trim() === title)
"""


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with Browser() as browser:
        yield browser


@pytest.fixture
def opened(browser: Browser, page: Path) -> Browser:
    browser.errors.clear()
    browser.open(page.as_uri())
    return browser


def test_the_page_loads_without_an_error_or_a_request(
    opened: Browser, page: Path
) -> None:
    assert opened.run("document.title").startswith("Is this point inside")
    assert opened.errors == []
    asked = [url for url in opened.requests() if not url.startswith("data:")]
    assert set(asked) <= {page.as_uri(), "about:blank"}


def test_an_error_in_the_page_would_be_seen(browser: Browser, tmp_path: Path) -> None:
    (tmp_path / "bad.html").write_text("<script>nonsense()</script>")
    browser.errors.clear()
    browser.open((tmp_path / "bad.html").as_uri())
    assert any("nonsense" in error for error in browser.errors)


def test_a_column_of_numbers_sorts_as_numbers_both_ways(opened: Browser) -> None:
    opened.run(f"({HEADER})('ns/item').click()")
    up = opened.run(f"({COLUMN})('ns/item')")
    numbers = [float(value) for value in up["values"]]
    assert len(numbers) > 100
    assert numbers == sorted(numbers)
    assert (up["sort"], up["sorted"]) == ("ascending", 1)
    opened.run(f"({HEADER})('ns/item').click()")
    down = opened.run(f"({COLUMN})('ns/item')")
    assert [float(value) for value in down["values"]] == numbers[::-1]
    assert (down["sort"], down["sorted"]) == ("descending", 1)


def test_rows_without_a_value_stay_last_in_both_directions(opened: Browser) -> None:
    for _ in range(2):
        opened.run(f"({HEADER})('× scalar').click()")
        values = opened.run(f"({COLUMN})('× scalar')")["values"]
        known = [value for value in values if value != ""]
        assert values[: len(known)] == known


def test_the_keyboard_sorts_too(opened: Browser) -> None:
    opened.run(f"({HEADER})('method').focus()")
    opened.press("Enter", 13, "\r")
    column = opened.run(f"({COLUMN})('method')")
    assert column["values"] == sorted(column["values"])
    assert column["sort"] == "ascending"
    opened.press(" ", 32, " ")
    assert opened.run(f"({COLUMN})('method')")["sort"] == "descending"


def test_the_filter_hides_rows_and_says_how_many_are_left(opened: Browser) -> None:
    opened.run(
        "(() => { const i = document.getElementById('cells-filter');"
        "i.value = 'uv_projection avx2'; i.dispatchEvent(new Event('input')); })()"
    )
    shown = opened.run(
        "[...document.querySelectorAll('#cells-table tbody tr')]"
        ".filter((r) => !r.hidden).map((r) => r.textContent)"
    )
    assert shown and all("uv_projection" in t and "avx2" in t for t in shown)
    said = opened.run("document.querySelector('#cells .filter output').textContent")
    assert said.startswith(f"{len(shown)} of ")


def test_every_link_inside_the_page_leads_somewhere(opened: Browser) -> None:
    broken = opened.run(
        "[...document.querySelectorAll('a[href^=\"#\"]')].map((a) => a.hash.slice(1))"
        ".filter((id) => !document.getElementById(id))"
    )
    assert broken == []


def test_every_linked_file_is_there(opened: Browser, page: Path) -> None:
    links = opened.run(
        "[...document.querySelectorAll('a:not([href^=\"#\"])')]"
        ".map((a) => a.getAttribute('href'))"
    )
    assert len(links) > 10
    assert [link for link in links if not (page.parent / link).is_file()] == []


def test_no_id_is_there_twice(opened: Browser) -> None:
    twice = opened.run(
        "(() => { const seen = new Set(); return [...document.querySelectorAll('[id]')]"
        ".map((e) => e.id).filter((id) => seen.has(id) || !seen.add(id)); })()"
    )
    assert twice == []


def test_a_phone_scrolls_the_page_down_only(page: Path) -> None:
    with Browser(width=500, height=800) as phone:
        phone.open(page.as_uri())
        width = phone.run("document.documentElement.scrollWidth")
        assert width <= phone.run("window.innerWidth")


def test_a_missing_browser_is_a_failure_that_says_so(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("PATH", "")
    with pytest.raises(AssertionError, match="chromium is not installed"):
        Browser()
