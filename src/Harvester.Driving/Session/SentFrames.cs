using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Session;

/// <summary>The frames that a drive sends, for a recorder that keeps them.</summary>
public sealed class SentFrames
{
    private readonly FramePace _pace;
    private readonly DrivingView _view;

    internal SentFrames(FramePace pace, DrivingView view)
    {
        _pace = pace;
        _view = view;
    }

    /// <summary>
    /// Number of ticks by which a frame of the running world is foreseen, 0 (default) or more: for a recorder whose picture lags behind the
    /// state. The frame is sent so much later than it is due.
    /// </summary>
    public int LeadTicks
    {
        get => _pace.LeadTicks;
        set => _pace.LeadTicks = value;
    }

    /// <summary>Whether a frame of the running world is sent <see cref="LeadTicks"/> ticks after this one.</summary>
    public bool IsForeseen => _pace.IsFrameForeseen;

    /// <summary>Whether the world is paused: the images of its frames then show the present state.</summary>
    public bool IsWorldPaused => _pace.IsPaused;

    /// <summary>The image of the newest frame, in memory that the next one reuses; null if it has none.</summary>
    public PixelBuffer? Picture => _view.HasPicture ? _view.Picture : null;
}
