"""Certificates of a report, and that a changed one is found."""

import json
import os
import shutil

import pytest

from gspot_verified.certificates.checker import check
from gspot_verified.report import certificates
from gspot_verified.report.certificates import checked_certificates
from gspot_verified.report.check_again import check_report
from gspot_verified.report.data import report_data
from gspot_verified.report.parts.proof_page import PROOFS

NAMES = ("force_5_2.cert", "iwc_0_1.cert", "lift_off_5_2.cert")


@pytest.fixture
def folder(tmp_path):
    """A report with three certificates, as written."""
    (tmp_path / "certificates").mkdir()
    for name in NAMES:
        shutil.copy(PROOFS / name, tmp_path / "certificates")
    found = checked_certificates(tmp_path / "certificates")
    (tmp_path / "report.json").write_text(json.dumps(report_data([], [], found)), encoding="utf-8")
    return tmp_path


def test_the_checker_is_asked(folder):
    said = []
    found = checked_certificates(folder / "certificates", said.append)
    assert [certificate.name for certificate in found] == list(NAMES)
    assert said == [f"checking {name}" for name in NAMES]
    assert all(certificate.verified and certificate.said.startswith("VERIFIED ") for certificate in found)
    assert found[1].said == "VERIFIED dΘ/dτ < 0 for every τ in (-inf, inf) and every β in (0, 1)"


def test_a_report_as_written_passes(folder):
    assert [(result.name, result.same) for result in check_report(folder)] == [(name, True) for name in NAMES]


def test_what_is_shown_is_what_was_checked(folder, monkeypatch):
    """Whoever changes the file while the checker begins does not change what it checks."""
    path = folder / "certificates" / NAMES[1]
    true = path.read_bytes()
    path.write_bytes(true.replace(b'"sign":-1', b'"sign":1'))

    def check_with_the_true_file_back(file):
        path.write_bytes(true)
        return check(file)

    monkeypatch.setattr(certificates, "check", check_with_the_true_file_back)
    found = certificates.checked(path)
    assert found.content != true
    assert not found.verified
    assert found.said == "REJECTED the hash does not match"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="a system without named pipes")
def test_a_pipe_in_the_place_of_a_certificate_is_missing(folder):
    """To read it would wait for a writer, for ever."""
    place = folder / "certificates" / NAMES[1]
    place.unlink()
    os.mkfifo(place)
    (folder / "certificates" / "folder.cert").mkdir()
    found = check_report(folder)
    assert [(result.name, result.same) for result in found] == [(name, name != NAMES[1]) for name in NAMES]
    assert found[1].said == "the file is missing"


def test_a_changed_a_missing_and_an_added_certificate_fail(folder):
    place = folder / "certificates"
    text = (place / NAMES[0]).read_text(encoding="utf-8")
    (place / NAMES[0]).write_text(text.replace("4/5", "9/5", 1), encoding="utf-8")
    (place / NAMES[1]).unlink()
    (place / "other.cert").write_text("x")
    found = {result.name: result for result in check_report(folder)}
    assert [name for name in found if found[name].same] == [NAMES[2]]
    assert found[NAMES[0]].said.startswith("another file than the report names; now: ")
    assert found[NAMES[1]].said == "the file is missing"
    assert found["other.cert"].said.startswith("the report does not name it; REJECTED")


def test_a_report_that_says_verified_of_a_bad_certificate_fails(folder):
    """The checker decides, not the report."""
    import hashlib

    place = folder / "certificates" / NAMES[0]
    place.write_bytes(place.read_bytes().replace(b'"4/5"', b'"9/5"', 1))
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    report["certificates"][0]["sha256"] = hashlib.sha256(place.read_bytes()).hexdigest()
    (folder / "report.json").write_text(json.dumps(report), encoding="utf-8")
    first = check_report(folder)[0]
    assert first.name == NAMES[0]
    assert not first.same


@pytest.mark.parametrize(
    ("content", "message"), [(None, "there is no file"), ("{}", "reads schema"), ("[", "Expecting")]
)
def test_what_is_no_report_is_refused(tmp_path, content, message):
    if content is not None:
        (tmp_path / "report.json").write_text(content)
    with pytest.raises(ValueError, match=message):
        check_report(tmp_path)


def test_a_report_without_certificates_is_no_pass(tmp_path):
    (tmp_path / "report.json").write_text(json.dumps(report_data([], [])), encoding="utf-8")
    with pytest.raises(ValueError, match="names no certificate"):
        check_report(tmp_path)
