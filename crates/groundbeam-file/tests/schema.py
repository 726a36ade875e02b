"""Validates TOML files against JSON Schemas: standard input has lines `SCHEMA<tab>FILE`.

Prints for each file `accepted`, or `refused` and the first reason.
"""

import json
import sys

import jsonschema

try:
    import tomllib
except ModuleNotFoundError:
    import tomli as tomllib


def validator(path: str) -> jsonschema.protocols.Validator:
    with open(path, encoding="utf-8") as file:
        schema = json.load(file)
    kind = jsonschema.validators.validator_for(schema)
    kind.check_schema(schema)
    return kind(schema)


def judged(schema: jsonschema.protocols.Validator, path: str) -> str:
    with open(path, "rb") as file:
        text = file.read()
    try:
        document = tomllib.loads(text.decode())
    except ValueError as error:
        return f"unreadable: {error}"
    error = jsonschema.exceptions.best_match(schema.iter_errors(document))
    if error is None:
        return "accepted"
    return f"refused: {error.json_path}: {error.message}"


validators: dict[str, jsonschema.protocols.Validator] = {}
for line in sys.stdin.read().splitlines():
    schema, path = line.split("\t")
    if schema not in validators:
        validators[schema] = validator(schema)
    print(" ".join(judged(validators[schema], path).split()))
