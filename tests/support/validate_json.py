#!/usr/bin/env python3
"""Validates JSON from stdin against a schema file; says the first thing wrong with its place."""
import json
import sys

import jsonschema

with open(sys.argv[1], encoding="utf-8") as schema_file:
    schema = json.load(schema_file)
value = json.load(sys.stdin)
validator = jsonschema.Draft202012Validator(schema)
errors = sorted(validator.iter_errors(value), key=lambda e: list(map(str, e.path)))
for error in errors[:3]:
    print("%s: %s" % ("/".join(map(str, error.path)) or "(whole)", error.message))
sys.exit(1 if errors else 0)
