"""Two-wheelers with their riders as one object."""
import itertools

import numpy as np


def joined(label):
    """The objects of a frame; those whose riders have a label enclose them, and riders without a vehicle of the frame are left out."""
    for item in label["objects"]:
        if item["class"] != "rider":
            riders = [
                other for other in label["objects"] if other["class"] == "rider" and other["vehicle"] == item["id"]
            ]
            yield {
                **item,
                "members": [item["id"], *(rider["id"] for rider in riders)],
                **enclosing(item, riders),
            } if riders else {**item, "members": [item["id"]]}
        else:
            assert item["vehicle"] != item["id"]


def enclosing(vehicle, riders):
    """The boxes around a vehicle and its riders: in the image, and in the world with the axes of the vehicle."""
    visible = [item["box2dVisible"] for item in [vehicle, *riders] if item["box2dVisible"]]
    own = axes_of(vehicle)
    corners = np.array(
        [
            (np.array(item["box3d"]["centre"]) + (np.array(signs) * item["box3d"]["halfExtents"]) @ axes_of(item))
            @ own.T
            for item in [vehicle, *riders]
            for signs in itertools.product((-1, 1), repeat=3)
        ]
    )
    low, high = corners.min(axis=0), corners.max(axis=0)
    return {
        "box2dVisible": [*np.min(visible, axis=0)[:2], *np.max(visible, axis=0)[2:]] if visible else None,
        "box3d": {
            **vehicle["box3d"],
            "centre": ((low + high) / 2 @ own).tolist(),
            "halfExtents": ((high - low) / 2).tolist(),
        },
    }


def axes_of(item):
    """The axes of a box as rows: right, forward, up."""
    return np.array([item["box3d"][name] for name in ("right", "forward", "up")])
