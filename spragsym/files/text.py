"""Text that users wrote, on any system."""

from __future__ import annotations

import codecs


def decoded(data: bytes) -> str:
    """Text in UTF-8, with a mark at its beginning or without, or in UTF-16 with one, as Windows PowerShell's ``>`` writes it.

    Raises
    ------
    UnicodeDecodeError
        If it is neither.

    Examples
    --------
    >>> decoded("k = 180 N/mm ± 15 %".encode("utf-16"))
    'k = 180 N/mm ± 15 %'
    """
    return data.decode("utf-16" if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)) else "utf-8-sig")
