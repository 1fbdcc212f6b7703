# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes a copy of a glTF file with one fault: break_scene.py IN OUT FAULT."""

import json
import sys

source, target, fault = sys.argv[1:]
with open(source) as file:
    gltf = json.load(file)

if fault == "buffer":
    gltf["buffers"][0]["uri"] = "missing.bin"
elif fault == "camera":
    for node in gltf["nodes"]:
        node.pop("camera", None)
elif fault == "indices":
    primitive = gltf["meshes"][0]["primitives"][0]
    gltf["accessors"][primitive["attributes"]["POSITION"]]["count"] = 3
elif fault == "accessor":
    gltf["meshes"][0]["primitives"][0]["indices"] = 9999
elif fault != "syntax":
    sys.exit(f"unknown fault {fault}")

with open(target, "w") as file:
    if fault == "syntax":
        file.write(json.dumps(gltf)[:500])
    else:
        json.dump(gltf, file)
