"""Elements that pages can do without (course_lib.pack.site): groups of formulas, spans of code."""

import re

import pytest

from course_lib.pack.site import formulas
from course_lib.pack.site.finish import finish, plain_classes

STYLE = """html[data-theme="light"] .highlight pre { line-height: 125%; }
html[data-theme="light"] .highlight { background: #fefefe; color: #080808 }
html[data-theme="light"] .highlight .k { color: #6730C5 } /* Keyword */
html[data-theme="light"] .highlight .n { color: #080808 } /* Name */
html[data-theme="light"] .highlight .p { color: #080808 } /* Punctuation */
html[data-theme="light"] .highlight .hll { background-color: #fae4c2 }
html[data-theme="dark"] .highlight { background: #2b2b2b; color: #F8F8F2 }
html[data-theme="dark"] .highlight .k { color: #DCC6E0 } /* Keyword */
html[data-theme="dark"] .highlight .n { color: #F8F8F2 } /* Name */
html[data-theme="dark"] .highlight .p { color: #FFD900 } /* Punctuation */
"""


def groups(text):
    return re.findall("<g(?: [^>]*)?>", formulas.typeset(text))


def test_the_letters_of_a_line_stand_in_one_group():
    assert len(groups(r"a + b = c")) == 1


@pytest.mark.parametrize(
    "text", [r"\frac{a_1^2}{b}", r"\begin{bmatrix} 1 & a^2 \\ 0 & b \end{bmatrix}"]
)
def test_each_group_of_a_formula_moves_more_than_one_letter(text):
    picture = formulas.typeset(text)
    assert "<g>" not in picture
    assert not re.search(r"<g [^>]*><use [^>]*></use></g>", picture)
    assert picture.count("<g") == picture.count("</g>")


def test_a_moved_letter_keeps_its_place():
    picture = formulas.typeset("a^2")
    first, second = re.findall("<use [^>]*>", picture)
    assert "transform" not in first
    assert re.search(r'transform="translate\([\d.]+,363\) scale\(0.707\)"', second)


def test_a_class_is_plain_that_no_theme_colours():
    assert plain_classes(STYLE) == ["n"]


def test_words_without_a_colour_of_their_own_lose_their_span_in_code_alone(tmp_path):
    (tmp_path / "_static").mkdir()
    (tmp_path / "_static/pygments.css").write_text(STYLE, encoding="utf-8")
    code = '<span class="k">def</span> <span class="n">f</span><span class="p">():</span>'
    kept = '<p><span class="n">n</span></p>'
    page = tmp_path / "page.html"
    page.write_text(f'{kept}<div class="highlight"><pre>{code}</pre></div>', encoding="utf-8")
    finish(tmp_path)
    less = '<span class="k">def</span> f<span class="p">():</span>'
    assert page.read_text(encoding="utf-8") == (
        f'{kept}<div class="highlight"><pre>{less}</pre></div>'
    )
