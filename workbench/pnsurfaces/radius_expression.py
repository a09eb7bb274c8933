# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radii from an expression in the position, such as "2 mm + 0.5 mm * sin(2*pi*s)", or their squares.

s is the position on the spine and L the length of the spine. Only numbers with units, these names,
+ - * / ^ and the functions below are understood; nothing else is evaluated. Lengths, areas and
plain numbers are told apart; a plain result is millimetres or square millimetres.
"""

import ast
import math
import operator
import re

import FreeCAD
import numpy as np

from pnsurfaces.radius_error import RadiusLawError

# Longer ones are a mistake, and would be nested deeper than Python can follow.
_MOST_CHARACTERS = 1000

# The step into the imaginary by which a derivative is found. It is squared away in the value, so
# that nothing cancels however small it is.
_IMAGINARY_STEP = 1e-100

# A number, its unit, and the power of the unit alone, as FreeCAD reads them.
_QUANTITY = re.compile(
    r"(?<![\w.])((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([A-Za-zµ°]+|\"|')(\s*\^\s*\d+)?"
)

# Names of units cannot be mistaken for variables, or for words of Python such as "in".
_UNIT_PREFIX = "unit_"

_UNIT_SYMBOLS = {'"': "in", "'": "ft", "°": "deg"}

_OPERATORS = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}

_SIGNS = {ast.UAdd: operator.pos, ast.USub: operator.neg}

# All are analytic: derivatives are found through complex numbers. Angles are radians.
_FUNCTIONS = {
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "sinh": np.sinh,
    "cosh": np.cosh,
    "tanh": np.tanh,
    "exp": np.exp,
    "log": np.log,
}

_CONSTANTS = {"pi": math.pi, "e": math.e}

# The dimensions, as powers of length, of a plain number, of a radius, and of its square.
NUMBER = 0
LENGTH = 1
AREA = 2

# What they are called, and an expression of each.
_WORDS = {
    NUMBER: ("a plain number", "-1 + 0.5 * s"),
    LENGTH: ("a length", "2 mm + 1 mm * s"),
    AREA: ("an area", "4 mm^2 + 5 mm^2 * s"),
}


class RadiusExpression:
    """The radius in millimetres, or its square, as a function of the position s.

    `position_dimension` is 1 where s is a length in millimetres, 0 where it is a share; `length` is
    that of the spine; `dimension` is LENGTH for a radius, AREA for its square, and NUMBER for
    what has no unit. Raises RadiusLawError when the text is no such expression.
    """

    def __init__(self, text, position_dimension, length, dimension=LENGTH):
        words, example = _WORDS[dimension]
        self._tree = _parsed(text, example)
        self._position_dimension = position_dimension
        self._names = {name: (np.float64(value), 0) for name, value in _CONSTANTS.items()}
        self._names["L"] = (np.float64(length), 1)
        _, found = self._value_of(np.complex128(1.0))
        if found not in (0, dimension):
            raise RadiusLawError(
                f"The expression gives millimetres to the power {found:g}, not {words}."
            )

    def radius(self, s):
        """Raises RadiusLawError where there is none."""
        value = self._evaluated(np.float64(s))
        if not np.isfinite(value):
            raise RadiusLawError(
                f"The expression has no finite value at position {s:.6g}: it divides by"
                " zero, or takes the root or logarithm of a number that has none."
            )
        return float(value)

    def slope(self, s):
        """The derivative of the radius by the position."""
        beside = self._evaluated(np.complex128(complex(s, _IMAGINARY_STEP)))
        return float(beside.imag / _IMAGINARY_STEP)

    def _evaluated(self, s):
        with np.errstate(all="ignore"):
            return self._value_of(s)[0]

    def _value_of(self, s):
        names = {**self._names, "s": (s, self._position_dimension)}
        return _evaluate(self._tree, names)


def _parsed(text, example):
    if not text.strip():
        raise RadiusLawError(f"The expression is empty. Type one, such as {example}.")
    if len(text) > _MOST_CHARACTERS:
        raise RadiusLawError(
            f"The expression has {len(text)} characters, more than {_MOST_CHARACTERS}."
        )
    source = _QUANTITY.sub(_with_unit, text.strip()).replace("^", "**")
    try:
        return ast.parse(source, mode="eval").body
    except (SyntaxError, ValueError, MemoryError, RecursionError) as error:
        raise RadiusLawError(f"The expression {text!r} cannot be read.") from error


def _with_unit(match):
    number, unit, power = match.groups()
    unit = _UNIT_SYMBOLS.get(unit, unit)
    try:
        _unit(unit)
    except ValueError as error:
        if isinstance(error, RadiusLawError):
            raise
        # A name after a number, but no unit: the parser says what it thinks of it.
        return match.group(0)
    return f"({number} * {_UNIT_PREFIX}{unit}{power or ''})"


def _unit(name):
    """The value of a unit of length in millimetres or of an angle in radians, and its dimension."""
    quantity = FreeCAD.Units.Quantity(f"1 {name}")
    if quantity.Unit == FreeCAD.Units.Length:
        return np.float64(quantity.Value), 1
    if quantity.Unit == FreeCAD.Units.Angle:
        return np.float64(math.radians(quantity.Value)), 0
    raise RadiusLawError(f"The expression has the unit {name}, which is no length or angle.")


def _evaluate(node, names):
    """The value of a syntax tree and its dimension as a power of length."""
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        return np.float64(node.value), 0
    if isinstance(node, ast.Name):
        return _named(node.id, names)
    if isinstance(node, ast.UnaryOp) and type(node.op) in _SIGNS:
        value, dimension = _evaluate(node.operand, names)
        return _SIGNS[type(node.op)](value), dimension
    if isinstance(node, ast.BinOp):
        return _combined(node.op, _evaluate(node.left, names), _evaluate(node.right, names))
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        return _called(node.func.id, [_evaluate(argument, names) for argument in node.args])
    raise RadiusLawError("The expression may have only numbers, names, + - * / ^ and ( ).")


def _named(name, names):
    if name.startswith(_UNIT_PREFIX):
        return _unit(name.removeprefix(_UNIT_PREFIX))
    if name not in names:
        raise RadiusLawError(
            f"The expression has the unknown name {name}. It may have s, L, pi, e, units and"
            f" {', '.join(['sqrt', *_FUNCTIONS])}."
        )
    return names[name]


def _combined(operation, left, right):
    (a, a_dimension), (b, b_dimension) = left, right
    if isinstance(operation, ast.Pow):
        if b_dimension:
            raise RadiusLawError("The expression has a length as an exponent.")
        if a_dimension and np.iscomplexobj(b):
            raise RadiusLawError("The expression raises a length to a power that changes.")
        return a**b, a_dimension and a_dimension * float(b)
    if type(operation) not in _OPERATORS:
        raise RadiusLawError("The expression may have only the operators + - * / ^.")
    value = _OPERATORS[type(operation)](a, b)
    if isinstance(operation, ast.Mult):
        return value, a_dimension + b_dimension
    if isinstance(operation, ast.Div):
        return value, a_dimension - b_dimension
    if a_dimension != b_dimension:
        raise RadiusLawError(
            "The expression adds a length and a plain number, or a length and an area."
            " Write units: 2 mm."
        )
    return value, a_dimension


def _called(name, arguments):
    if len(arguments) != 1:
        raise RadiusLawError(f"The function {name} of the radius expression takes one argument.")
    ((value, dimension),) = arguments
    if name == "sqrt":
        return np.sqrt(value), dimension / 2
    if name not in _FUNCTIONS:
        raise RadiusLawError(
            f"The expression has the unknown function {name}. It may have"
            f" {', '.join(['sqrt', *_FUNCTIONS])}."
        )
    if dimension:
        raise RadiusLawError(
            f"The expression has {name} of a length. Divide it by one first, such as s / L."
        )
    return _FUNCTIONS[name](value), 0
