using System;
using System.Collections.Generic;
using Harvester.Capture.Imaging;
using Harvester.Capture.Imaging.Jpeg;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Capture.Spaces;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Harvesting;

/// <summary>What to harvest and how. Every value is checked where it is set.</summary>
/// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
public sealed record HarvestOptions
{
    /// <summary>The greatest <see cref="RayBudget"/>: more than a ray for every pixel of a large image.</summary>
    public const int MostRays = 10_000_000;

    /// <summary>The greatest lag of a picture that is looked for and that <see cref="MaxPictureLagTicks"/> may allow, ticks: a second at 60 frames a second.</summary>
    public const int GreatestPictureLagTicks = 60;

    /// <summary>Ends messages about the check of the camera model: how to harvest without it, as the mod's ini file names it.</summary>
    public const string WayWithoutCameraCheck = "MaxError = 0 in [Lens] of the ini harvests without this check.";

    /// <summary>Size of the saved images, pixels; 800 x 600 as in the thesis.</summary>
    public ImageSize Image { get; init; } = new(800, 600);

    /// <summary>File format of the saved images.</summary>
    public ImageFormat Format { get; init; } = ImageFormat.Png;

    /// <summary>Quality of the saved images where they are JPEG, 1 to 100; 95 as most datasets have.</summary>
    public int JpegQuality { get; init => field = OptionCheck.InRange(value, JpegEncoder.LowestQuality, JpegEncoder.HighestQuality, nameof(JpegQuality)); } = JpegEncoder.DefaultQuality;

    /// <summary>Frames per second of the game's time; greater than 0. A game that ticks slower gives a frame a tick.</summary>
    public double RateHz { get; init => field = OptionCheck.Positive(value, nameof(RateHz)); } = 10;

    /// <summary>Objects whose origins lie farther from the camera are not labelled, metres; greater than 0.</summary>
    public double RangeMetres { get; init => field = OptionCheck.Positive(value, nameof(RangeMetres)); } = 150;

    /// <summary>
    /// Objects beyond <see cref="RangeMetres"/> and up to this distance from the camera are marked by ignore regions where they are seen,
    /// metres; 0 or more. At 300 m a lorry has the size of a pedestrian at 150 m.
    /// </summary>
    public double IgnoreRangeMetres { get; init => field = OptionCheck.AtLeast(value, 0, nameof(IgnoreRangeMetres)); } = 300;

    /// <summary>The classes to label; null for all.</summary>
    public IReadOnlyCollection<ObjectClass>? Classes { get; init; }

    /// <summary>The parts of models that are labelled as objects of their own: faces of signs, heads of traffic lights; null for none.</summary>
    public SpaceTable? Spaces { get; init; }

    /// <summary>Whether the game is frozen for each frame, so that image and label are of one moment; otherwise the harvest is live.</summary>
    public bool Freeze { get; init; } = true;

    /// <summary>How the game is frozen; null to try every way at the start and use the better one.</summary>
    public FreezeMethod? FreezeBy { get; init; } = FreezeMethod.Paused;

    /// <summary>What was found about the ways of freezing earlier in the same session; null (default) when nothing was. Used where <see cref="FreezeBy"/> is null.</summary>
    public FreezeReport? KnownFreezing { get; init; }

    /// <summary>Whether instance masks are made.</summary>
    public bool Masks { get; init; }

    /// <summary>Whether the scenes are written too, so that labels can be made again without the game.</summary>
    public bool Scenes { get; init; } = true;

    /// <summary>
    /// Rays that a frame may take in all, 0 to 10,000,000: for the mask first, then for objects, faces, ignore regions and lanes. When they are
    /// used up the mask is finished from what is known, and what is left is not determined.
    /// </summary>
    public int RayBudget { get; init => field = OptionCheck.InRange(value, 0, MostRays, nameof(RayBudget)); } = 50_000;

    /// <summary>
    /// Distance beyond which the game's rays are known not to meet entities, metres; greater than 0. Whether those are seen is not determined:
    /// they are marked by ignore regions.
    /// </summary>
    public double RayReachMetres { get; init => field = OptionCheck.Positive(value, nameof(RayReachMetres)); } = 1_000;

    /// <summary>What separates the game's picture from a pinhole's, as calibration found it.</summary>
    public Lens Lens { get; init; } = Lens.Ideal;

    /// <summary>
    /// The largest error that the camera model may have over a handful of markers, pixels, greater than 0: with more the harvest refuses to
    /// start. Null to leave the check out; a game that draws no markers is not checked.
    /// </summary>
    public double? MaxCalibrationErrorPixels { get; init => field = value is { } error ? OptionCheck.Positive(error, nameof(MaxCalibrationErrorPixels)) : null; } = 1;

    /// <summary>By how much the camera model was off where it was checked earlier in the same session, pixels, 0 or more; null (default) when it was not.</summary>
    public double? KnownCalibrationErrorPixels { get; init => field = value is { } error ? OptionCheck.AtLeast(error, 0, nameof(KnownCalibrationErrorPixels)) : null; }

    /// <summary>Objects whose box in the image is smaller are not labelled, square pixels; 0 or more.</summary>
    public double MinBoxAreaPixels { get; init => field = OptionCheck.AtLeast(value, 0, nameof(MinBoxAreaPixels)); } = 16;

    /// <summary>Objects whose box in the image is narrower or lower are not labelled, pixels; 0 or more.</summary>
    public double MinBoxSidePixels { get; init => field = OptionCheck.AtLeast(value, 0, nameof(MinBoxSidePixels)); } = 2;

    /// <summary>Objects that are hidden by more than this are not labelled, 0 to 1; 1 labels even what cannot be seen at all.</summary>
    public double MaxOccludedFraction { get; init => field = OptionCheck.Fraction(value, nameof(MaxOccludedFraction)); } = 0.99;

    /// <summary>Rays through an object's silhouette for its occlusion, 1 to 10,000.</summary>
    public int OcclusionSamples { get; init => field = OptionCheck.InRange(value, 1, 10_000, nameof(OcclusionSamples)); } = 64;

    /// <summary>
    /// Which of the frames are taken, of those that a single run would take: for a game that takes the same course in every run. The others
    /// are passed over, so that frames and objects have the same numbers in all shards. Frozen harvests only.
    /// </summary>
    public Shard Shard { get; init; } = Shard.Whole;

    /// <summary>Frames to take before the harvest stops by itself, those of other shards included, at least 1; null for no end.</summary>
    public int? MaxFrames { get; init => field = value is { } frames ? OptionCheck.InRange(frames, 1, int.MaxValue, nameof(MaxFrames)) : null; }

    /// <summary>
    /// By how many ticks the picture may at most be behind the state, 0 to 60. A frozen frame is kept only if nothing has moved in so many
    /// ticks before its grab, so whichever of them the picture shows, it shows what the label says.
    /// </summary>
    public int MaxPictureLagTicks { get; init => field = OptionCheck.InRange(value, 0, GreatestPictureLagTicks, nameof(MaxPictureLagTicks)); } = 4;

    /// <summary>
    /// Whether the lag of the picture is measured before the first frame, by freezing the moving game. Live mode needs it, unless
    /// <see cref="LiveLag"/> says it; a frozen harvest is right without it, and by it finds out a lag above <see cref="MaxPictureLagTicks"/>.
    /// </summary>
    public bool ProbeLag { get; init; } = true;

    /// <summary>Live mode only: the lag of the picture where it is known; null to measure it at the start, for which camera and traffic must move.</summary>
    public PictureLag? LiveLag { get; init; }

    /// <summary>Ticks after the request to freeze in which everything must have come to stand still, 1 to 10,000; otherwise the frame is discarded.</summary>
    public int MaxSettleTicks { get; init => field = OptionCheck.InRange(value, 1, 10_000, nameof(MaxSettleTicks)); } = 60;

    /// <summary>By how much a position may differ and still count as the same, metres; 0 or more. 1 mm is a quarter of a pixel at 3 m, 800 x 600 and 50 degrees.</summary>
    public double StillToleranceMetres { get; init => field = OptionCheck.AtLeast(value, 0, nameof(StillToleranceMetres)); } = 0.001;

    /// <summary>Time that labelling may take of one tick, milliseconds of the player's time; greater than 0. One object is always done.</summary>
    public double TickBudgetMilliseconds { get; init => field = OptionCheck.Positive(value, nameof(TickBudgetMilliseconds)); } = 4;

    /// <summary>Frames that may wait to be written, 1 to 1,000.</summary>
    public int QueueCapacity { get; init => field = OptionCheck.InRange(value, 1, 1_000, nameof(QueueCapacity)); } = 16;

    /// <summary>How far entities are read, metres.</summary>
    internal double ReadRangeMetres => Math.Max(RangeMetres, IgnoreRangeMetres);

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
