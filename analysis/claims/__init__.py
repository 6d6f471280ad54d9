"""The ledger of published claims: each is tested by a computation, none by hand.

The words are in report/claims.toml, the tests in the modules beside this one,
each a pure function from Evidence to a Finding, and `ledger` joins the two.
"""
