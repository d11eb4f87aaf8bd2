"""The few of the theme's icons that pages use, drawn here.

The theme takes them from a font that weighs more than a page.
"""

from urllib.parse import quote

DRAWN = {
    "magnifying-glass": "<circle cx='10' cy='10' r='6'/><path d='m15 15 6 6'/>",
    "arrow-up": "<path d='M12 21V4M5 11l7-7 7 7'/>",
    "bars": "<path d='M3 5h18M3 12h18M3 19h18'/>",
    "list": "<path d='M9 5h12M9 12h12M9 19h12M3 5h1M3 12h1M3 19h1'/>",
    "expand": "<path d='M3 9V3h6M15 3h6v6M21 15v6h-6M9 21H3v-6'/>",
    "rocket": "<path d='M12 2c4 3 5 8 4 14H8C7 10 8 5 12 2zM8 12l-3 3v4l3-2"
    "M16 12l3 3v4l-3-2M12 18v4'/>",
    "sun": "<circle cx='12' cy='12' r='4'/><path d='M12 2v3M12 19v3M2 12h3M19 12h3"
    "M5 5l2 2M17 17l2 2M19 5l-2 2M7 17l-2 2'/>",
    "moon": "<path d='M20 14A8.5 8.5 0 1 1 10 4a7 7 0 0 0 10 10z'/>",
    "circle-half-stroke": (
        "<circle cx='12' cy='12' r='9'/><path fill='#000' d='M12 3a9 9 0 0 1 0 18z'/>"
    ),
    "angle-left": "<path d='m15 4-8 8 8 8'/>",
    "angle-right": "<path d='m9 4 8 8-8 8'/>",
}
BEGIN = (
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 24 24' fill='none' stroke='#000' "
    "stroke-width='2.4' "
)
ROUND = "stroke-linecap='round' stroke-linejoin='round'>"
STYLE = """:is(.fa-solid, .fas) {
  display: inline-block;
  width: 1.1em;
  height: 1.1em;
  background: currentColor;
  mask: var(--icon) center / contain no-repeat;
  vertical-align: -0.15em;
}

:is(.fa-solid, .fas, .highlight-link a)::before,
.admonition-title::after {
  content: none !important;
}
"""


def style() -> str:
    """Return the style sheet of the icons."""
    rules = [
        f'.fa-{name} {{\n  --icon: url("{_link(drawn)}");\n}}\n' for name, drawn in DRAWN.items()
    ]
    return "\n".join([STYLE, *rules])


def _link(drawn: str) -> str:
    return "data:image/svg+xml," + quote(f"{BEGIN}{ROUND}{drawn}</svg>", safe=" =':/")
