using System.Collections.Generic;
using Harvester.Datasets.Files;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Relabelling;

/// <summary>What is to be labelled otherwise than it was; what is null stays as the session has it.</summary>
public sealed record RelabelOptions
{
    /// <summary>The classes.</summary>
    public IReadOnlyList<ObjectClass>? Classes { get; init; }

    /// <summary>How far objects are labelled, metres; not farther than was recorded.</summary>
    public double? RangeMetres { get; init; }

    /// <summary>Objects whose box in the image is smaller are not labelled, square pixels.</summary>
    public double? MinBoxAreaPixels { get; init; }

    /// <summary>Objects whose box in the image is narrower or lower are not labelled, pixels.</summary>
    public double? MinBoxSidePixels { get; init; }

    /// <summary>Objects that are hidden by more are not labelled, 0 to 1.</summary>
    public double? MaxOccludedFraction { get; init; }

    /// <summary>The lens, as a calibration found it.</summary>
    public Lens? Lens { get; init; }

    /// <summary>Faces of signs and heads of lights that go before the recorded ones, model by model.</summary>
    public FaceTable? Faces { get; init; }

    /// <summary>Name of the file of those, for session.json.</summary>
    public string? FacesName { get; init; }

    /// <summary>The roads.</summary>
    public RoadNetwork? Roads { get; init; }

    /// <summary>Name of the file of those, for session.json.</summary>
    public string? RoadsName { get; init; }

    /// <summary>Where the lane indicators are measured.</summary>
    public LookAhead? LookAhead { get; init; }

    /// <summary>Width of the lanes of an ordinary road, metres.</summary>
    public double? LaneWidthMetres { get; init; }

    /// <summary>Width of the lanes of a narrow road, metres.</summary>
    public double? NarrowLaneWidthMetres { get; init; }

    /// <summary>How pictures come into the new session.</summary>
    public ImageTransfer Images { get; init; }

    /// <summary>Which frames.</summary>
    public Shard Shard { get; init; } = Shard.Whole;
}
