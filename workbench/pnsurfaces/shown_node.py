# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Coin node that is drawn with an object for a while."""


class ShownNode:
    """Puts a node among those of a view object, in the object's coordinates, and takes it away."""

    def __init__(self, view_object, node, name):
        """`name` is how the node is found."""
        self._root = view_object.RootNode
        self._node = node
        self._node.setName(name)
        self._is_shown = False

    def show(self):
        if not self._is_shown:
            self._root.addChild(self._node)
            self._is_shown = True

    def hide(self):
        if self._is_shown:
            self._root.removeChild(self._node)
            self._is_shown = False
