using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Session;

/// <summary>The frames that a drive sends, for a recorder that keeps them.</summary>
public sealed class SentFrames
{
    private readonly FramePublisher _frames;
    private readonly DrivingView _view;
    private readonly WorldPace _pace;

    internal SentFrames(FramePublisher frames, DrivingView view, WorldPace pace)
    {
        _frames = frames;
        _view = view;
        _pace = pace;
    }

    /// <summary>
    /// Number of ticks by which a frame of the running world is foreseen, 0 (default) or more: for a recorder whose picture lags behind the
    /// state. The frame is sent so much later than it is due.
    /// </summary>
    public int LeadTicks
    {
        get => _frames.LeadTicks;
        set => _frames.LeadTicks = value;
    }

    /// <summary>Whether a frame of the running world is sent <see cref="LeadTicks"/> ticks after this one.</summary>
    public bool IsForeseen => _frames.IsFrameForeseen;

    /// <summary>Whether the world is paused: the images of its frames then show the present state.</summary>
    public bool IsWorldPaused => _pace.IsPaused;

    /// <summary>The image of the newest frame, in memory that the next one reuses; null if it has none.</summary>
    public PixelBuffer? Picture => _view.HasPicture ? _view.Picture : null;
}
