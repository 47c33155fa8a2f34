"""Says of each of several JSON documents whether it fits a schema.

Standard input: {"schema": ..., "documents": [...]}; standard output: [true, false, ...]."""

import json
import sys

import jsonschema

known = {}  # what is wrong with a value, by the definition that it was held against and its text: most documents share most values


def ref(validator, reference, value, schema):
    key = (reference, json.dumps(value))
    if key not in known:
        known[key] = list(jsonschema.Draft202012Validator.VALIDATORS["$ref"](validator, reference, value, schema))
    return known[key]


task = json.load(sys.stdin)
jsonschema.Draft202012Validator.check_schema(task["schema"])
validator = jsonschema.validators.extend(jsonschema.Draft202012Validator, {"$ref": ref})(task["schema"])
json.dump([validator.is_valid(document) for document in task["documents"]], sys.stdout)
