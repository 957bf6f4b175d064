using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;

namespace Harvester.Driving.Session;

/// <summary>
/// Runs and pauses the world as the client requests, and publishes its frames: at the frame rate while the world runs, and at the end of a
/// step or on request once the image shows the paused world. Without a request the world is left alone.
/// </summary>
/// <param name="options">The frame rate, the ticks until an image has settled, and whether the world moves by steps only.</param>
/// <param name="pause">Freezes and resumes the game.</param>
/// <param name="bridge">The bridge to the client.</param>
/// <param name="view">Reads image, car and lanes of a frame.</param>
internal sealed class FramePace(DrivingOptions options, IPause pause, IDrivingBridge bridge, DrivingView view)
{
    private const double HalfATick = 0.5;

    /// <summary>Tolerance at the end of a step, seconds, for a world whose time is a sum of rounded ticks.</summary>
    private const double Rounding = 1e-6;

    private readonly FrameSchedule _schedule = new(options.RateHz);
    private double _nowSeconds;
    private double _tickSeconds;
    private double? _stepEndSeconds;
    private int _stillTicks;
    private int _quietTicks;
    private int? _leadLeft;
    private bool _isAskedFor;
    private bool _isMissed;
    private bool _isWanted = true;
    private bool _hasPicture = true;

    /// <summary>Number of frames published so far.</summary>
    public long Frames { get; private set; }

    /// <summary>
    /// Number of ticks by which a frame of the running world is foreseen, 0 or more: it is published so much later than it is due.
    /// </summary>
    public int LeadTicks { get; set; }

    /// <summary>Whether a frame of the running world is published <see cref="LeadTicks"/> ticks after this one.</summary>
    public bool IsFrameForeseen { get; private set; }

    /// <summary>Whether the world is paused, or about to be.</summary>
    public bool IsPaused { get; private set; }

    /// <summary>Whether a step is under way.</summary>
    public bool IsStepping => _stepEndSeconds is not null;

    /// <summary>Whether the frame at the end of a step is still to come.</summary>
    public bool IsStepOpen { get; private set; }

    /// <summary>Whether an image may be grabbed in the next ticks, so that overlays must not be drawn now.</summary>
    public bool IsPictureNear =>
        IsPaused
        || IsStepping
        || _isAskedFor
        || _isMissed
        || _leadLeft is not null
        || (_isWanted && _schedule.SecondsUntilDue(_nowSeconds) < (options.SettleTicks + HalfATick) * _tickSeconds);

    /// <summary>Whether the image shows the current state.</summary>
    private bool IsSettled => !IsPaused || _stillTicks >= options.SettleTicks;

    /// <summary>
    /// Starts a tick, and pauses the world at the end of a step; call it before the client's messages are taken and before
    /// <see cref="Publish"/>. An answer that arrives later leads to a frame only after it has been taken.
    /// </summary>
    public void BeginTick(double nowSeconds)
    {
        _isWanted = !options.WaitsForAnswers || bridge.Outbox.IsFrameAwaited;
        _tickSeconds = nowSeconds - _nowSeconds;
        _stillTicks = IsPaused && nowSeconds == _nowSeconds ? _stillTicks + 1 : 0;
        _nowSeconds = nowSeconds;
        if (nowSeconds >= _stepEndSeconds || (options.IsLockStep && !IsPaused && !IsStepping))
        {
            Pause();
        }
    }

    /// <summary>Pauses the world.</summary>
    public void Pause()
    {
        _stepEndSeconds = null;
        _stillTicks = 0;
        IsPaused = true;
        pause.Freeze();
    }

    /// <summary>Resumes the world, if it was paused here. In lock-step it only ends a step.</summary>
    public void GoOn()
    {
        if (options.IsLockStep)
        {
            Pause();
        }
        else
        {
            Resume();
        }
    }

    /// <summary>Runs the world for a time, pauses it then, and requests a frame of that moment.</summary>
    /// <param name="seconds">The time, seconds.</param>
    /// <param name="hasPicture">Whether the frame has an image.</param>
    public void Step(double seconds, bool hasPicture)
    {
        Resume();
        _stepEndSeconds = _nowSeconds + seconds - Rounding;
        _hasPicture = hasPicture || (_isAskedFor && _hasPicture);
        IsStepOpen = true;
    }

    /// <summary>Gives the world back, as at the end of a drive.</summary>
    public void Resume()
    {
        _stepEndSeconds = null;
        if (IsPaused)
        {
            IsPaused = false;
            pause.Unfreeze();
        }
    }

    /// <summary>The world has been changed from outside: the image of a paused world shows it only later.</summary>
    public void Unsettle() => _stillTicks = 0;

    /// <summary>Requests a frame as soon as possible.</summary>
    /// <param name="hasPicture">Whether with an image.</param>
    public void Ask(bool hasPicture)
    {
        _hasPicture = hasPicture || (_isAskedFor && _hasPicture);
        _isAskedFor = true;
    }

    /// <summary>Discards all requests.</summary>
    public void Clear()
    {
        IsStepOpen = _isAskedFor = _isMissed = false;
        _hasPicture = true;
    }

    /// <summary>Publishes a frame if one is due.</summary>
    /// <returns>Why no frame was published although one is due; otherwise null.</returns>
    public string? Publish()
    {
        string? problem = null;
        if (IsTime())
        {
            bool isStepOver = IsStepOpen;
            IsStepOpen = false;
            if (view.Take(Frames, _hasPicture, out string? refusal) is { } state)
            {
                Frames += bridge.Outbox.Publish(state with { IsAskedFor = _isAskedFor || isStepOver }, view.Picture) ? 1 : 0;
                _isAskedFor = _isMissed = false;
                _hasPicture = true;
            }
            else
            {
                // Commands are still executed, or the client could not resume the world; the frame is sent as soon as there is an image.
                _isAskedFor |= isStepOver;
                _isMissed = true;
                problem = $"the game's picture cannot be used: {refusal}.";
            }
        }

        _quietTicks = IsPictureNear ? _quietTicks + 1 : 0;
        return problem;
    }

    private bool IsTime()
    {
        // What was drawn before the request, or while no frame was wanted, must have disappeared from the image.
        bool isQuiet = _quietTicks >= options.SettleTicks;
        bool isWanted = _isWanted && (isQuiet || !options.WaitsForAnswers);
        bool isDue = IsLedDue(!IsStepping && isWanted && _schedule.TakeIfDue(_nowSeconds) && !IsPaused);
        bool isAskedFor = (_isAskedFor || _isMissed) && isQuiet;
        return (isDue || isAskedFor || IsStepOpen) && !IsStepping && IsSettled;
    }

    /// <summary>Delays a frame that is due by the lead.</summary>
    private bool IsLedDue(bool isDue)
    {
        IsFrameForeseen = false;
        if (IsPaused || IsStepping)
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
}
