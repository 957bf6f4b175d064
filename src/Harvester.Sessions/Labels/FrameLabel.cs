using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>One line of labels.jsonl: everything known about one frame.</summary>
/// <param name="Frame">Number of the frame in its session, from 0.</param>
/// <param name="GameFrame">The game's frame count.</param>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="LagFrames">
/// Game frames from reading the state to grabbing the image, which nevertheless shows the moment of the state; 0 if the game was frozen.
/// </param>
/// <param name="LagSeconds">Game time from reading the state to grabbing the image, seconds.</param>
/// <param name="Image">Path of the image within the session, with forward slashes.</param>
/// <param name="Mask">Path of the instance mask within the session; null without pixel maps.</param>
/// <param name="Camera">The camera of the saved image.</param>
/// <param name="Ego">The vehicle that carries the camera.</param>
/// <param name="Environment">Weather and time of day.</param>
/// <param name="Objects">The objects in the image, in the order of their ids.</param>
public sealed record FrameLabel(
    int Frame,
    long GameFrame,
    double TimeSeconds,
    int LagFrames,
    double LagSeconds,
    string Image,
    string? Mask,
    CameraLabel Camera,
    EgoLabel Ego,
    EnvironmentState Environment,
    IReadOnlyList<ObjectLabel> Objects
)
{
    /// <summary>Paths within the session of the files that the label names: image, mask, and the files of the channels.</summary>
    public IEnumerable<string> Files => [Image, .. Mask is null ? [] : new[] { Mask }, .. Channels.Files];

    /// <summary>What the channels say of the frame.</summary>
    public ChannelLabels Channels { get; init; } = ChannelLabels.None;

    /// <summary>Number of the moment, from 0; null unless the session was harvested with a rig, whose views are frames.</summary>
    public int? Moment { get; init; }

    /// <summary>Name of the camera of the rig; null without a rig.</summary>
    public string? View { get; init; }

    /// <summary>Number of the place that the session visits, from 0; null if it visits no places.</summary>
    public int? Place { get; init; }

    /// <summary>Number of the frame among those of its place, from 0; null if the session visits no places.</summary>
    public int? PlaceFrame { get; init; }

    /// <summary>The accuracy of the mask; null without a mask and for an imported one.</summary>
    public PixelMapLabel? PixelMap { get; init; }

    /// <summary>The class map; null without one.</summary>
    public ClassMapLabel? ClassMap
    {
        get => Channels.Get<ClassMapLabel>();
        init => Channels = Channels.With(value);
    }

    /// <summary>The depth maps; null without any.</summary>
    public DepthLabel? Depth
    {
        get => Channels.Get<DepthLabel>();
        init => Channels = Channels.With(value);
    }

    /// <summary>What the LiDARs of the rig saw at the moment; empty except in the frame of its first view.</summary>
    public IReadOnlyList<SweepLabel> Lidar
    {
        get => Channels.Get<SweepsLabel>()?.Sweeps ?? [];
        init => Channels = Channels.With(value is { Count: > 0 } ? new SweepsLabel(value) : null);
    }

    /// <summary>
    /// The ego at the ticks since the frame, or moment, before; empty if it is the first. Null unless motion is recorded, and in all but
    /// the first view of a moment.
    /// </summary>
    public IReadOnlyList<MotionSample>? Motion { get; init; }

    /// <summary>The events that are open at the moment of the frame, by ascending id; null if events are not recorded.</summary>
    public IReadOnlyList<EventMark>? Events { get; init; }

    /// <summary>The action that belongs to the frame; null unless the session is a recorded drive.</summary>
    public DriveLabel? Drive { get; init; }

    /// <summary>Further pictures of the moment in other weathers, at other hours and without objects; empty if there are none.</summary>
    public IReadOnlyList<PairLabel> Pairs
    {
        get => Channels.Get<PairsLabel>()?.Pairs ?? [];
        init => Channels = Channels.With(value is { Count: > 0 } ? new PairsLabel(value) : null);
    }

    /// <summary>Regions that show, or may show, objects without a label, the nearest first.</summary>
    public IReadOnlyList<IgnoreRegion> IgnoreRegions { get; init; } = [];

    /// <summary>The rays used for the labels; null if unknown.</summary>
    public RayCounts? Rays { get; init; }

    /// <summary>The lanes; null if no roads are known.</summary>
    public LanesLabel? Lanes { get; init; }
}
