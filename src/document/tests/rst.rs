//! Formulas and blocks of reStructuredText.

use super::*;

fn rst(text: &str) -> Document {
    document(SourceFile::new("a.rst", text), Container::Rst)
}

fn found(text: &str) -> Vec<String> {
    let notes = rst(text);
    assert!(notes.problems.is_empty(), "{text:?}: {:?}", notes.problems);
    for formula in formulas(&notes) {
        assert_eq!(notes.file.slice(formula.span), formula.text, "places lead back");
    }
    formulas(&notes).into_iter().map(|formula| formula.text.clone()).collect()
}

#[test]
fn roles_and_literals() {
    let text = "See :math:`a = b`, `c`:math:, ``:math:`x```, :func:`f <g>`, `link`_ and |sub|,\n\
                also :math:`d\n+ e`. A backslash: :math:`f\\,` ends it.\n";
    assert_eq!(found(text), ["a = b", "c", "d\n+ e", "f\\,"]);
    assert_eq!(found("A :math:`m`-by-:math:`2 n` matrix, :py:class:`C`.\n"), ["m", "2 n"]);
    assert_eq!(found(".. default-role:: math\n\nLet `a` be ``b``.\n"), ["a"]);
    assert_eq!(found("Let `a` be $b$ and $$c$$, 5$.\n"), ["b", "c"]);
}

#[test]
fn displays() {
    let text = "So\n\n.. math::\n   :label: eq\n\n   a &= b \\\\\n     &= c\n\n   d = e\n\nand\n\n.. math:: f = g\n\n\
                .. math::\n   :nowrap:\n\n   \\begin{eqnarray}\n   h = 1\n\n   \\end{eqnarray}\n\n\
                .. math::\n\n   \\[ k \\]\n\nend.\n";
    let all = found(text);
    assert_eq!(all[..3], ["a &= b \\\\\n     &= c", "d = e", "f = g"]);
    assert!(all[3].starts_with(r"\begin{eqnarray}") && all[3].ends_with(r"\end{eqnarray}"), "{all:?}");
    assert_eq!(all[4..], ["k"]);
    assert!(!shown(&rst(text)).iter().any(|item| item.contains("label")));
}

#[test]
fn sections_lists_and_notes() {
    let text = "=====\nTitle\n=====\n\nPart :math:`a`\n--------------\n\n- :math:`b`\n\n  .. math:: c\n\n- :math:`d`\n\n\
                .. note:: Let :math:`e`\n   be.\n\n.. prf:theorem:: On :math:`f`\n   :label: x\n\n   Then :math:`g`.\n\n\
                .. figure:: a.png\n   :width: 3\n\n   Shows :math:`h`.\n\n.. [1] See :math:`i`.\n\nlast :math:`j`\n";
    assert_eq!(found(text), ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"]);
    let items = shown(&rst(text));
    assert!(
        items.contains(&"h1 2:1 Title".to_owned()) && items.contains(&"h2 5:1 Part :math:`a`".to_owned())
    );
    let count = |what: &str| items.iter().filter(|item| item.as_str() == what).count();
    assert_eq!((count("enter item"), count("leave item")), (3, 3));
    assert_eq!((count("enter environment"), count("leave environment")), (3, 3));
}

#[test]
fn what_is_shown_as_typed_holds_no_formulas() {
    let text = "Code::\n\n   :math:`x`\n\n   .. math:: y\n\nAfter :math:`a`.\n\n.. code-block:: rst\n\n   :math:`z`\n\n\
                .. A comment with :math:`w`\n   on two lines\n\n>>> 5$ :math:`v`\n\n..\n\n   quoted :math:`b`\n";
    assert_eq!(found(text), ["a", "b"]);
}

#[test]
fn tables() {
    let text = "+-----------+-----------+\n| :math:`a` | b         |\n+===========+===========+\n| c         | :math:`d` |\n\
                +-----------+-----------+\n\n=====  =====\nx      :math:`e`\n=====  =====\n\n\
                .. list-table::\n   :header-rows: 1\n\n   * - :math:`f`\n     - g\n";
    assert_eq!(found(text), ["a", "d", "e", "f"]);
}

#[test]
fn declarations_and_what_is_not_read() {
    let notes =
        rst(".. polarform: H(t) := t^2\n\nLet :math:`H`.\n\n.. mystery::\n\n   :math:`x`\n\n:math:`open\n");
    let items = shown(&notes);
    assert!(items.contains(&"declaration 1:15 H(t) := t^2".to_owned()), "{items:?}");
    let codes: Vec<Code> = notes.problems.iter().map(|problem| problem.code).collect();
    assert_eq!(codes, [Code::UnseenFormula, Code::UnclosedFormula]);
}

#[test]
fn plots_with_words_between_commands() {
    let text = ".. plot::\n   :context: close-figs\n\n   Choose :math:`L = 600` now.\n\n   >>> L = 600\n   600\n\n   And :math:`a`.\n\n\
                .. plot::\n\n   plt.plot(x)  # :math:`b`\n";
    assert_eq!(found(text), ["L = 600", "a"]);
}

#[test]
fn heads_of_tables() {
    let text = ".. csv-table:: Cases\n   :header: no, \":math:`D_0`\"\n\n   :math:`1`, 2\n";
    assert_eq!(found(text), ["D_0", "1"]);
}
