"""The package in the real compiler: python test.py PACKAGE [PICTURE]. Needs the package typst of PyPI."""
import json
import pathlib
import re
import shlex
import sys
import tempfile

import typst

package = pathlib.Path(sys.argv[1]).resolve()
here = pathlib.Path(__file__).resolve().parent
source = (here / "test.typ").read_text()


def compiled(text, **options):
    """Compiles a document that stands beside the package."""
    with tempfile.NamedTemporaryFile("w", suffix=".typ", dir=package) as file:
        file.write(text)
        file.flush()
        return typst.compile(file.name, root=str(package), **options)


with tempfile.NamedTemporaryFile("w", suffix=".typ", dir=package) as file:
    file.write(source)
    file.flush()
    found = json.loads(typst.query(file.name, "<results>", root=str(package)))[0]["value"]
expected = {"value": "3/2", "verdict": "refuted", "deep": "55", "full": "proved"}
assert expected.items() <= found.items(), found
# A limit that is passed inside is no end of the document.
assert found["stopped"] in ("undecided", "sampled"), found
picture = compiled(source, format="png", ppi=110)
if len(sys.argv) > 2:
    pathlib.Path(sys.argv[2]).write_bytes(picture)

for wrong, words in [('#pf("1 + * 2")', "operators in a row"), ('#claim("1 = 2", strict: true)', "refuted"), ('#pf("2^(10^9)")', "bits"), ('#pf("g(n) := g(n-1)", "g(3)")', "nested more than 60 deep")]:
    try:
        compiled(f'#import "/lib.typ": claim, pf\n{wrong}')
        raise SystemExit(f"{wrong} should not compile")
    except typst.TypstError as error:
        assert words in str(error), error

# Every example of the documentation: what is no text compiles as a formula of Typst.
lines = re.findall(r"^\$ polarform eval (.*)$", (here / "../../../docs/functions.md").read_text(), re.M)
queries = [words for words in map(shlex.split, lines) if not any(word.startswith("--") for word in words)]
assert len(queries) > 200, len(queries)
listed = json.dumps(json.dumps(queries, ensure_ascii=False), ensure_ascii=False)
every = "{ for answer in ask(q) { shown(answer, block: true) } }"
compiled(f'#import "/lib.typ": ask, shown\n#for q in json(bytes({listed})) ' + every, format="pdf")
print(f"the document and {len(queries)} examples of docs/functions.md compile")
