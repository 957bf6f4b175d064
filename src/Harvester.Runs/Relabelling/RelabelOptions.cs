using Harvester.Datasets.Files;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Runs.Relabelling;

/// <summary>Options of relabelling. What is null stays as recorded.</summary>
public sealed record RelabelOptions
{
    /// <summary>The classes to label.</summary>
    public IReadOnlyList<ObjectClass>? Classes { get; init; }

    /// <summary>Distance up to which objects are labelled, metres; at most the recorded one.</summary>
    public double? RangeMetres { get; init; }

    /// <summary>Smallest area of the 2D box of labelled objects, square pixels.</summary>
    public double? MinBoxAreaPixels { get; init; }

    /// <summary>Smallest width and height of the 2D box of labelled objects, pixels.</summary>
    public double? MinBoxSidePixels { get; init; }

    /// <summary>Largest occluded fraction of labelled objects, 0 to 1.</summary>
    public double? MaxOccludedFraction { get; init; }

    /// <summary>The calibrated lens.</summary>
    public Lens? Lens { get; init; }

    /// <summary>Table of faces that takes precedence over the recorded one, model by model.</summary>
    public FaceTable? Faces { get; init; }

    /// <summary>Name of its file, for session.json.</summary>
    public string? FacesName { get; init; }

    /// <summary>The road network.</summary>
    public RoadNetwork? Roads { get; init; }

    /// <summary>Name of its file, for session.json.</summary>
    public string? RoadsName { get; init; }

    /// <summary>Look-ahead of the lane indicators.</summary>
    public LookAhead? LookAhead { get; init; }

    /// <summary>Lane width of ordinary roads, metres.</summary>
    public double? LaneWidthMetres { get; init; }

    /// <summary>Lane width of narrow roads, metres.</summary>
    public double? NarrowLaneWidthMetres { get; init; }

    /// <summary>The lines measured on the roads, those of <see cref="Roads"/> or else the recorded ones; null for none.</summary>
    public PaintTable? Paint { get; init; }

    /// <summary>Name of their file, for session.json.</summary>
    public string? PaintName { get; init; }

    /// <summary>Whether images are linked or copied.</summary>
    public ImageTransfer Images { get; init; }

    /// <summary>When to wait for the disk.</summary>
    public SyncMode Sync { get; init; }

    /// <summary>Whether to keep the frames that a stopped run of the same command finished in the folder.</summary>
    public bool Resume { get; init; }

    /// <summary>Space that stays free on the disk, bytes, unless a session is replaced. 0 watches nothing.</summary>
    public long MinFreeBytes { get; init; }

    /// <summary>The shard to process.</summary>
    public Shard Shard { get; init; } = Shard.Whole;
}
