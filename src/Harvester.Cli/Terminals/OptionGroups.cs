using Harvester.Sessions.Labels;

namespace Harvester.Cli.Terminals;

/// <summary>The groups of options of the commands with many, by subject.</summary>
internal static class OptionGroups
{
    public static IReadOnlyList<OptionGroup> OfHarvest { get; } =
    [
        new("Output", ["--out", "--overwrite", "--resume", "--frames", "--seed", "--shard", "--sync", "--min-free", "--no-report"]),
        new(
            "Images and camera",
            [
                "--size",
                "--image-format",
                "--quality",
                "--fov",
                "--hz",
                "--rig",
                "--calibration",
                "--focal-scale",
                "--centre-offset",
                "--k1",
                "--k2",
            ]
        ),
        new(
            "World",
            [
                "--roads",
                "--log",
                "--props",
                "--near",
                "--places",
                "--weather",
                "--time",
                "--date",
                "--wander",
                "--lane-changes",
                "--traffic",
                "--pedestrians",
                "--parked",
                "--varied-roads",
                "--paint-wear",
                "--crashes",
                "--detail",
            ]
        ),
        new("Objects", ["--classes", "--range", "--ignore-range", "--spaces", "--true-occlusion", "--rays", "--ray-reach"]),
        new(
            "Further data",
            [
                "--masks",
                "--semantics",
                "--materials",
                .. Switches,
                "--imu-noise",
                "--gnss-noise",
                "--birds-eye-size",
                "--birds-eye-cell",
                "--motion",
                "--events",
                "--keep-around",
                "--keep-kinds",
                "--no-scenes",
            ]
        ),
        new("Lanes", ["--look-ahead", "--paint", "--lane-width", "--narrow-lane-width"]),
        new("Pairs of pictures", ["--pair-weathers", "--pair-hours", "--pair-without", "--pair-ticks"]),
        new("Faults of the game", ["--quirks", "--freeze", "--max-picture-lag", "--max-camera-error"]),
    ];

    private static IEnumerable<string> Switches => FrameChannels.All.Select(channel => channel.Switch?.Option).OfType<string>();

    public static IReadOnlyList<OptionGroup> OfDrive { get; } =
    [
        new("Output", ["--out", "--overwrite", "--min-free"]),
        new("Route", ["--seed", "--seeds", "--roads", "--paint", "--near", "--places", "--distance", "--duration", "--jobs"]),
        new("World", ["--traffic", "--weather", "--time", "--date"]),
        new("Controller", ["--controller", "--speed", "--emergency-brake", "--look-ahead", "--noise", "--perturb"]),
        new("Recording", ["--record", "--record-every", "--record-events", "--size"]),
        new("Bridge", ["--bridge", "--role", "--folder", "--at", "--token", "--patience"]),
    ];

    public static IReadOnlyList<OptionGroup> OfScenario { get; } =
    [
        new("Output", ["--out", "--overwrite", "--resume", "--seed", "--seeds", "--no-report"]),
        new("Images", ["--size", "--image-format", "--quality", "--hz", "--detail"]),
        new("World", ["--roads", "--near", "--brake", "--crashes", "--weather", "--time", "--date"]),
        new("Events", ["--events", "--keep-around", "--keep-kinds"]),
        new("Changes", ["--change"]),
    ];

    public static IReadOnlyList<OptionGroup> OfServe { get; } =
    [
        new("Connection", ["--folder", "--address", "--port", "--token", "--once"]),
        new("World", ["--seed", "--roads", "--near", "--traffic", "--traffic-radius", "--weather"]),
        new("Game", ["--size", "--hz", "--duration", "--lockstep", "--unassisted", "--controller", "--emergency-brake"]),
        new("Recording", ["--record", "--record-every", "--record-events", "--overwrite", "--min-free"]),
    ];

    public static IReadOnlyList<OptionGroup> OfExport { get; } =
    [
        new("Output", ["--format", "--out", "--resume", "--shard", "--sync", "--min-free"]),
        new("Splits", ["--split", "--seed", "--split-block"]),
        new(
            "Labels",
            ["--classes", "--map", "--subclasses", "--min-visible", "--parts", "--boxes", "--segmentation", "--lanes", "--roads"]
        ),
        new("Images", ["--images", "--image-format", "--quality"]),
    ];

    public static IReadOnlyList<OptionGroup> OfRelabel { get; } =
    [
        new("Output", ["--out", "--overwrite", "--resume", "--images", "--shard", "--sync", "--min-free", "--no-report"]),
        new("Objects", ["--classes", "--range", "--min-box-area", "--min-box-side", "--max-occluded", "--spaces", "--calibration"]),
        new("Lanes", ["--roads", "--look-ahead", "--paint", "--lane-width", "--narrow-lane-width"]),
    ];
}
