"""Copies a session, with markup and script in every text that a page shows."""

import json
import pathlib
import shutil
import sys

ATTACK = '</script><img src=x onerror="window.hacked=1"><script>window.hacked=1</script>\'"&${window.hacked=1}'

if __name__ == "__main__":
    source, target = map(pathlib.Path, sys.argv[1:])
    shutil.copytree(source, target)
    (target / "manifest.jsonl").unlink()
    header = json.loads((target / "session.json").read_text())
    header["manifest"] = False
    header["game"] = ATTACK
    (target / "session.json").write_text(json.dumps(header))
    lines = []
    for line in (target / "labels.jsonl").read_text().splitlines():
        label = json.loads(line)
        label["environment"]["weather"] = ATTACK
        label["ego"]["model"] = ATTACK
        for item in label["objects"]:
            item["model"] = item["name"] = ATTACK
            if item.get("space"):
                item["space"]["mutcd"] = ATTACK
        lines.append(json.dumps(label))
    (target / "labels.jsonl").write_text("\n".join(lines) + "\n")
