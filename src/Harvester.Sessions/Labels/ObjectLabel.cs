using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>One object in an image.</summary>
public sealed record ObjectLabel
{
    /// <summary>Number of the object: the same in every frame of a session, 1 to 65,535; also its value in the masks.</summary>
    public required int Id { get; init; }

    /// <summary>What kind of thing it is.</summary>
    public required ObjectClass Class { get; init; }

    /// <summary>The game's name of its model.</summary>
    public required string Model { get; init; }

    /// <summary>A name for people, such as a sign's; null without one.</summary>
    public string? Name { get; init; }

    /// <summary>
    /// Number of the object that this one is a part of; null for an object of its own. The other need not be in the image.
    /// </summary>
    public int? Parent { get; init; }

    /// <summary>
    /// How many faces or heads are known on its model, 0 for none; null for a part of another object, and when no table of them was in use.
    /// </summary>
    public int? KnownParts { get; init; }

    /// <summary>Whether somebody sits on a motorcycle or bicycle; null for everything else and when unknown.</summary>
    public bool? HasRider { get; init; }

    /// <summary>The box around its part in the image, pixels.</summary>
    public required Box2D Box2D { get; init; }

    /// <summary>The box around the whole of it, as if nothing hid it and the image had no edge, pixels.</summary>
    public required Box2D Box2DAmodal { get; init; }

    /// <summary>The box around the pixels where it is seen; null without a pixel map or when none is seen.</summary>
    public Box2D? Box2DVisible { get; init; }

    /// <summary>The kinds of boxes that are known.</summary>
    public IReadOnlyList<BoxKind> Boxes => BoxKinds.Known(Box2DVisible is not null);

    /// <summary>Share of its silhouette outside the image, 0 to 1.</summary>
    public required double TruncatedFraction { get; init; }

    /// <summary>Share of its silhouette in the image that lies behind something nearer, 0 to 1; null when it was not determined.</summary>
    public double? OccludedFraction { get; init; }

    /// <summary>How <see cref="OccludedFraction"/> was determined.</summary>
    public OcclusionMethod OcclusionMethod { get; init; }

    /// <summary>Whether it is not known how much of the object is seen, nor whether anything is.</summary>
    public bool IsUndetermined => OcclusionMethod == OcclusionMethod.None;

    /// <summary>
    /// Share of the whole silhouette that is seen: (1 - truncated)(1 - occluded); null when occlusion was not determined.
    /// </summary>
    public double? VisibleFraction => (1 - TruncatedFraction) * (1 - OccludedFraction);

    /// <summary>Its cuboid in the world.</summary>
    public required Cuboid Box3D { get; init; }

    /// <summary>Distance from the camera's position to the cuboid's centre, metres.</summary>
    public required double DistanceMetres { get; init; }

    /// <summary>Metres per second, world.</summary>
    public required Vector3D Velocity { get; init; }

    /// <summary>What it has as a part of another object; null for an object of its own.</summary>
    public FaceLabel? Face { get; init; }
}
