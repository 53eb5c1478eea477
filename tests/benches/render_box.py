"""Mitsuba's part of `cargo bench -p tests --bench mitsuba`.

The first line of the input is the scene, in JSON. For each further line, 1 for roulette or 0 for none, one picture is
rendered, and answered by a line: seconds, and the mean of red, green and blue.
"""

import json
import sys
import time

import mitsuba as mi
import numpy as np

mi.set_variant(sys.argv[1])
scene = json.loads(sys.stdin.readline())


def color(rgb):
    return {"type": "rgb", "value": rgb}


def mesh(albedo, triangles):
    """The triangles of one color. They are matte on both sides."""
    props = mi.Properties()
    props["bsdf"] = mi.load_dict({"type": "twosided", "b": {"type": "diffuse", "reflectance": color(albedo)}})
    mesh = mi.Mesh("part", len(scene["positions"]), len(triangles), props=props)
    params = mi.traverse(mesh)
    params["vertex_positions"] = np.array(scene["positions"], dtype=np.float32).ravel()
    params["faces"] = np.array(triangles, dtype=np.uint32).ravel()
    params.update()
    return mesh


def box(roulette):
    """The whole scene. Mitsuba's roulette begins at depth 5; at a depth that no path has, it never does."""
    rr_depth = 5 if roulette else 1000
    film = {"type": "hdrfilm", "width": scene["width"], "height": scene["height"], "rfilter": {"type": "box"}}
    look = mi.ScalarTransform4f().look_at(origin=scene["eye"], target=scene["aim"], up=[0, 1, 0])
    parts = {f"part{i}": mesh(**part) for i, part in enumerate(scene["parts"])}
    return mi.load_dict({
        "type": "scene",
        "integrator": {"type": "path", "max_depth": scene["depth"], "rr_depth": rr_depth},
        "sensor": {
            "type": "perspective",
            "fov": scene["field_of_view"],
            "to_world": look,
            "film": {**film, "pixel_format": "rgb"},
            "sampler": {"type": "independent"},
        },
        "lamp": {"type": "point", "position": scene["lamp"], "intensity": color(scene["intensity"])},
        **parts,
    })


boxes = [box(False), box(True)]
for seed, line in enumerate(sys.stdin):
    start = time.perf_counter()
    picture = np.array(mi.render(boxes[int(line)], spp=scene["samples"], seed=seed))
    seconds = time.perf_counter() - start
    print(seconds, *picture.mean((0, 1)), flush=True)
