"""Lecture notes."""

import json

import pytest

import polarform as pf

PAGE = """# Σ und 𝒇

Let $F(t) = t^2 + 2t$ with polar form $f$, so $f(t_1, t_2) = t_1 t_2 + 2 t_1 + t_2$.

Then $2 + 2 = 4$ and $q(3) = 7$.
"""


def test_verdicts_have_places_reasons_and_repairs():
    report = pf.check(PAGE)
    assert report.counts["refuted"] == 1 and report.counts["proved"] == 1 and not report.ok
    (wrong,) = report.refuted
    assert PAGE[slice(*wrong.span)] == wrong.latex == "f(t_1, t_2) = t_1 t_2 + 2 t_1 + t_2"
    line = PAGE.splitlines()[wrong.line - 1]
    assert (wrong.line, line[wrong.column - 1 : wrong.end_column - 1]) == (3, wrong.latex)
    assert wrong.reason and wrong.counterexample and wrong.suggestion and wrong.assumed
    assert repr(report).startswith("<polarform.Report of <text>: ") and "refuted 3:" in repr(wrong)
    assert len(report) == len(report.findings) == sum(report.counts.values())
    assert [finding.latex for finding in report] == [finding.latex for finding in report.findings]
    assert report[-1].verdict == "definition"
    # With the suggestion in it nothing is wrong.
    repaired = report.fixed()
    assert repaired.replace(wrong.suggestion, wrong.latex) == PAGE and pf.check(repaired).ok


def test_formats_context_and_renderings(tmp_path):
    assert not pf.check(r"\[ 2 + 2 = 5 \] % $1 = 2$", format="latex").ok
    assert pf.check("$k = 4$")[0].verdict == "definition" and pf.check("$k = 4$", context="k := 4")[0].verdict == "proved"
    with pytest.raises(ValueError):
        pf.check("", format="docx")
    report = pf.check("$2 + 2 = 5$", name="a.md")
    assert "a.md:1" in str(report) and "<html" in report.render("html") and "testsuite" in report.render("junit")
    assert json.loads(report.render("json"))["files"][0]["formulas"][0]["verdict"] == "refuted"
    assert json.loads(report.render("sarif"))["version"] == "2.1.0" and "::error" in report.render("github")
    with pytest.raises(ValueError):
        report.render("pdf")
    shown = pf.check("$1 < 2$ and $2 + 2 = 5$", name="<b>&")._repr_html_()
    assert shown.startswith('<pre style="font-family: monospace">') and shown.count("<") == 2 and "&lt;b&gt;&amp;:1:" in shown and "refuted" in shown
    (tmp_path / "part.tex").write_text(r"\(1 + 1 = 3\)")
    (tmp_path / "main.tex").write_text("\\documentclass{article}\\begin{document}\\input{part}\\(1 + 1 = 2\\)\\end{document}")
    reports = pf.check_file(tmp_path / "main.tex")
    assert [report.ok for report in reports] == [True, False]
    (problem,) = pf.check("Text $$1 + 1").problems
    assert (problem.line, problem.code) == (1, "E601") and problem.severity == "warning" and problem.column == 6
    with pytest.raises(pf.PolarformError):
        pf.check_file(tmp_path / "none.md")
    assert len(pf.check("")) == 0 and pf.check("").ok
