using Harvester.Capture.Harvesting;
using Harvester.Driving.Bridge;

namespace Harvester.Driving.Session;

/// <summary>
/// Publishes frames to the client: at the frame rate while the world runs, and on request once the image shows the paused world.
/// </summary>
/// <param name="options">The frame rate and the ticks until an image has settled.</param>
/// <param name="bridge">The bridge to the client.</param>
/// <param name="view">Reads image, car and lanes of a frame.</param>
/// <param name="pace">Whether the world is running, paused or stepping.</param>
internal sealed class FramePublisher(DrivingOptions options, IDrivingBridge bridge, DrivingView view, WorldPace pace)
{
    private const double HalfATick = 0.5;
    private readonly FrameSchedule _schedule = new(options.RateHz);
    private bool _isAskedFor;
    private bool _isMissed;
    private bool _isWanted = true;
    private bool _hasPicture = true;
    private double _nowSeconds;
    private double _tickSeconds;
    private int _quietTicks;
    private int? _leadLeft;

    /// <summary>Number of frames published so far.</summary>
    public long Frames { get; private set; }

    /// <summary>
    /// Number of ticks by which a frame of the running world is foreseen, 0 or more: it is published so much later than it is due.
    /// </summary>
    public int LeadTicks { get; set; }

    /// <summary>Whether a frame of the running world is published <see cref="LeadTicks"/> ticks after this one.</summary>
    public bool IsFrameForeseen { get; private set; }

    /// <summary>Whether the frame at the end of a step is still to come.</summary>
    public bool IsStepOpen { get; private set; }

    /// <summary>Whether an image may be grabbed in the next ticks, so that overlays must not be drawn now.</summary>
    public bool IsPictureNear =>
        pace.IsPaused
        || pace.IsStepping
        || _isAskedFor
        || _isMissed
        || _leadLeft is not null
        || (_isWanted && _schedule.SecondsUntilDue(_nowSeconds) < (options.SettleTicks + HalfATick) * _tickSeconds);

    /// <summary>
    /// Starts a tick; call it before the client's messages are taken and before <see cref="PublishIfTime"/>. An answer that arrives later
    /// leads to a frame only after it has been taken.
    /// </summary>
    public void BeginTick(double nowSeconds)
    {
        _isWanted = !options.WaitsForAnswers || bridge.IsFrameAwaited;
        _tickSeconds = nowSeconds - _nowSeconds;
        _nowSeconds = nowSeconds;
    }

    /// <summary>Requests a frame as soon as possible.</summary>
    /// <param name="hasPicture">Whether with an image.</param>
    public void Ask(bool hasPicture)
    {
        _hasPicture = hasPicture || (_isAskedFor && _hasPicture);
        _isAskedFor = true;
    }

    /// <summary>Requests a frame at the end of the step that begins now.</summary>
    /// <param name="hasPicture">Whether with an image.</param>
    public void AskAtEndOfStep(bool hasPicture)
    {
        _hasPicture = hasPicture || (_isAskedFor && _hasPicture);
        IsStepOpen = true;
    }

    /// <summary>Discards all requests.</summary>
    public void Clear()
    {
        IsStepOpen = _isAskedFor = _isMissed = false;
        _hasPicture = true;
    }

    /// <summary>Publishes a frame if one is due.</summary>
    /// <returns>Why no frame was published although one is due; otherwise null.</returns>
    public string? PublishIfTime()
    {
        string? problem = IsTime() ? Take() : null;
        _quietTicks = IsPictureNear ? _quietTicks + 1 : 0;
        return problem;
    }

    private bool IsTime()
    {
        // What was drawn before the request, or while no frame was wanted, must have disappeared from the image.
        bool isQuiet = _quietTicks >= options.SettleTicks;
        bool isWanted = _isWanted && (isQuiet || !options.WaitsForAnswers);
        bool isDue = IsLedDue(!pace.IsStepping && isWanted && _schedule.TakeIfDue(_nowSeconds) && !pace.IsPaused);
        bool isAskedFor = (_isAskedFor || _isMissed) && isQuiet;
        return (isDue || isAskedFor || IsStepOpen) && !pace.IsStepping && pace.IsSettled;
    }

    /// <summary>Delays a frame that is due by the lead.</summary>
    private bool IsLedDue(bool isDue)
    {
        IsFrameForeseen = false;
        if (pace.IsPaused || pace.IsStepping)
        {
            _leadLeft = null;
        }
        else if (_leadLeft is { } left)
        {
            _leadLeft = left > 1 ? left - 1 : null;
            return left == 1;
        }
        else if (isDue && LeadTicks > 0)
        {
            _leadLeft = LeadTicks;
            IsFrameForeseen = true;
            return false;
        }

        return isDue;
    }

    private string? Take()
    {
        bool isStepOver = IsStepOpen;
        IsStepOpen = false;
        if (view.Take(Frames, _hasPicture, out string? refusal) is not { } state)
        {
            // Commands are still executed, or the client could not resume the world; the frame is sent as soon as there is an image.
            _isAskedFor |= isStepOver;
            _isMissed = true;
            return $"the game's picture cannot be used: {refusal}.";
        }

        Frames += bridge.Publish(state with { IsAskedFor = _isAskedFor || isStepOver }, view.Picture) ? 1 : 0;
        _isAskedFor = _isMissed = false;
        _hasPicture = true;
        return null;
    }
}
