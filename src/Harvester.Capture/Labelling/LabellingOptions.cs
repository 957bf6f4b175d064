using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Labelling;

/// <summary>What to label and how: size, lens, range, classes, occlusion and rays. Every value is checked when it is set.</summary>
/// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
public record LabellingOptions
{
    /// <summary>Maximum <see cref="RayBudget"/>: more than one ray per pixel of a large image.</summary>
    public const int MaxRays = 10_000_000;

    /// <summary>Size of the saved images, pixels; 800 x 600 as in the thesis.</summary>
    public ImageSize Image { get; init; } = new(800, 600);

    /// <summary>Labelling range: maximum distance of an object's origin from the camera, metres; greater than 0.</summary>
    public double RangeMetres
    {
        get;
        init => field = OptionCheck.Positive(value, nameof(RangeMetres));
    } = 150;

    /// <summary>
    /// Visible objects beyond <see cref="RangeMetres"/> and up to this distance from the camera are marked by ignore regions, metres; 0 or
    /// more. At 300 m a truck has the size of a pedestrian at 150 m.
    /// </summary>
    public double IgnoreRangeMetres
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(IgnoreRangeMetres));
    } = 300;

    /// <summary>The classes to label; null for all.</summary>
    public IReadOnlyCollection<ObjectClass>? Classes { get; init; }

    /// <summary>The faces of signs and heads of traffic lights that are labelled as objects of their own; null to label none.</summary>
    public FaceTable? Faces { get; init; }

    /// <summary>Whether instance masks are made.</summary>
    public bool Masks { get; init; }

    /// <summary>How instance masks are made. Methods other than rays need a frozen game that can hide its entities.</summary>
    public MaskMethod MaskMethod { get; init; } = MaskMethod.Rays;

    /// <summary>Where the classes of class maps come from; null for no class maps. They need masks.</summary>
    public SemanticsMethod? Semantics { get; init; }

    /// <summary>Whether depth maps are made, of a game whose rays report normals.</summary>
    public bool Depth
    {
        get => Channels.Contains(FrameChannels.Depth.Key);
        init => Channels = Channels.With(FrameChannels.Depth.Key, value);
    }

    /// <summary>The channels that are switched on by their key alone: <see cref="FrameChannel.Switch"/>.</summary>
    public ChannelKeys Channels { get; init; } = ChannelKeys.None;

    /// <summary>The size of bird's-eye maps, if they are made.</summary>
    /// <exception cref="ArgumentException">There is no such grid.</exception>
    public GridShape BirdsEye
    {
        get;
        init => field = value.Problem is { } problem ? throw new ArgumentException(problem, nameof(value)) : value;
    } = GridShape.Usual;

    /// <summary>Why bird's-eye maps of this size cannot be made, one sentence; null if they can, or are not.</summary>
    public string? BirdsEyeProblem =>
        Channels.Contains(FrameChannels.BirdsEye.Key) && ReadRangeMetres < BirdsEye.ReachMetres
            ? FormattableString.Invariant($"The corners of bird's-eye maps are {BirdsEye.ReachMetres:0.0} m from the vehicle, but ")
                + FormattableString.Invariant($"vehicles and people are read up to {ReadRangeMetres} m. Read them farther.")
            : null;

    /// <summary>Why voxels cannot be made, one sentence; null if they can, or are not.</summary>
    public string? OccupancyProblem =>
        Channels.Contains(FrameChannels.Occupancy.Key) && ReadRangeMetres < VoxelShape.Usual.ReachMetres
            ? FormattableString.Invariant($"Voxels reach {VoxelShape.Usual.ReachMetres:0.0} m, but objects are read up to ")
                + FormattableString.Invariant($"{ReadRangeMetres} m. Read them farther.")
            : null;

    /// <summary>The classes of the materials that rays report.</summary>
    public MaterialTable Materials { get; init; } = MaterialTable.BuiltIn;

    /// <summary>
    /// Maximum number of rays per frame, 0 to 10,000,000: for the mask first, then for objects, the class map, faces, ignore
    /// regions, lanes, joints and depth maps.
    /// When they are used up, the mask is finished from what is known, and the rest is undetermined.
    /// </summary>
    public int RayBudget
    {
        get;
        init => field = OptionCheck.InRange(value, 0, MaxRays, nameof(RayBudget));
    } = 50_000;

    /// <summary>
    /// Distance beyond which the game's rays hit no entities, metres; greater than 0. The visibility of entities beyond it is undetermined:
    /// they are marked by ignore regions.
    /// </summary>
    public double RayReachMetres
    {
        get;
        init => field = OptionCheck.Positive(value, nameof(RayReachMetres));
    } = 1_000;

    /// <summary>How the game's picture deviates from a pinhole camera's, as found by calibration.</summary>
    public Lens Lens { get; init; } = Lens.Ideal;

    /// <summary>Minimum area of an object's box in the image, square pixels; 0 or more. Smaller objects are not labelled.</summary>
    public double MinBoxAreaPixels
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(MinBoxAreaPixels));
    } = 16;

    /// <summary>Minimum width and height of an object's box in the image, pixels; 0 or more. Smaller objects are not labelled.</summary>
    public double MinBoxSidePixels
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(MinBoxSidePixels));
    } = 2;

    /// <summary>Maximum occluded fraction of a labelled object, 0 to 1; with 1, objects without a visible pixel are labelled too.</summary>
    public double MaxOccludedFraction
    {
        get;
        init => field = OptionCheck.Fraction(value, nameof(MaxOccludedFraction));
    } = 0.99;

    /// <summary>Number of rays through an object's silhouette for its occlusion, 1 to 10,000.</summary>
    public int OcclusionSamples
    {
        get;
        init => field = OptionCheck.InRange(value, 1, 10_000, nameof(OcclusionSamples));
    } = 64;

    /// <summary>
    /// Maximum real time of labelling in one tick, milliseconds; greater than 0. At least one object is labelled per tick.
    /// </summary>
    public double TickBudgetMilliseconds
    {
        get;
        init => field = OptionCheck.Positive(value, nameof(TickBudgetMilliseconds));
    } = 4;

    /// <summary>Range in which entities are read, metres.</summary>
    internal double ReadRangeMetres => Math.Max(RangeMetres, IgnoreRangeMetres);

    /// <summary>The camera of the saved image for a camera of the game.</summary>
    internal Camera CameraOf(CameraState state) =>
        new(state.Pose, new CameraIntrinsics(state.VerticalFovDegrees, Image, state.WindowAspect, state.NearClip, Lens));

    /// <summary>Whether an entity lies within the labelling range.</summary>
    internal bool IsInRange(CameraState camera, EntityState entity) => (entity.Pose.Position - camera.Pose.Position).Length < RangeMetres;

    /// <summary>Whether rays may hit an object.</summary>
    internal bool IsWithinReach(Camera camera, Cuboid cuboid) =>
        (cuboid.Centre - camera.Pose.Position).Length - cuboid.HalfExtents.Length <= RayReachMetres;

    /// <summary>
    /// Whether an object in the image is listed: a visible one that is not occluded too much, and one whose visibility was not examined,
    /// which is marked as undetermined.
    /// </summary>
    internal bool IsListed(OcclusionEstimate occlusion) =>
        occlusion.Sight switch
        {
            Sight.NotAsked => true,
            Sight.Seen => occlusion.OccludedFraction <= MaxOccludedFraction,
            Sight.Unseen => occlusion.Method != OcclusionMethod.None && occlusion.OccludedFraction <= MaxOccludedFraction,
            _ => false,
        };

    /// <summary>Whether a box in the image is large enough to be labelled.</summary>
    internal bool IsLargeEnough(Box2D box) =>
        box.Area >= MinBoxAreaPixels && box.Width >= MinBoxSidePixels && box.Height >= MinBoxSidePixels;
}
