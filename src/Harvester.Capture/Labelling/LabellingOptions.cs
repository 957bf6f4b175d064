using System;
using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Labelling;

/// <summary>What to label and how: size, lens, range, classes, occlusion and rays. Every value is checked where it is set.</summary>
/// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
public record LabellingOptions
{
    /// <summary>The greatest <see cref="RayBudget"/>: more than a ray for every pixel of a large image.</summary>
    public const int MaxRays = 10_000_000;

    /// <summary>Size of the saved images, pixels; 800 x 600 as in the thesis.</summary>
    public ImageSize Image { get; init; } = new(800, 600);

    /// <summary>Objects whose origins lie farther from the camera are not labelled, metres; greater than 0.</summary>
    public double RangeMetres { get; init => field = OptionCheck.Positive(value, nameof(RangeMetres)); } = 150;

    /// <summary>
    /// Objects beyond <see cref="RangeMetres"/> and up to this distance from the camera are marked by ignore regions where they are seen,
    /// metres; 0 or more. At 300 m a lorry has the size of a pedestrian at 150 m.
    /// </summary>
    public double IgnoreRangeMetres { get; init => field = OptionCheck.AtLeast(value, 0, nameof(IgnoreRangeMetres)); } = 300;

    /// <summary>The classes to label; null for all.</summary>
    public IReadOnlyCollection<ObjectClass>? Classes { get; init; }

    /// <summary>
    /// The parts of models that are labelled as objects of their own: faces of signs, heads of traffic lights; null for none.
    /// </summary>
    public FaceTable? Faces { get; init; }

    /// <summary>Whether instance masks are made.</summary>
    public bool Masks { get; init; }

    /// <summary>
    /// Rays that a frame may take in all, 0 to 10,000,000: for the mask first, then for objects, faces, ignore regions and lanes. When they
    /// are used up the mask is finished from what is known, and what is left is not determined.
    /// </summary>
    public int RayBudget { get; init => field = OptionCheck.InRange(value, 0, MaxRays, nameof(RayBudget)); } = 50_000;

    /// <summary>
    /// Distance beyond which the game's rays are known not to meet entities, metres; greater than 0. Whether those are seen is not
    /// determined: they are marked by ignore regions.
    /// </summary>
    public double RayReachMetres { get; init => field = OptionCheck.Positive(value, nameof(RayReachMetres)); } = 1_000;

    /// <summary>What separates the game's picture from a pinhole's, as calibration found it.</summary>
    public Lens Lens { get; init; } = Lens.Ideal;

    /// <summary>Objects whose box in the image is smaller are not labelled, square pixels; 0 or more.</summary>
    public double MinBoxAreaPixels { get; init => field = OptionCheck.AtLeast(value, 0, nameof(MinBoxAreaPixels)); } = 16;

    /// <summary>Objects whose box in the image is narrower or lower are not labelled, pixels; 0 or more.</summary>
    public double MinBoxSidePixels { get; init => field = OptionCheck.AtLeast(value, 0, nameof(MinBoxSidePixels)); } = 2;

    /// <summary>Objects that are hidden by more than this are not labelled, 0 to 1; 1 labels even what cannot be seen at all.</summary>
    public double MaxOccludedFraction { get; init => field = OptionCheck.Fraction(value, nameof(MaxOccludedFraction)); } = 0.99;

    /// <summary>Rays through an object's silhouette for its occlusion, 1 to 10,000.</summary>
    public int OcclusionSamples { get; init => field = OptionCheck.InRange(value, 1, 10_000, nameof(OcclusionSamples)); } = 64;

    /// <summary>
    /// Time that labelling may take of one tick, milliseconds of the player's time; greater than 0. One object is always done.
    /// </summary>
    public double TickBudgetMilliseconds { get; init => field = OptionCheck.Positive(value, nameof(TickBudgetMilliseconds)); } = 4;

    /// <summary>How far entities are read, metres.</summary>
    internal double ReadRangeMetres => Math.Max(RangeMetres, IgnoreRangeMetres);

    /// <summary>The camera of the saved image for a camera of the game.</summary>
    internal Camera CameraOf(CameraState state) =>
        new(state.Pose, new CameraIntrinsics(state.VerticalFovDegrees, Image, state.WindowAspect, state.NearClip, Lens));

    /// <summary>Whether an entity lies within the labelling range.</summary>
    internal bool IsInRange(CameraState camera, EntityState entity) => (entity.Pose.Position - camera.Pose.Position).Length < RangeMetres;

    /// <summary>Whether an object may be met by rays.</summary>
    internal bool IsWithinReach(Camera camera, Cuboid cuboid) =>
        (cuboid.Centre - camera.Pose.Position).Length - cuboid.HalfExtents.Length <= RayReachMetres;

    /// <summary>
    /// Whether an object in the image is labelled: one that is visible and not occluded too far, and one whose visibility was not examined,
    /// which is marked as undetermined.
    /// </summary>
    internal bool IsListed(OcclusionEstimate occlusion) => occlusion.Sight switch
    {
        Sight.NotAsked => true,
        Sight.Seen => occlusion.OccludedFraction <= MaxOccludedFraction,
        Sight.Unseen => occlusion.Method != OcclusionMethod.None && occlusion.OccludedFraction <= MaxOccludedFraction,
        _ => false,
    };

    /// <summary>Whether a box in the image is one of an object to be labelled.</summary>
    internal bool IsLargeEnough(Box2D box) =>
        box.Area >= MinBoxAreaPixels && box.Width >= MinBoxSidePixels && box.Height >= MinBoxSidePixels;
}
