# SPDX-License-Identifier: LGPL-2.1-or-later
"""One version, that of package.xml, in all that is built and installed, and in the changelog."""

import pathlib
import re
import xml.etree.ElementTree as ElementTree

import pnkernel
import pnsurfaces

ROOT = pathlib.Path(__file__).resolve().parents[2]
VERSION = ElementTree.parse(ROOT / "package.xml").getroot().findtext("{*}version")


def numbers(version):
    return tuple(int(number) for number in version.split("."))


def test_version_is_semantic():
    assert re.fullmatch(r"\d+\.\d+\.\d+", VERSION)


def test_kernel_has_it():
    assert pnkernel.__version__ == VERSION


def test_workbench_has_it():
    assert pnsurfaces.__version__ == VERSION


def test_changelog_ends_with_it():
    """What is new stands under this version, or is not released yet; older versions follow."""
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    headings = re.findall(r"^## \[(.*?)\]", text, re.MULTILINE)
    assert headings[0] in ("Unreleased", VERSION)
    released = [numbers(heading) for heading in headings if heading != "Unreleased"]
    assert [numbers(VERSION), *released] == sorted([numbers(VERSION), *released], reverse=True)
