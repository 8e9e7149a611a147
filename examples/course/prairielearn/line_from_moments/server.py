"""Exercise 3.7 as a question of PrairieLearn; another number makes one of another exercise."""

from __future__ import annotations

import json
from base64 import b64decode
from typing import Any

import chasles
from chasles.exercises.data import DataError, read_json

EXERCISE, DIGITS, VARIANTS = "3.7", 4, 10**6


def generate(data: dict[str, Any]) -> None:
    """The task of the variant."""
    seed = int(data["variant_seed"]) % VARIANTS
    whole = chasles.practice(EXERCISE, seed).as_data()
    data["params"] = {
        "seed": seed,
        "title": whole["title"],
        "asked": whole["asked"],
        "numbers": whole["conventions"][-1],
        "data": [
            {"name": name, "value": json.dumps(value), "is": whole["data_are"][name]}
            for name, value in whole["data"].items()
        ],
        "answers": [{"name": name, **answer} for name, answer in whole["answers"].items()],
        "template": json.dumps(whole["template"], indent=1),
    }


def parse(data: dict[str, Any]) -> None:
    """What is malformed is told before it is graded, and costs no attempt."""
    if data["format_errors"]:
        return  # The file editor has told what is missing.
    try:
        _grade(data)
    except (DataError, LookupError, ValueError) as error:
        data["format_errors"]["answer.json"] = str(error)


def grade(data: dict[str, Any]) -> None:
    """A score for each part, and which steps give what is wrong."""
    found = _grade(data)
    names = (*found.right, *found.wrong, *found.undecided, *found.missing)
    data["partial_scores"] = {name: {"score": float(name in found.right)} for name in names}
    data["score"] = found.score
    data["feedback"]["parts"] = [{"name": name, "says": " ".join(says)} for name, says in found.feedback.items()]


def _grade(data: dict[str, Any]) -> Any:
    (file,) = (file for file in data["submitted_answers"]["_files"] if file["name"] == "answer.json")
    answers = read_json(b64decode(file["contents"]).decode("utf-8"))
    return chasles.practice(EXERCISE, data["params"]["seed"]).grade(answers, digits=DIGITS)
