"""Certificates of proved values, which a program that shares no code with the library checks in integers."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

from .errors import UndecidedError


def check(certificate: str | PathLike[str]) -> str:
    """What the certificate in a file proves, in words: the equations, and the intervals in which the values lie. Raises
    UndecidedError with the first step and condition that fails. The same as `python3 -I check/libration_check.py FILE`.
    """
    from . import libration_check

    try:
        return str(libration_check.check(libration_check.text_of(Path(certificate).read_bytes())))
    except libration_check.Malformed as reason:
        message = f"is not a certificate ({reason})"
        raise UndecidedError(f"{certificate} {message}", "certificate", str(certificate), message) from None
    except libration_check.Refused as reason:
        raise UndecidedError(f"{certificate} is not proved: {reason}", "certificate", str(certificate), str(reason)) from None
