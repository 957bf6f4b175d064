using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Events;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// What to harvest and how: how frames are taken, in addition to how they are labelled. Every value is checked when it is set.
/// </summary>
/// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
public sealed record HarvestOptions : LabellingOptions
{
    /// <summary>Space that stays free on a disk unless the user says otherwise, bytes.</summary>
    public const long DefaultMinFreeBytes = 1_000_000_000;

    /// <summary>Memory for images that are held back until it is known whether an event is near them, bytes.</summary>
    private const double MaxHeldBytes = 1e9;

    /// <summary>
    /// The sensors that see each moment; null for the single camera of the game. With a rig, numbers of frames count views, and <see
    /// cref="LabellingOptions.Image"/> and <see cref="LabellingOptions.Lens"/> are those of its first camera.
    /// </summary>
    public Rig? Rig { get; init; }

    /// <summary>Number of frames of one moment: one per camera.</summary>
    public int ViewsPerMoment => Rig?.Cameras.Count ?? 1;

    /// <summary>The further pictures of each moment; none by default. They need a frozen harvest without a rig.</summary>
    public PairOptions Pairs { get; init; } = new();

    /// <summary>File format of the saved images.</summary>
    public ImageFormat Format { get; init; } = ImageFormat.Png;

    /// <summary>Quality of saved JPEG images, 1 to 100; 95 as in most datasets.</summary>
    public int JpegQuality
    {
        get;
        init => field = OptionCheck.InRange(value, JpegEncoder.MinQuality, JpegEncoder.MaxQuality, nameof(JpegQuality));
    } = JpegEncoder.DefaultQuality;

    /// <summary>Frames per second of game time; greater than 0. A game that ticks more slowly gives one frame per tick.</summary>
    public double RateHz
    {
        get;
        init => field = OptionCheck.Positive(value, nameof(RateHz));
    } = 10;

    /// <summary>
    /// Fraction of a period by which a frame may be early, 0 to 1: for frames that are not taken in any tick, but at times which someone
    /// else sets.
    /// </summary>
    public double EarlyFraction
    {
        get;
        init => field = OptionCheck.Fraction(value, nameof(EarlyFraction));
    }

    /// <summary>
    /// Whether the game is frozen for each frame, so that image and label show the same moment; otherwise the harvest is live.
    /// </summary>
    public bool Freeze { get; init; } = true;

    /// <summary>How the game is frozen; null to try every method at the start and use the better one.</summary>
    public FreezeMethod? FreezeBy { get; init; } = FreezeMethod.Paused;

    /// <summary>
    /// The findings about freeze methods from earlier in the same session; null (default) if there are none. Used if <see cref="FreezeBy"/>
    /// is null.
    /// </summary>
    public FreezeReport? KnownFreezing { get; init; }

    /// <summary>
    /// Whether a harvest, before its first frame, compares frozen pictures with and without the game's own display, and looks for colours
    /// that it draws; as far as the game can hide the one and draw the other.
    /// </summary>
    public bool ChecksDisplay { get; init; }

    /// <summary>Whether scenes are recorded, so that labels can be recomputed without the game.</summary>
    public bool Scenes { get; init; } = true;

    /// <summary>
    /// Maximum error of the camera model over a few markers, pixels, greater than 0; with a larger one the harvest does not start. Null to
    /// skip the check; a game that draws no markers is not checked.
    /// </summary>
    public double? MaxCalibrationErrorPixels
    {
        get;
        init => field = value is { } error ? OptionCheck.Positive(error, nameof(MaxCalibrationErrorPixels)) : null;
    } = 1;

    /// <summary>
    /// Error of the camera model from an earlier check in the same session, pixels, 0 or more; null (default) if it was not checked.
    /// </summary>
    public double? KnownCalibrationErrorPixels
    {
        get;
        init => field = value is { } error ? OptionCheck.AtLeast(error, 0, nameof(KnownCalibrationErrorPixels)) : null;
    }

    /// <summary>
    /// The shard of the frames to take, for a game whose course is the same in every run. Frames of other shards are skipped, so that
    /// frames and objects have the same numbers in all shards. Frozen harvests only.
    /// </summary>
    public Shard Shard { get; init; } = Shard.Whole;

    /// <summary>
    /// Number of the last frame that the session holds from an earlier run of the same course; -1 (default) for none. Frames up to it are
    /// skipped like those of other shards. Frozen harvests only.
    /// </summary>
    public int RecordedThrough
    {
        get;
        init => field = OptionCheck.InRange(value, -1, int.MaxValue, nameof(RecordedThrough));
    } = -1;

    /// <summary>
    /// Number of frames after which the harvest stops by itself, including those of other shards; at least 1; null for no limit.
    /// </summary>
    public int? MaxFrames
    {
        get;
        init => field = value is { } frames ? OptionCheck.InRange(frames, 1, int.MaxValue, nameof(MaxFrames)) : null;
    }

    /// <summary>The places among which the frames are divided; null if the session stays where the car drives.</summary>
    public PlaceSequence? Places { get; init; }

    /// <summary>
    /// Maximum number of ticks by which the picture may lag behind the state, 0 to 60. A frozen frame is kept only if nothing has moved for
    /// that many ticks before it is grabbed, so it shows what the label says.
    /// </summary>
    public int MaxPictureLagTicks
    {
        get;
        init => field = OptionCheck.InRange(value, 0, PictureLag.MaxTicks, nameof(MaxPictureLagTicks));
    } = 4;

    /// <summary>
    /// Whether the picture lag is measured before the first frame, by freezing the moving game. Live mode needs it unless <see
    /// cref="LiveLag"/> gives it; in a frozen harvest it detects a lag above <see cref="MaxPictureLagTicks"/>.
    /// </summary>
    public bool ProbeLag { get; init; } = true;

    /// <summary>
    /// Live mode only: the picture lag if it is known; null to measure it at the start, for which camera and traffic must move.
    /// </summary>
    public PictureLag? LiveLag { get; init; }

    /// <summary>
    /// Number of readings of the frozen scene, one a tick unless a reading takes several, within which everything must stand still, 1 to
    /// 10,000; otherwise the frame is discarded.
    /// </summary>
    public int MaxSettleTicks
    {
        get;
        init => field = OptionCheck.InRange(value, 1, 10_000, nameof(MaxSettleTicks));
    } = 60;

    /// <summary>
    /// Tolerance of a position that counts as unchanged, metres; 0 or more. 1 mm is a quarter of a pixel at 3 m, 800 x 600 and 50 degrees.
    /// </summary>
    public double StillToleranceMetres
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(StillToleranceMetres));
    } = 0.001;

    /// <summary>Whether the motion of the ego is recorded at every tick between frames; by default only with a rig.</summary>
    public bool Motion
    {
        get => field || Rig is not null;
        init;
    }

    /// <summary>The noise of the inertial unit, if the harvest has one; null (default) for an ideal unit.</summary>
    public ImuNoise? ImuNoise { get; init; }

    /// <summary>The noise of the satellite receiver, if the harvest has one; null (default) for an ideal one.</summary>
    public GnssNoise? GnssNoise { get; init; }

    /// <summary>How events are found; null (default) to find none.</summary>
    public EventOptions? Events { get; init; }

    /// <summary>When the session's writer waits for the disk; the bytes of the session do not depend on it.</summary>
    public SyncMode Sync { get; init; } = SyncMode.Batch;

    /// <summary>
    /// Space that stays free on the disk, bytes, 0 or more: the harvest ends before less is left. 0 watches nothing.
    /// </summary>
    public long MinFreeBytes
    {
        get;
        init => field = (long)OptionCheck.AtLeast(value, 0, nameof(MinFreeBytes));
    } = DefaultMinFreeBytes;

    /// <summary>Maximum number of frames waiting to be written, 1 to 1,000.</summary>
    public int QueueCapacity
    {
        get;
        init => field = OptionCheck.InRange(value, 1, 1_000, nameof(QueueCapacity));
    } = 16;

    /// <summary>Why frames cannot be held back until it is known whether an event is near them, one sentence; null if they can.</summary>
    public string? KeepProblem
    {
        get
        {
            const int bytesPerPixel = 4;
            if (Events?.KeepAroundSeconds is not { } seconds)
            {
                return null;
            }

            double pixels =
                Rig?.Cameras.Sum(camera => (double)camera.Image.Width * camera.Image.Height) ?? (double)Image.Width * Image.Height;
            double bytes = seconds * RateHz * pixels * bytesPerPixel;
            string held = FormattableString.Invariant($"{bytes / 1e6:F0} MB, of which at most {MaxHeldBytes / 1e6:F0} are held back");
            return Shard.Count > 1 ? "Frames around events are kept in whole harvests only, not in shards."
                : bytes > MaxHeldBytes ? $"The frames of that time take {held}. Keep less around events, or take smaller or fewer images."
                : null;
        }
    }

    /// <summary>Distance of the rig's farthest camera from the origin of the vehicle's model, metres; 0 without a rig.</summary>
    internal double RigReachMetres => Rig?.Cameras.Max(camera => Rig.OnVehicle(camera.Mount).Position.Length) ?? 0;

    /// <summary>
    /// Distance that the rig's LiDARs and radars see from the origin of the vehicle's model at most, metres; 0 without any.
    /// </summary>
    internal double LidarReachMetres =>
        Rig?.Lidars.Select(lidar => Rig.OnVehicle(lidar.Mount).Position.Length + lidar.RangeMetres)
            .Concat(Rig.Radars.Select(radar => Rig.OnVehicle(radar.Mount).Position.Length + radar.RangeMetres))
            .DefaultIfEmpty()
            .Max()
        ?? 0;
}
