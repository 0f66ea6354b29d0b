import pytest

import polarform as pf


@pytest.fixture(autouse=True)
def _names(doctest_namespace):
    doctest_namespace["pf"] = pf


@pytest.fixture(autouse=True)
def _limits():
    """Limits that a test sets end with it."""
    before = pf._get_limits()
    yield
    timeout, terms, digits, depth = before
    pf._set_limits(timeout or 0, terms, digits, depth)
