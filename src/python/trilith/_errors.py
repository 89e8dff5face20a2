"""What can go wrong."""

from __future__ import annotations


class CaseError(ValueError):
    """A case, a method or a setting that the program refuses.

    Its text is the program's own: file, line, what is wrong and what to write instead.
    """


class ProgramError(RuntimeError):
    """The program is missing, of another version, or was ended from outside."""
