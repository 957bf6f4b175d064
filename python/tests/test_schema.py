"""The published JSON Schemas: complete, strict, and kept by what is harvested."""

from __future__ import annotations

import copy
import json
import re
from pathlib import Path
from typing import Any, Dict, Iterator, Set, Tuple

import pytest
from conftest import ROOT, HandmadeSession

jsonschema = pytest.importorskip("jsonschema")

SCHEMAS = {
    name: json.loads((ROOT / f"docs/schema/{name}.schema.json").read_text(encoding="utf-8"))
    for name in ("label", "session")
}


def validator(name: str) -> Any:
    return jsonschema.Draft202012Validator(SCHEMAS[name])


def objects_of(schema: Any) -> Iterator[Dict[str, Any]]:
    """All parts of a schema that describe an object with named fields."""
    if isinstance(schema, dict):
        if "properties" in schema and schema.get("type") == "object":
            yield schema
        for part in schema.values():
            yield from objects_of(part)
    elif isinstance(schema, list):
        for part in schema:
            yield from objects_of(part)


@pytest.mark.parametrize("name", SCHEMAS)
def test_schemas_are_valid_and_refuse_unknown_fields(name: str) -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMAS[name])
    for part in objects_of(SCHEMAS[name]):
        assert part["additionalProperties"] is False
        assert set(part["required"]) <= set(part["properties"])


def test_both_schemas_describe_the_same_camera() -> None:
    for part in ("camera", "vector", "unitVector"):
        assert SCHEMAS["label"]["$defs"][part] == SCHEMAS["session"]["$defs"][part]


def test_every_field_is_in_the_docs() -> None:
    text = "".join(
        (ROOT / f"docs/{page}.md").read_text(encoding="utf-8")
        for page in ("dataset-format", "lanes", "rigs", "imu", "radar")
    )
    described = {word for code in re.findall(r"`([^`\n]+)`", text) for word in re.findall(r"\w+", code)}
    fields = {field for schema in SCHEMAS.values() for part in objects_of(schema) for field in part["properties"]}
    assert fields - described == set()


@pytest.mark.parametrize(
    "change, place",
    [
        (lambda line: line.update(extra=1), ()),
        (lambda line: line["objects"][0].update(extra=1), ("objects", 0)),
        (lambda line: line["objects"][0].update({"class": "tank"}), ("objects", 0, "class")),
        (lambda line: line["objects"][0].update(visibleFraction=1.5), ("objects", 0, "visibleFraction")),
        (lambda line: line["objects"][0].update(box2d=[1, 2, 3]), ("objects", 0, "box2d")),
        (lambda line: line["objects"][0].pop("velocity"), ("objects", 0)),
        (lambda line: line["camera"].pop("cx"), ("camera",)),
        (lambda line: line.update(frame=-1), ("frame",)),
    ],
)
def test_wrong_labels_are_refused(handmade: HandmadeSession, change: Any, place: Any) -> None:
    line = copy.deepcopy(handmade.lines[0])
    assert validator("label").is_valid(line)
    change(line)
    assert place in {tuple(error.path) for error in validator("label").iter_errors(line)}


Field = Tuple[str, ...]

# What the simulated game and these sessions do not have: GTA V reads lists, knows its edition and build, can draw over the pictures and has
# a display; its maps of normals and of flow are from rays. Only it and a real network have props of a file. A resumed session can report faults.
ONLY_ELSEWHERE = {
    ("session", "reading"),
    ("session", "pictures"),
    ("session", "pictures", "warning"),
    *(
        ("session", "start", *names)
        for names in (
            ("display",),
            ("display", "state"),
            ("display", "region"),
            ("colours",),
            ("colours", "state"),
            ("colours", "grey192"),
            ("colours", "grey128"),
        )
    ),
    ("label", "$defs", "rays", "normals"),
    ("label", "$defs", "rays", "flow"),
    ("label", "$defs", "flow", "errorPixels"),
    *(("session", "settings", name) for name in ("gameEdition", "gameBuild", "scriptApi", "props")),
}


def fields_of(schema: Dict[str, Any], name: str) -> Iterator[Field]:
    """All fields that a schema has: the path of each from the root, or from the definition it is in."""
    yield from inner_fields(schema, (name,))
    for key, part in schema["$defs"].items():
        yield from inner_fields(part, (name, "$defs", key))


def inner_fields(part: Any, path: Field) -> Iterator[Field]:
    if isinstance(part, dict):
        for name, inner in part.get("properties", {}).items():
            yield (*path, name)
            yield from inner_fields(inner, (*path, name))
        for key in ("items", "anyOf"):
            yield from inner_fields(part.get(key), path)
    elif isinstance(part, list):
        for each in part:
            yield from inner_fields(each, path)


def used_fields(schema: Dict[str, Any], part: Any, value: Any, path: Field) -> Iterator[Field]:
    """The fields that a valid value has, named as fields_of names them."""
    for each in part.get("anyOf", ()):
        if "$ref" in each and value is not None:
            part = each
    if "$ref" in part:
        definition = part["$ref"].split("/")[-1]
        yield from used_fields(schema, schema["$defs"][definition], value, (path[0], "$defs", definition))
    elif isinstance(value, list):
        for each in value:
            yield from used_fields(schema, part["items"], each, path)
    elif isinstance(value, dict):
        for name, inner in value.items():
            if name in part.get("properties", {}):
                yield (*path, name)
                yield from used_fields(schema, part["properties"][name], inner, (*path, name))


def test_harvests_conform_and_have_every_field(harvests: Path) -> None:
    used: Set[Field] = set()
    folders = sorted(path.parent for path in harvests.glob("*/session.json"))
    assert len(folders) >= 5
    for folder in folders:
        documents = [("session", json.loads((folder / "session.json").read_text(encoding="utf-8")))]
        lines = (folder / "labels.jsonl").read_text(encoding="utf-8").splitlines()
        documents += [("label", json.loads(line)) for line in lines]
        for name, document in documents:
            assert [
                f"{list(error.path)}: {error.message}" for error in validator(name).iter_errors(document)
            ] == [], folder
            used.update(used_fields(SCHEMAS[name], SCHEMAS[name], document, (name,)))
    missing = {field for name, schema in SCHEMAS.items() for field in fields_of(schema, name)} - used
    assert {field for field in missing if field[:2] != ("session", "reading")} | {
        ("session", "reading")
    } == ONLY_ELSEWHERE
