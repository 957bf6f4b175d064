"""The rows of the table: what, goal, measured, peer, ratio, command."""

FIGURES = "`figures`"
PICTURES = [
    ("PNG of a frame, 800x600", "faster than OpenCV's level 1, no more bytes", "png", "OpenCV"),
    ("PNG of a 16-bit mask, 800x600", "under 3 ms", "mask", "OpenCV"),
    (
        "JPEG of a frame, 800x600, quality 95, beside one with half the colour resolution",
        "under 6 ms",
        "jpeg",
        "OpenCV",
    ),
    ("JPEG of a frame, 800x600, quality 95, beside one with full colour resolution", "under 6 ms", "jpeg", "Pillow"),
]


def of_harvests(rates, first_frames):
    for (size, masks), (rate, goal) in rates.items():
        name = f"harvest {size}, boxes, faces and lanes" + (", masks" if masks else "")
        command = f"`harvest --seed 3 --size {size}{' --masks' if masks else ''}`"
        yield name, f"{goal} frames/s", f"{rate:.1f} frames/s", "", f"{rate / goal:.2f} of the goal", command
    for tool, seconds in first_frames.items():
        yield f"from command to first frame, {tool} tool", "under 1.0 s", f"{seconds:.2f} s", "", "", "`harvest --frames 1 --size 800x600`"


def of_figures(own, other):
    for count in [10, 100, 1000]:
        measured = f"{own[f'labelling{count}.milliseconds']:.3f} ms, {own[f'labelling{count}.bytes_per_object']:.0f} bytes an object"
        yield f"labels of a frame of {count} objects, no rays", "under 1 ms for 100, linear", measured, "", "", FIGURES
    yield (
        "boxes of an object",
        "no allocation",
        f"{own['box.nanoseconds']:.0f} ns, {own['box.bytes']:.0f} bytes",
        "",
        "",
        FIGURES,
    )
    points = own["projection.points_per_second"]
    for name, key, goal in [("OpenCV's projectPoints", "opencv.points", 90), ("NumPy", "numpy.points", 3)]:
        yield (
            "points projected, one core",
            f"{goal} times {name}",
            f"{points / 1e6:.1f} million/s",
            f"{name} {other[key] / 1e6:.1f} million/s",
            f"{points / other[key]:.1f}",
            FIGURES,
        )
    for name, goal, key, peer in PICTURES:
        time, size = own[f"{key}.milliseconds"], own[f"{key}.bytes"]
        other_time, other_size = other[f"{peer.lower()}.{key}"], other[f"{peer.lower()}.{key}.bytes"]
        yield (
            name,
            goal,
            f"{time:.2f} ms, {size / 1000:.1f} kB",
            f"{peer} {other_time:.2f} ms, {other_size / 1000:.1f} kB",
            f"{time / other_time:.2f} of its time, {size / other_size:.2f} of its bytes",
            FIGURES,
        )
    yield "rays of the simulation, one core", "1 million/s", f"{own['rays.per_second'] / 1e6:.2f} million/s", "", "", FIGURES
    yield "a mask of 800x600, besides its rays", "under 10 ms", f"{own['map.own_milliseconds']:.1f} ms", "", "", FIGURES
    yield "flow of 800x600 in both directions, one core", "under 15 ms", f"{own['flow.milliseconds']:.1f} ms", "", "", FIGURES
    yield (
        "voxels around the vehicle, 200 x 200 x 16, filled once a moment, one core",
        "under 40 ms",
        f"{own['occupancy.milliseconds']:.1f} ms",
        "",
        "",
        FIGURES,
    )
    yield "which voxels a camera of 800x600 sees", "", f"{own['occupancy.sight.milliseconds']:.1f} ms", "", "", FIGURES
    yield from of_roads(own)


def of_roads(own):
    if "roads.links" not in own:
        yield (
            "full road network",
            "loaded in under 0.5 s; a match under 3 microseconds",
            "skipped: GTADATAHARVESTER_REALWORLD is not set",
            "",
            "",
            FIGURES,
        )
        return
    yield (
        f"road network of {own['roads.links']:.0f} links, loaded from our own file",
        "under 0.5 s",
        f"{own['roads.load.seconds']:.2f} s",
        "",
        "",
        FIGURES,
    )
    yield "match of a place with the roads", "under 3 microseconds", f"{own['roads.match.microseconds']:.1f} microseconds", "", "", FIGURES


def of_datasets(costs, short, long, goal):
    for name in ["export --format kitti", "export --format coco", "validate", "stats"]:
        rate = long / costs[name][1].seconds
        yield (
            f"`{name}`, {long} frames, linked pictures",
            f"{goal} frames/s",
            f"{rate:.0f} frames/s",
            "",
            f"{rate / goal:.2f} of the goal",
            f"`{name}`",
        )
    for name, (few, many) in costs.items():
        yield (
            f"memory of `{name}`, {short} and {long} frames",
            "the same",
            f"{few.megabytes:.0f} and {many.megabytes:.0f} MB",
            "",
            f"{many.megabytes / few.megabytes:.2f}",
            f"`{name}`",
        )


def of_harvest_memory(few, many):
    yield (
        f"memory of `harvest`, {few[0]} and {many[0]} frames of 280x210",
        "the same",
        f"{few[1].megabytes:.0f} and {many[1].megabytes:.0f} MB",
        "",
        f"{many[1].megabytes / few[1].megabytes:.2f}",
        "`harvest`",
    )


def of_report(cost, size, frames):
    measured = f"{size / 1e6:.1f} MB, {cost.seconds:.1f} s"
    yield f"report of {frames} frames of 800x600", "under 15 MB, in under 20 s", measured, "", "", f"`report --frames {frames}`"
