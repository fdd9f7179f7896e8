"""What earlier runs leave behind, made by hand: entries of the ledger's cache, the record of the formal proofs.

Under ``--full`` nothing that was made before may be believed; a damaged file never.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import tempfile
from pathlib import Path
from random import Random
from typing import Any

from attack.answers import AGREED, Answer, Attack, wrong

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.cache import FORMAT, Cache
from gspot_verified.paper.checks.entry import Check, Entry, Rung, conclude
from gspot_verified.paper.checks.formal_proof import COQ, ProofRun, formal_proof, run_proofs

_SOURCES = Path(__file__).parent


def attack(random: Random) -> Attack:
    """A cache entry or a record."""
    return random.choice((_entry, _entry, _full, _record))(random)


def _true_entry(random: Random) -> Entry:
    checks = tuple(
        Check(random.choice(list(Rung)), f"check {k}", random.random() < 0.6, f"finding {random.random()}")
        for k in range(2)
    )
    names = ("identifier", "label", "section", "source", "statement", "corrected", "note", "code")
    texts: dict[str, Any] = {name: f"a {name}" for name in names} | {"identifier": "S-attack"}
    return Entry(**texts, checks=checks, verdict=conclude(texts["statement"], checks))


def _kept(folder: Path, random: Random) -> tuple[Path, Entry] | None:
    """A whole entry that the cache itself has written."""
    for _ in range(20):
        entry = _true_entry(random)
        if entry.verdict.outcome is Outcome.UNDECIDED:
            continue
        cache = Cache(folder, sources=(_SOURCES,))
        cache.closed = ""
        cache.keep(entry)
        found = list(folder.rglob("*.json"))
        if found:
            return found[0], entry
    return None


def _entry(random: Random) -> Attack:
    """One value of the file is changed, its digest or its verdict at times made anew."""
    seed, sealed = random.getrandbits(32), random.random() < 0.6

    def ask() -> Answer:
        rng = Random(seed)
        with tempfile.TemporaryDirectory() as folder:
            made = _kept(Path(folder), rng)
            assert made is not None
            place, entry = made
            data = json.loads(place.read_text())
            what = _forge(data, rng)
            if sealed:
                text = json.dumps(data["entry"], sort_keys=True)
                data["sha256"] = hashlib.sha256(text.encode()).hexdigest()
            place.write_text(json.dumps(data, sort_keys=True) + "\n")
            cache = Cache(Path(folder), sources=(_SOURCES,))
            cache.closed = ""
            found = cache.recall("S-attack")
            if found is None or (found.verdict == entry.verdict and found.checks == entry.checks):
                return AGREED
            if found.verdict == conclude(found.statement, found.checks) and sealed and what == "checks":
                return AGREED  # a whole entry under the right hash: only --full does without such files
            return wrong(f"recalled after {what} was forged: {found.verdict}, kept: {entry.verdict}")

    return Attack(f"Cache.recall of a forged file, seed {seed}, sealed anew: {sealed}", ask)


def _forge(data: dict[str, Any], random: Random) -> str:
    entry = data["entry"]
    what = random.choice(("verdict", "checks", "statement", "key", "format", "identifier"))
    if what == "verdict":
        entry["verdict"]["outcome"] = random.choice(
            [o.value for o in Outcome if o.value != entry["verdict"]["outcome"]]
        )
    elif what == "checks":
        check = random.choice(entry["checks"])
        check["agrees"] = not check["agrees"]
    elif what in ("key", "format"):
        data[what] = "0" * 64 if what == "key" else f"{FORMAT}0"
    else:
        entry[what] = "S-other"
    return what


def _full(random: Random) -> Attack:
    """With ``read=False`` even a whole entry is not recalled."""
    seed = random.getrandbits(32)

    def ask() -> Answer:
        with tempfile.TemporaryDirectory() as folder:
            assert _kept(Path(folder), Random(seed)) is not None
            cache = Cache(Path(folder), read=False, sources=(_SOURCES,))
            cache.closed = ""
            return AGREED if cache.recall("S-attack") is None else wrong("recalled although nothing may be read")

    return Attack(f"Cache(read=False).recall, seed {seed}", ask)


def _record(random: Random) -> Attack:
    """A record written by hand for the sources as they are, without any run of Coq."""
    name = random.choice(("theta_unique", "theta_ode", "is_Theta"))
    axioms = random.choice((["Classical_Prop.classic"], [], ["Attack.everything_is_true"]))
    failing = random.choice((True, False))

    def ask() -> Answer:
        names = _theorems()
        chosen = names[hash_of(name) % len(names)]
        with tempfile.TemporaryDirectory() as folder:
            coq, build = Path(folder) / "proofs" / "coq", Path(folder) / "build" / "coq"
            shutil.copytree(COQ, coq)
            build.mkdir(parents=True)
            sources = {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in coq.glob("*.v")}
            (build / "record.json").write_text(json.dumps({"sources": sources, "theorems": {chosen: axioms}}))
            (coq / "prove.py").write_text(f"print('{chosen}: no axiom')\nraise SystemExit(1)\n")
            found = formal_proof([chosen], run_proofs(coq) if failing else ProofRun(), coq)
            return wrong(f"a record made by hand: {found.state} for {chosen}") if found.run else AGREED

    return Attack(f"formal_proof with a record made by hand, axioms {axioms}", ask)


def hash_of(text: str) -> int:
    """The same in every process."""
    return int(hashlib.sha256(text.encode()).hexdigest()[:8], 16)


def _theorems() -> list[str]:
    import re

    return re.findall(r"^Definition (\w+) : Prop", (COQ / "Statement.v").read_text(encoding="utf-8"), re.M)
