# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collects the texts of the workbench into the Qt translation files *.ts that are given.

What a file has translated already is kept, texts that are used no more are dropped. Qt's own
pyside2-lupdate reads neither characters beyond ASCII nor calls that end with a comma.
"""

import ast
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[1]

# The functions that mark a text, as its context and the text itself.
MARKS = ("translate", "QT_TRANSLATE_NOOP")

HEADER = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'


def texts_of_code(path):
    """The pairs (context, text) that a Python file marks; other arguments are no literals."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and _name(node.func) in MARKS:
            arguments = node.args[:2]
            if all(isinstance(argument, ast.Constant) for argument in arguments):
                yield tuple(argument.value for argument in arguments)


def texts_of_form(path):
    """The pairs (context, text) of a Qt form."""
    form = ElementTree.parse(path).getroot()
    for string in form.iter("string"):
        if string.text and string.get("notr") != "true":
            yield form.find("class").text, string.text


def all_texts():
    """All pairs (context, text) of the workbench, in order and without repetition."""
    code = [*sorted(ROOT.glob("workbench/pnsurfaces/*.py")), ROOT / "resources/examples/gallery.py"]
    forms = sorted(ROOT.glob("resources/ui/*.ui"))
    pairs = [pair for path in code for pair in texts_of_code(path)]
    pairs += [pair for path in forms for pair in texts_of_form(path)]
    return sorted(set(pairs))


def update(path, texts):
    """Gives a translation file these texts, with the translations that it has of them."""
    old = ElementTree.parse(path).getroot()
    known = {
        (context.find("name").text, message.find("source").text): message.find("translation").text
        for context in old.iter("context")
        for message in context.iter("message")
    }
    root = ElementTree.Element("TS", old.attrib)
    contexts = {}
    for name, text in texts:
        if name not in contexts:
            contexts[name] = ElementTree.SubElement(root, "context")
            ElementTree.SubElement(contexts[name], "name").text = name
        message = ElementTree.SubElement(contexts[name], "message")
        ElementTree.SubElement(message, "source").text = text
        translation = ElementTree.SubElement(message, "translation")
        translation.text = known.get((name, text))
        if not translation.text:
            translation.set("type", "unfinished")
    ElementTree.indent(root, "    ")
    path.write_text(HEADER + ElementTree.tostring(root, encoding="unicode") + "\n", encoding="utf-8")


def _name(function):
    return getattr(function, "id", getattr(function, "attr", None))


if __name__ == "__main__":
    for argument in sys.argv[1:]:
        update(pathlib.Path(argument), all_texts())
