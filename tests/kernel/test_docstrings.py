# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every public name of the modules has a docstring, and what the docstrings show is what happens."""

import doctest
import inspect

import pnkernel
import pnocct
import pytest

MODULES = (pnkernel, pnocct)
NAMES = {"pn": pnkernel, "pnocct": pnocct}


def public_members(owner):
    return [
        (f"{owner.__name__}.{name}", member)
        for name, member in vars(owner).items()
        if not name.startswith("_")
    ]


def documented():
    for module in MODULES:
        for name, member in public_members(module):
            yield pytest.param(member, id=name)
            if inspect.isclass(member):
                for inner_name, inner in public_members(member):
                    yield pytest.param(inner, id=inner_name)


def text_of(member):
    """The docstring without the signatures that pybind11 puts above it."""
    lines = (inspect.getdoc(member) or "").splitlines()
    return "\n".join(line for line in lines if ") -> " not in line).strip()


@pytest.mark.parametrize("member", documented())
def test_it_is_documented(member):
    assert text_of(member)


def run_examples(text):
    """How many there are, and the report on those that fail."""
    example = doctest.DocTestParser().get_doctest(text, dict(NAMES), "docstring", None, 0)
    report = []
    _, attempted = doctest.DocTestRunner(verbose=False).run(example, out=report.append)
    return attempted, "".join(report)


@pytest.mark.parametrize("member", documented())
def test_its_examples_are_true(member):
    _, report = run_examples(inspect.getdoc(member) or "")
    assert not report, report


def test_examples_are_run():
    documents = [inspect.getdoc(member) or "" for param in documented() for member in param.values]
    assert sum(run_examples(document)[0] for document in documents) > 0
    assert "Expected" in run_examples(">>> 1 + 1\n3")[1]
