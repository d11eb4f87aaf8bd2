"""The narrowest phone: 320 pixels, as WCAG asks (reflow)."""

import pytest
from site_visits import Visit

WIDTH = "Math.max(document.documentElement.scrollWidth, document.body.scrollWidth)"
PAGES = ["index", "errata", "sources", "notation", "search", *(f"0{n}_" for n in range(1, 7))]


@pytest.mark.parametrize("name", PAGES)
def test_no_page_is_wider_than_the_narrowest_phone(course, browser, name):
    (page,) = course.glob(f"{name}*.html")
    with Visit(browser, page, width=320) as visit:
        assert visit.page.evaluate(WIDTH) <= 320
