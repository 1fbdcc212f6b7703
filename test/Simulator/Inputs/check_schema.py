# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""check_schema.py SCHEMA FILE...: checks JSON files against a JSON schema."""

import json
import sys

import jsonschema


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


schema = load(sys.argv[1])
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for path in sys.argv[2:]:
    for error in validator.iter_errors(load(path)):
        place = "/".join(str(step) for step in error.absolute_path)
        sys.exit(f"{path}: {place}: {error.message}")
print("all files are as the schema says")
