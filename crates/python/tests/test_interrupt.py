"""Ctrl-C ends what is going on."""

import os
import signal
import subprocess
import sys
import time

import pytest

LONG = {
    "a query": "pf.eval('factor((x^40 + y^30 + 3)(x^35 - y^25 + x y + 7)(x^20 y^20 + 5))')",
    "a page": "pf.check('$\\\\sum_{i=0}^{n} \\\\binom{n}{i} B_i^n(t) B_{n-i}^n(s) = \\\\sum_{j=0}^n B_j^n(s) B_{n-j}^n(t)$. ' * 3000)",
}


@pytest.mark.skipif(os.name == "nt", reason="there are no signals of this kind")
@pytest.mark.parametrize("what", LONG)
def test_an_interrupt_stops(what):
    # Where a shell starts the tests in the background, interrupts are ignored.
    program = f"import signal\nimport polarform as pf\nsignal.signal(signal.SIGINT, signal.default_int_handler)\nprint('ready', flush=True)\ntry:\n    while True: {LONG[what]}\nexcept KeyboardInterrupt:\n    print('stopped', pf.eval('1 + 1'))\n"
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout.readline() == "ready\n"
        time.sleep(0.5)
        began = time.monotonic()
        child.send_signal(signal.SIGINT)
        try:
            out, _ = child.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            child.kill()
            raise
    assert out == "stopped 2\n" and time.monotonic() - began < 10


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no timer")
def test_a_handler_may_raise_and_calculate():
    import polarform as pf

    class Enough(Exception):
        pass

    def handler(*_):
        raise Enough(str(pf.eval("2 + 3")))

    before = signal.signal(signal.SIGALRM, handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(Enough, match="5"):
            while True:
                pf.eval("factor((x^40 + y^30 + 3)(x^35 - y^25 + x y + 7)(x^20 y^20 + 5))")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert pf.eval("1 + 1") == 2
