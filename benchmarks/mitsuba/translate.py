"""The drt scenes of this folder in Mitsuba 3's terms: the part of drt's YAML format (docs/scene-format.md) that both can render.

Anything else raises: a difference between the pictures must come from the renderers, never from a scene that was half understood.
"""

import math
import tempfile
from pathlib import Path

import mitsuba as mi
import numpy as np
import yaml


def load(path):
    """A drt scene file with what it includes, lists joined as drt joins them."""
    path = Path(path)
    scene = yaml.safe_load(path.read_text())
    included = scene.pop("include", [])
    for name in [included] if isinstance(included, str) else included:
        for key, value in load(path.parent / name).items():
            scene[key] = value + scene.get(key, []) if isinstance(value, list) else value
    return scene


def take(described, **keys):
    """The values of the keys, with these defaults (... = required); any other key is one that nobody translates."""
    unknown = described.keys() - keys.keys() - {"type", "material"}
    if unknown:
        raise ValueError(f"no translation of {sorted(unknown)} in {described}")
    values = [described.get(key, default) for key, default in keys.items()]
    if ... in values:
        raise ValueError(f"missing keys in {described}")
    is_vector = [isinstance(v, list) and not isinstance(v[0], dict) for v in values]
    return [np.array(v, float) if vector else v for v, vector in zip(values, is_vector)]


def unit(v):
    return v / np.linalg.norm(v)


def rgb(value):
    return {"type": "rgb", "value": [float(v) for v in np.broadcast_to(value, 3)]}


def placed(x, y, z, origin):
    """The transform that takes the axes to these vectors and the origin to this point."""
    matrix = np.identity(4)
    matrix[:3, :] = np.column_stack([x, y, z, origin])
    return mi.ScalarTransform4f(matrix)


def rectangle(corner, edge0, edge1):
    """Mitsuba's spans [-1, 1]^2 and faces +z: here along cross(edge0, edge1), as drt's lights do."""
    return {"type": "rectangle",
            "to_world": placed(edge0 / 2, edge1 / 2, unit(np.cross(edge0, edge1)), corner + (edge0 + edge1) / 2)}


def disc(center, normal, radius):
    side = unit(np.cross(normal, np.identity(3)[np.argmin(np.abs(normal))]))
    n = unit(normal)
    return {"type": "disk", "to_world": placed(radius * side, radius * np.cross(n, side), n, center)}


def polygon(corners, folder):
    """A convex polygon as a fan of triangles."""
    path = Path(folder) / f"{len(list(Path(folder).iterdir()))}.obj"
    lines = ["v {:.9g} {:.9g} {:.9g}".format(*c) for c in corners]
    lines += [f"f 1 {i} {i + 1}" for i in range(2, len(corners))]
    path.write_text("\n".join(lines) + "\n")
    return {"type": "obj", "filename": str(path), "face_normals": True}


def turned(orientation):
    axis, degrees = take(orientation, axis=[0, 1, 0], degrees=0)
    return mi.ScalarTransform4f().rotate(unit(np.array(axis, float)).tolist(), degrees)  # it takes unit axes only


def shapes(body, folder):
    """A drt body as one or more Mitsuba shapes."""
    kind = body["type"]
    if kind == "sphere":
        center, radius = take(body, center=[0, 0, 0], radius=1)
        return [{"type": "sphere", "center": center.tolist(), "radius": radius}]
    if kind == "rectangle":
        v0, v1, v2 = take(body, vertex0=..., vertex1=..., vertex2=...)
        along = unit(v1 - v0)
        return [rectangle(v0, v1 - v0, v2 - v0 - along * np.dot(v2 - v0, along))]
    if kind == "parallelogram":
        corner, edge0, edge1 = take(body, corner=..., edge0=..., edge1=...)
        return [polygon([corner, corner + edge0, corner + edge0 + edge1, corner + edge1], folder)]
    if kind == "triangle":
        return [polygon(take(body, vertex0=..., vertex1=..., vertex2=...), folder)]
    if kind == "disc":
        return [disc(*take(body, center=[0, 0, 0], normal=[0, 1, 0], radius=1))]
    if kind == "box":
        center, size, orientation = take(body, center=[0, 0, 0], size=[1, 1, 1], orientation={"degrees": 0})
        to_world = mi.ScalarTransform4f().translate(center.tolist()) @ turned(orientation)
        return [{"type": "cube", "to_world": to_world @ mi.ScalarTransform4f().scale((size / 2).tolist())}]
    if kind == "cylinder":
        begin, end, radius, capped = take(body, **{"from": [0, 0, 0], "to": [0, 1, 0], "radius": 1, "capped": True})
        tube = [{"type": "cylinder", "p0": begin.tolist(), "p1": end.tolist(), "radius": radius}]
        return tube + ([disc(begin, begin - end, radius), disc(end, end - begin, radius)] if capped else [])
    raise ValueError(f"no translation of a {kind}")


def emitter(light):
    """A drt light of falloff inverse_square. Mitsuba's area lights are always bodies, so drt's must be visible."""
    kind = light["type"]
    if kind == "point":
        position, color = take(light, position=[0, 0, 0], color=1)
        return {"type": "point", "position": position.tolist(), "intensity": rgb(color)}
    if light.get("visible") is not True:
        raise ValueError(f"Mitsuba has no invisible area light: {light}")
    if kind == "rectangle":
        corner, edge_x, edge_y, color, _ = take(light, corner=..., edge_x=..., edge_y=..., color=1, visible=True)
        if abs(np.dot(edge_x, edge_y)) > 1e-9:
            raise ValueError(f"Mitsuba's rectangles have right angles: {light}")
        shape = rectangle(corner, edge_x, edge_y)
    elif kind == "sphere":
        center, radius, color, _ = take(light, center=[0, 0, 0], radius=1, color=1, visible=True)
        shape = {"type": "sphere", "center": center.tolist(), "radius": radius}
    else:
        raise ValueError(f"no translation of a light {kind}")
    # drt's lights reflect nothing; Mitsuba's default BSDF would
    return shape | {"emitter": {"type": "area", "radiance": rgb(color)},
                    "bsdf": {"type": "diffuse", "reflectance": rgb(0)}}


def sensor(camera, render):
    position, target, up, fov, lens = take(camera, position=[0, 0, 5], target=[0, 0, 0], up=[0, 1, 0], fov_degrees=45,
                                           lens=None)
    width, height, _, pixel_filter = take(render, width=640, height=480, spp=64, filter={})
    if pixel_filter != {"kind": "box", "radius": 0.5}:
        raise ValueError("only the box filter of one pixel is the same in both")
    result = {"type": "perspective"}
    if lens:
        radius, distance = take(lens, aperture_radius=..., focus_distance=...)
        result = {"type": "thinlens", "aperture_radius": radius, "focus_distance": distance}
    look = [[float(v) for v in vector] for vector in (position, target, up)]
    return result | {
        "fov": fov, "fov_axis": "x",  # drt's angle of view spans the width
        "near_clip": 1e-3, "far_clip": 1e5,
        "to_world": mi.ScalarTransform4f().look_at(origin=look[0], target=look[1], up=look[2]),
        "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "rgb",
                 "component_format": "float32", "rfilter": {"type": "box"}},
        "sampler": {"type": "independent"}}


def diffuse(material):
    _, color = take(material, name=..., diffuse=0.5)
    # drt's bodies are the same from both sides; colours of both are linear with Rec. 709 primaries
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(color)}}


def mitsuba_scene(scene):
    """Mitsuba's scene for a loaded drt scene: light from lights only, no interreflection (which drt does not follow)."""
    version, render, materials, bodies, lights, cameras = take(
        scene, drt=..., render=..., materials=..., bodies=..., lights=..., cameras=...)
    bsdfs = {m["name"]: diffuse(m) for m in materials}
    result = {"type": "scene", "integrator": {"type": "direct"}, "sensor": sensor(cameras[0], render)}
    with tempfile.TemporaryDirectory() as folder:
        for i, body in enumerate(bodies):
            for j, shape in enumerate(shapes(body, folder)):
                result[f"body_{i}_{j}"] = shape | {"bsdf": bsdfs[body["material"]]}
        for i, light in enumerate(lights):
            result[f"light_{i}"] = emitter(light)
        return mi.load_dict(result)
