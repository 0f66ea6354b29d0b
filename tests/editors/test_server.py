"""The language server, asked by a client that others wrote (pytest-lsp), as editors do.

    target/python-env/bin/python -m pip install pytest-lsp
    target/python-env/bin/python -m pytest tests/editors
"""

import asyncio
import os
import time
from pathlib import Path

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

ROOT = Path(__file__).parent.parent.parent
PROGRAM = os.environ.get("POLARFORM", str(ROOT / "target" / "debug" / "polarform"))
URI = "untitled:page.md"

#: Milliseconds in which a keystroke is answered on a page of 100 formulas by the optimised program; a debug build, and a
#: machine at work on something else, get more.
ANSWERED = float(os.environ.get("POLARFORM_ANSWERED", "5000"))


@pytest_lsp.fixture(params=["neovim", "visual_studio_code"], config=ClientServerConfig(server_command=[PROGRAM, "lsp"]))
async def client(request, lsp_client: LanguageClient):
    lsp_client.feature(types.WORKSPACE_INLAY_HINT_REFRESH)(lambda *_: None)
    parameters = types.InitializeParams(capabilities=client_capabilities(request.param))
    result = await lsp_client.initialize_session(parameters)
    assert result.capabilities.inlay_hint_provider and result.capabilities.completion_provider
    yield
    await lsp_client.shutdown_session()


def opened(client: LanguageClient, text: str) -> None:
    item = types.TextDocumentItem(uri=URI, language_id="markdown", version=1, text=text)
    client.text_document_did_open(types.DidOpenTextDocumentParams(text_document=item))


def changed(client: LanguageClient, version: int, text: str) -> None:
    page = types.VersionedTextDocumentIdentifier(uri=URI, version=version)
    change = types.TextDocumentContentChangeWholeDocument(text=text)
    client.text_document_did_change(types.DidChangeTextDocumentParams(text_document=page, content_changes=[change]))


async def diagnostics(client: LanguageClient) -> list[types.Diagnostic]:
    await client.wait_for_notification("textDocument/publishDiagnostics")
    return list(client.diagnostics[URI])


PAGE = "Let $F(t) = t^2 + 2t$ and {{ pola }}. Now $2 + 2 = 5$ and $2 + 2 = 4$.\n"


@pytest.mark.asyncio
async def test_a_page_is_marked_explained_and_repaired(client: LanguageClient):
    opened(client, PAGE)
    (wrong,) = await diagnostics(client)
    assert wrong.severity == types.DiagnosticSeverity.Error and wrong.code == "refuted"
    at = PAGE.index("2 + 2 = 5")
    assert wrong.range.start == types.Position(line=0, character=at)
    page = types.TextDocumentIdentifier(uri=URI)
    hover = await client.text_document_hover_async(types.HoverParams(text_document=page, position=wrong.range.start))
    assert "refuted" in hover.contents.value and "read as" in hover.contents.value
    context = types.CodeActionContext(diagnostics=[wrong])
    actions = await client.text_document_code_action_async(
        types.CodeActionParams(text_document=page, range=wrong.range, context=context)
    )
    # The last one has a command; lsprotocol takes what has one for a bare command.
    assert [action.kind for action in actions[:2]] == ["quickfix", "source.fixAll"]
    assert [action.title for action in actions[2:]] == ["Put the results of polarform into the page"]
    whole = types.Range(start=types.Position(line=0, character=0), end=types.Position(line=9, character=0))
    hints = await client.text_document_inlay_hint_async(types.InlayHintParams(text_document=page, range=whole))
    assert [hint.label for hint in hints] == ["✗", "✓"]
    place = types.Position(line=0, character=PAGE.index("pola") + 4)
    found = await client.text_document_completion_async(types.CompletionParams(text_document=page, position=place))
    assert "polar" in [item.label for item in found]


@pytest.mark.asyncio
async def test_a_keystroke_is_answered_at_once(client: LanguageClient):
    formulas = [
        r"$(a + b)^{%d} (a - b) = (a - b) (a + b)^{%d}$",
        r"$\sum_{i=0}^n \binom{n}{i} = 2^n + %d - %d$",
        r"$\sum_{i=0}^n B_i^n(t) = 1 + %d - %d$",
        r"$B_{i}^{n}(t) = B_{n-i}^{n}(1-t) + %d - %d$",
    ]
    lines = ["# Page\n\nHere $F(t) = t^2 + 2t$ has the polar form $f(t_1, t_2) = t_1 t_2 + t_1 + t_2$.\n"]
    lines += ["Thus " + formulas[k % 4] % (k % 7, k % 7) + ".\n" for k in range(98)]
    edited = 50
    opened(client, "\n".join(lines))
    await diagnostics(client)
    times = []
    for version, typed in enumerate(["$2 + 2 = 5$", "$2 + 2 = 51$", "$2 + 2 = 512$", "$2 + 2 = 51$", "$2 + 2 = 5$"], start=2):
        lines[edited] = f"Then {typed}.\n"
        began = time.perf_counter()
        changed(client, version, "\n".join(lines))
        # Where reading the page takes long, what is kept of the last check is told before.
        refuted = []
        while refuted != [2 * edited + 2]:
            found = await asyncio.wait_for(diagnostics(client), ANSWERED / 1000)
            refuted = [mark.range.start.line for mark in found if mark.code == "refuted"]
        times.append((time.perf_counter() - began) * 1000)
        await asyncio.sleep(0.3)
    print("answered after", [f"{t:.0f} ms" for t in times])
    assert sorted(times)[len(times) // 2] < ANSWERED, times
