"""What an entry names is read from its own texts."""

from gspot_verified.paper.checks.entry import Check, Rung, Section
from gspot_verified.paper.dependencies import dependencies


def entry(*whats, note="", corrected=""):
    checks = [Check(Rung.EXACT, what, True, "by box.md") for what in whats]
    return Section("Section 4").settled("4-fast", "line 986", "x", "s", *checks, note=note, corrected=corrected)


def test_pages_certificates_and_entries():
    found = dependencies(
        entry("proofs/signs.md: one, with S-iwc", "proofs/iwc_0_1.cert", note="4-order and S-iwc, not 4-fast"),
        ["4-fast", "4-fast-polynomial", "4-order", "S-iwc"],
    )
    assert found.pages == ("signs", "box")
    assert found.certificates == ("iwc_0_1.cert",)
    assert found.entries == ("S-iwc",)
    assert found.see_also == ("4-order",)
    assert set(found.to_json()) == {"pages", "certificates", "entries", "see_also"}


def test_a_longer_identifier_is_not_a_shorter_one():
    for names in (["4-order", "4-order-b"], ["4-order-b", "4-order"]):
        assert dependencies(entry("as in 4-order-b"), names).entries == ("4-order-b",)
        assert dependencies(entry("4-order, 4-order-b"), names).entries == ("4-order", "4-order-b")
        assert dependencies(entry("not-4-order 4-orders"), names).entries == ()


def test_no_other_entry():
    for text in ("x", "x, (y) - z"):
        assert dependencies(entry(text), []).entries == ()
        assert dependencies(entry(text), ["4-fast"]).entries == ()
