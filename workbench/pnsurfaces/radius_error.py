# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with a radius law."""


class RadiusLawError(ValueError):
    """The properties describe no radius law. The text is a sentence for the user."""
