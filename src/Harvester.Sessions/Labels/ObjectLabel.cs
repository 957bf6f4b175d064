using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>One object in an image.</summary>
public sealed record ObjectLabel
{
    private readonly Box2D? _whole;

    /// <summary>Id of the object: the same in every frame of a session, 1 to 65,535; also its value in the masks.</summary>
    public required int Id { get; init; }

    /// <summary>Its class.</summary>
    public required ObjectClass Class { get; init; }

    /// <summary>The game's name of its model.</summary>
    public required string Model { get; init; }

    /// <summary>A readable name, such as that of a sign; null if it has none.</summary>
    public string? Name { get; init; }

    /// <summary>
    /// Id of the object to which this part belongs; null for an object of its own. The other object need not be in the image.
    /// </summary>
    public int? Parent { get; init; }

    /// <summary>
    /// Number of faces or heads known on its model, 0 if there are none; null for a part of another object, and if no table of faces was
    /// used.
    /// </summary>
    public int? KnownParts { get; init; }

    /// <summary>Whether somebody sits on a motorcycle or bicycle; null for other classes and if unknown.</summary>
    public bool? HasRider { get; init; }

    /// <summary>
    /// Id of the motorcycle or bicycle that a rider sits on, which need not be in the image; null for other classes and if unknown.
    /// </summary>
    public int? Vehicle { get; init; }

    /// <summary>The lamps of a vehicle that shine; null for other classes and if unknown.</summary>
    public VehicleLights? Lights { get; init; }

    /// <summary>The box around the part of its silhouette inside the image, pixels.</summary>
    public required Box2D Box2D { get; init; }

    /// <summary>The box around its whole silhouette, as if nothing hid it and the image had no border, pixels.</summary>
    public required Box2D Box2DAmodal { get; init; }

    /// <summary>The box around its visible pixels; null without a pixel map or if none is visible.</summary>
    public Box2D? Box2DVisible { get; init; }

    /// <summary>
    /// Its pixels including those that other objects hide; null if they are not known. What is no object of the frame still hides it.
    /// </summary>
    public AmodalMask? AmodalMask { get; init; }

    /// <summary>
    /// The box around all its pixels in the image, hidden ones included: that of the amodal mask unless it is set; null without both.
    /// </summary>
    public Box2D? Box2DWhole
    {
        get => _whole ?? AmodalMask?.Box;
        init => _whole = value;
    }

    /// <summary>The kinds of boxes that are known.</summary>
    public IReadOnlyList<BoxKind> Boxes => BoxKinds.Known(Box2DVisible is not null, Box2DWhole is not null);

    /// <summary>Fraction of its silhouette outside the image, 0 to 1.</summary>
    public required double TruncatedFraction { get; init; }

    /// <summary>Fraction of its silhouette in the image that lies behind something nearer, 0 to 1; null if it was not determined.</summary>
    public double? OccludedFraction { get; init; }

    /// <summary>How <see cref="OccludedFraction"/> was determined.</summary>
    public OcclusionMethod OcclusionMethod { get; init; }

    /// <summary>
    /// Fraction of its drawn pixels in the image that something nearer hides, by the renderer, 0 to 1; null for a part of another object
    /// and unless the game reports it. Unlike <see cref="OccludedFraction"/> it is not sampled.
    /// </summary>
    public double? TrueOccludedFraction { get; init; }

    /// <summary>Whether it is unknown how much of the object is visible, or whether any of it is.</summary>
    public bool IsUndetermined => OcclusionMethod == OcclusionMethod.None;

    /// <summary>
    /// Fraction of the whole silhouette that is visible: (1 - truncated)(1 - occluded); null if the occlusion was not determined.
    /// </summary>
    public double? VisibleFraction => (1 - TruncatedFraction) * (1 - OccludedFraction);

    /// <summary>Its cuboid in the world.</summary>
    public required Cuboid Box3D { get; init; }

    /// <summary>Distance from the camera's position to the cuboid's centre, metres.</summary>
    public required double DistanceMetres { get; init; }

    /// <summary>Metres per second, world.</summary>
    public required Vector3D Velocity { get; init; }

    /// <summary>
    /// Of a vehicle, the name of the lane on the map, or of the way through a junction, on which its middle is: docs/maps.md. Null if it is
    /// on none or no roads are known, and for other classes.
    /// </summary>
    public string? LaneId { get; init; }

    /// <summary>
    /// Of a traffic light, its heads, and a sign to stop or to give way: the names of the lanes whose traffic obeys it, from left to right;
    /// empty if it faces no road at a junction near it. Null for others, and if no roads are known.
    /// </summary>
    public IReadOnlyList<string>? GovernedLanes { get; init; }

    /// <summary>The data of a face or head; null for an object of its own.</summary>
    public FaceLabel? Face { get; init; }

    /// <summary>The joints of a person, also of a rider; null for other classes and if unknown.</summary>
    public JointsLabel? Joints { get; init; }
}
