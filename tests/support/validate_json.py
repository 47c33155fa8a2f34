"""Says of each of several JSON documents whether it fits a schema.

Standard input: {"schema": ..., "documents": [...]}; standard output: [true, false, ...]."""

import json
import sys

import jsonschema

task = json.load(sys.stdin)
jsonschema.Draft202012Validator.check_schema(task["schema"])
validator = jsonschema.Draft202012Validator(task["schema"])
json.dump([validator.is_valid(document) for document in task["documents"]], sys.stdout)
