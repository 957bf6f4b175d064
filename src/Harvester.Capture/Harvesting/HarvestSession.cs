using Harvester.Capture.Calibration;
using Harvester.Capture.Events;
using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// A harvest from its first frame to its last: call <see cref="Step"/> once in every tick of the game, from the game's own thread. After
/// construction, nothing is thrown to the caller: a fault of a port or of the sink ends the harvest with a message, and the game is
/// resumed. The session closes the sink; its creator disposes it.
/// </summary>
public sealed class HarvestSession : IDisposable
{
    private readonly HarvestOptions _options;
    private readonly GamePorts _game;
    private readonly IFrameSink _sink;
    private readonly PixelBufferPool _pool;
    private readonly SceneReader _reader;
    private readonly HarvestTime _time;
    private readonly HarvestStart _checks;
    private readonly PictureWatch? _watch;
    private readonly TickBudget _budget;
    private readonly MotionRecorder? _motion;
    private double _startMilliseconds;
    private double _endMilliseconds;
    private bool _opened;
    private WorkRun _run;
    private CaptureFlows? _flows;
    private EventRecorder? _events;
    private FrameHarvester? _frames;
    private HarvestPhase _phase = HarvestPhase.Waiting;

    /// <summary>Creates a session. The game is not used before the first step.</summary>
    /// <param name="options">Labelling, frame rate, number of frames and capture mode.</param>
    /// <param name="game">The ports of the game to harvest from.</param>
    /// <param name="sink">Receives the frames. The session closes it; the caller disposes it.</param>
    public HarvestSession(HarvestOptions options, GamePorts game, IFrameSink sink)
    {
        _options = options ?? throw new ArgumentNullException(nameof(options));
        _game = game ?? throw new ArgumentNullException(nameof(game));
        _sink = sink ?? throw new ArgumentNullException(nameof(sink));
        if (HarvestConflicts.Of(options, game) is { } problem)
        {
            throw new ArgumentException(problem, nameof(options));
        }

        _budget = new TickBudget(game.Clock, options.TickBudgetMilliseconds);
        Calls = new PhaseCalls(game.Calls);
        _motion = MotionRecorder.For(options, game.World);
        _watch = options.Rig is null ? new PictureWatch(options.Image) : null;
        _pool = new PixelBufferPool(options.Image);
        _reader = new SceneReader(game.World, options);
        _time = new HarvestTime(game);
        _checks = new HarvestStart(options, game, _reader, _pool, Open);
        _run = new WorkRun(_checks.Run(), () => _budget.IsSpent);
    }

    /// <summary>The counters of the harvest.</summary>
    public HarvestCounters Counters { get; } = new();

    /// <summary>The calls to the game in each phase.</summary>
    public PhaseCalls Calls { get; }

    /// <summary>Why the harvest ended; null without a fault.</summary>
    public CaptureFault? Failure { get; private set; }

    /// <summary>The message of <see cref="Failure"/>.</summary>
    public string? Fault => Failure?.Message;

    /// <summary>What could not be checked; empty until the first frame.</summary>
    public IReadOnlyList<CaptureFault> Warnings =>
        [.. _checks.Unchecked, .. new[] { _flows?.Photographer?.Warning, _flows?.Pairs?.Warning, PictureFault }.OfType<CaptureFault>()];

    /// <summary>How well masks from rays agree with those from photographs; null if they are not compared.</summary>
    public MaskComparison? MaskComparison => _flows?.Comparison;

    /// <summary>Error of the camera model, pixels; null if it was not checked, or not yet.</summary>
    public double? CalibrationErrorPixels => _checks.CalibrationErrorPixels;

    /// <summary>The freeze methods that were tried, here or earlier in the same session; null if none was, or not yet.</summary>
    public FreezeReport? Freezing => _checks.Freezing;

    /// <summary>Whether the game's display can be hidden while it is frozen; null if it was not checked, or not yet.</summary>
    public DisplayFinding? Display => _checks.Display;

    /// <summary>How pictures show known colours; null if that was not checked, or not yet.</summary>
    public ColourFinding? Colours => _checks.Colours;

    /// <summary>The picture lag; null if it was not measured.</summary>
    public PictureLag? Lag => _checks.Lag;

    /// <summary>
    /// Live mode only: gives the picture lag of the next frame, for a game that is paused now and then, so that its picture catches up;
    /// null (default) if it is always <see cref="Lag"/>.
    /// </summary>
    public Func<PictureLag>? NextLag { get; init; }

    /// <summary>
    /// The tour on which the frames are taken, one at each of its places, after which the harvest ends; null (default) to take them at <see
    /// cref="HarvestOptions.RateHz"/>. The game must be frozen for each frame.
    /// </summary>
    public IFrameTour? Tour { get; init; }

    /// <summary>Real time that the game takes for a second of its own time; null in the first second of game time.</summary>
    public double? RealSecondsPerGameSecond => _time.RealSecondsPerGameSecond;

    /// <summary>The current state of the harvest.</summary>
    public HarvestStatus Status => new(_phase, Counters.Captured, Counters.Discarded, FramesPerSecond, Fault);

    private CaptureFault? PictureFault => _watch?.Warning is { } warning ? new CaptureFault(FaultCode.PicturesSpoiled, warning) : null;

    private double FramesPerSecond =>
        _endMilliseconds > _startMilliseconds ? Counters.Captured * 1000.0 / (_endMilliseconds - _startMilliseconds) : 0;

    /// <summary>Does the work of one tick. After the end of the harvest it does nothing.</summary>
    public HarvestStatus Step()
    {
        if (Status.IsOver)
        {
            return Status;
        }

        try
        {
            if (_sink.Fault is { } sinkFault)
            {
                throw new HarvestFaultException(new CaptureFault(FaultCode.Failed, sinkFault));
            }

            _budget.BeginTick();
            Calls.Skip();
            if (_opened && _motion is not null)
            {
                _motion.Record();
                Calls.Charge(HarvestPhase.Waiting);
            }

            ObserveEvents();
            bool isGoingOn = _run.Advance();
            if (!isGoingOn && _flows is null)
            {
                _run = BeginFrames();
                isGoingOn = _run.Advance();
            }

            if (isGoingOn)
            {
                _phase = (HarvestPhase)_run.Phase!.Value;
                Calls.Charge(_phase);
            }
            else
            {
                End(HarvestPhase.Stopped);
            }

            _endMilliseconds = _game.Clock.Milliseconds;
        }
#pragma warning disable CA1031 // The game's script loop must not see an exception of ours, whatever its type.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Fail(exception);
        }

        return Status;
    }

    /// <summary>
    /// Looks for events, in a tick without a step: for those who step the harvest only for its frames. Nothing is done before the first
    /// frame is due, and without <see cref="HarvestOptions.Events"/>.
    /// </summary>
    public void Observe()
    {
        try
        {
            if (!Status.IsOver)
            {
                ObserveEvents();
            }
        }
#pragma warning disable CA1031 // As in Step.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Fail(exception);
        }
    }

    /// <summary>Ends the harvest, resumes the game and closes the sink. An unfinished frame is dropped. Further calls do nothing.</summary>
    public void Stop()
    {
        if (Status.IsOver)
        {
            return;
        }

        try
        {
            End(HarvestPhase.Stopped);
        }
#pragma warning disable CA1031 // As in Step.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Fail(exception);
        }
    }

    /// <summary>Ends the harvest like <see cref="Stop"/>; the caller disposes the sink.</summary>
    public void Dispose() => Stop();

    private WorkRun BeginFrames()
    {
        _flows = new CaptureFlows(_options, _game, _reader, _pool, _budget, Counters, Calls) { NextLag = NextLag };
        ICaptureFlow flow = _flows.For(_sink, Lag);
        CaptureFlows flows = _flows;
        _events = _options.Events is { } events
            ? new EventRecorder(events, _game, entity => flows.Registry!.IdOf(entity), _sink.FirstEventId)
            : null;
        ObserveEvents();
        _frames = new FrameHarvester(_options, _sink, flow, Counters, _motion)
        {
            Watch = _watch,
            Events = _events,
            Keeper = _options.Events is { KeepAroundSeconds: { } around } keeping ? new FrameKeeper(around, keeping.KeepKinds) : null,
        };
        IFrameTrigger trigger = Tour is { } tour ? new TourTrigger(tour, Counters) : new RateTrigger(_options, _time, Counters, Calls);
        return new WorkRun(_frames.Run(trigger), () => _budget.IsSpent);
    }

    private void ObserveEvents()
    {
        if (_opened && _events is not null)
        {
            _events.Observe();
            Calls.Charge(HarvestPhase.Waiting);
        }
    }

    private void Open()
    {
        _time.Read();
        _startMilliseconds = _game.Clock.Milliseconds;
        _sink.Open(
            new SessionStart(_options, _time.GameFrame, _time.Seconds, _game.World.ReadCamera())
            {
                CameraErrorPixels = CalibrationErrorPixels,
                Freezing = Freezing,
                Display = Display,
                Colours = Colours,
            }
        );
        _game.Reading?.Begin();
        _opened = true;
    }

    private void Fail(Exception exception)
    {
        CaptureFault failure = exception switch
        {
            HarvestFaultException harvest => harvest.Fault,
            CalibrationException calibration => calibration.Fault,
            _ => new CaptureFault(FaultCode.Failed, $"The harvest stopped: {OneLine(exception.Message)}"),
        };
        Failure = failure;
        try
        {
            End(HarvestPhase.Faulted);
        }
#pragma warning disable CA1031 // As in Step; the first fault is reported.
        catch (Exception second)
#pragma warning restore CA1031
        {
            _phase = HarvestPhase.Faulted;
            Failure = failure with { Message = $"{failure.Message} Ending it failed too: {OneLine(second.Message)}" };
        }
    }

    private void End(HarvestPhase phase)
    {
        _phase = phase;
        try
        {
            _run.Dispose();
        }
        finally
        {
            try
            {
                // Disposing the flow of a frame resumes the game; a flow that was ended by a fault may not have done so.
                _flows?.Photographer?.Release();
                _flows?.Pairs?.Release();
                _game.Pause.Unfreeze();
                if (_options.ChecksDisplay)
                {
                    _game.Hud?.Restore();
                }
            }
            finally
            {
                try
                {
                    Tour?.Release();
                }
                finally
                {
                    CloseSink();
                }
            }
        }
    }

    private void CloseSink()
    {
        if (_opened)
        {
            _opened = false;
            _sink.Close(
                new SessionEnd(
                    _time.GameFrame,
                    _time.Seconds,
                    Counters.Captured,
                    [.. Counters.Discards],
                    [.. Counters.SettleTicks],
                    Lag,
                    Fault
                )
                {
                    Reading = _game.Reading?.Report,
                    Events = _options.Events is null
                        ? null
                        : _events?.Finish(_frames?.LostEvents ?? [], _sink.FirstFrame + Counters.Captured - 1) ?? [],
                    MaskComparison = MaskComparison,
                    PictureWarning = _watch?.Warning,
                    MaskWarning = _flows?.Photographer?.Warning?.Message,
                }
            );
        }
    }

    private static string OneLine(string message) => string.Join(" ", message.Split('\r', '\n').Where(part => part.Length > 0));
}
