"""Faults that end a command."""

from __future__ import annotations


class Failure(Exception):
    """Something that the user has to know or change; printed without a trace."""
