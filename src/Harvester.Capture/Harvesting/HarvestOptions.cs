using System;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// What to harvest and how: how frames are taken, on top of how they are labelled. Every value is checked where it is set.
/// </summary>
/// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
public sealed record HarvestOptions : LabellingOptions
{
    /// <summary>File format of the saved images.</summary>
    public ImageFormat Format { get; init; } = ImageFormat.Png;

    /// <summary>Quality of the saved images where they are JPEG, 1 to 100; 95 as most datasets have.</summary>
    public int JpegQuality
    {
        get;
        init => field = OptionCheck.InRange(value, JpegEncoder.MinQuality, JpegEncoder.MaxQuality, nameof(JpegQuality));
    } = JpegEncoder.DefaultQuality;

    /// <summary>Frames per second of the game's time; greater than 0. A game that ticks slower gives a frame a tick.</summary>
    public double RateHz { get; init => field = OptionCheck.Positive(value, nameof(RateHz)); } = 10;

    /// <summary>
    /// Whether the game is frozen for each frame, so that image and label are of one moment; otherwise the harvest is live.
    /// </summary>
    public bool Freeze { get; init; } = true;

    /// <summary>How the game is frozen; null to try every way at the start and use the better one.</summary>
    public FreezeMethod? FreezeBy { get; init; } = FreezeMethod.Paused;

    /// <summary>
    /// What was found about the ways of freezing earlier in the same session; null (default) when nothing was. Used where
    /// <see cref="FreezeBy"/> is null.
    /// </summary>
    public FreezeReport? KnownFreezing { get; init; }

    /// <summary>Whether the scenes are written too, so that labels can be made again without the game.</summary>
    public bool Scenes { get; init; } = true;

    /// <summary>
    /// The largest error that the camera model may have over a handful of markers, pixels, greater than 0: with more the harvest refuses to
    /// start. Null to leave the check out; a game that draws no markers is not checked.
    /// </summary>
    public double? MaxCalibrationErrorPixels
    {
        get;
        init => field = value is { } error ? OptionCheck.Positive(error, nameof(MaxCalibrationErrorPixels)) : null;
    } = 1;

    /// <summary>
    /// By how much the camera model was off where it was checked earlier in the same session, pixels, 0 or more; null (default) when it was
    /// not.
    /// </summary>
    public double? KnownCalibrationErrorPixels
    {
        get;
        init => field = value is { } error ? OptionCheck.AtLeast(error, 0, nameof(KnownCalibrationErrorPixels)) : null;
    }

    /// <summary>
    /// Which of the frames are taken, of those that a single run would take: for a game that takes the same course in every run. The others
    /// are passed over, so that frames and objects have the same numbers in all shards. Frozen harvests only.
    /// </summary>
    public Shard Shard { get; init; } = Shard.Whole;

    /// <summary>Frames to take before the harvest stops by itself, those of other shards included, at least 1; null for no end.</summary>
    public int? MaxFrames
    {
        get;
        init => field = value is { } frames ? OptionCheck.InRange(frames, 1, int.MaxValue, nameof(MaxFrames)) : null;
    }

    /// <summary>
    /// By how many ticks the picture may at most be behind the state, 0 to 60. A frozen frame is kept only if nothing has moved in so many
    /// ticks before its grab, so whichever of them the picture shows, it shows what the label says.
    /// </summary>
    public int MaxPictureLagTicks
    {
        get;
        init => field = OptionCheck.InRange(value, 0, PictureLag.MaxTicks, nameof(MaxPictureLagTicks));
    } = 4;

    /// <summary>
    /// Whether the lag of the picture is measured before the first frame, by freezing the moving game. Live mode needs it, unless
    /// <see cref="LiveLag"/> says it; a frozen harvest is right without it, and by it finds out a lag above
    /// <see cref="MaxPictureLagTicks"/>.
    /// </summary>
    public bool ProbeLag { get; init; } = true;

    /// <summary>
    /// Live mode only: the lag of the picture where it is known; null to measure it at the start, for which camera and traffic must move.
    /// </summary>
    public PictureLag? LiveLag { get; init; }

    /// <summary>
    /// Ticks after the request to freeze in which everything must have come to stand still, 1 to 10,000; otherwise the frame is discarded.
    /// </summary>
    public int MaxSettleTicks { get; init => field = OptionCheck.InRange(value, 1, 10_000, nameof(MaxSettleTicks)); } = 60;

    /// <summary>
    /// By how much a position may differ and still count as the same, metres; 0 or more. 1 mm is a quarter of a pixel at 3 m, 800 x 600 and
    /// 50 degrees.
    /// </summary>
    public double StillToleranceMetres { get; init => field = OptionCheck.AtLeast(value, 0, nameof(StillToleranceMetres)); } = 0.001;

    /// <summary>Frames that may wait to be written, 1 to 1,000.</summary>
    public int QueueCapacity { get; init => field = OptionCheck.InRange(value, 1, 1_000, nameof(QueueCapacity)); } = 16;
}
