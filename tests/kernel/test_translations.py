# SPDX-License-Identifier: LGPL-2.1-or-later
"""The translations: every text of the workbench is there, and German is complete."""

import pathlib
import shutil
import string
import subprocess
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
TRANSLATIONS = ROOT / "resources" / "translations"
GERMAN = TRANSLATIONS / "PNSurfaces_de.ts"


def messages(path):
    """Triples (context, text, translation element) of a translation file."""
    for context in ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            yield context.find("name").text, message.find("source").text, message.find("translation")


def placeholders(text):
    return sorted(field for _, field, _, _ in string.Formatter().parse(text) if field is not None)


def test_they_are_up_to_date(tmp_path):
    for path in TRANSLATIONS.iterdir():
        shutil.copy(path, tmp_path)
    subprocess.run([ROOT / "scripts" / "translate", tmp_path], check=True, capture_output=True)
    for path in TRANSLATIONS.iterdir():
        assert (tmp_path / path.name).read_bytes() == path.read_bytes(), path.name


def test_german_is_complete():
    for context, text, translation in messages(GERMAN):
        assert translation.text, (context, text)
        assert translation.get("type") is None, (context, text)


def test_translations_have_the_same_placeholders():
    for context, text, translation in messages(GERMAN):
        assert placeholders(translation.text) == placeholders(text), (context, text)
