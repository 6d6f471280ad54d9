"""How the tests choose examples: the same ones in every run.

A test that fails by chance says nothing about the change that it stops. New
examples are looked for on purpose: `pytest --hypothesis-profile=explore`.
"""

from __future__ import annotations

from hypothesis import settings

settings.register_profile("repeatable", derandomize=True, deadline=None)
settings.register_profile("explore", max_examples=1000, deadline=None)
settings.load_profile("repeatable")
