using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Datasets.Outputs;
using Harvester.Driving.Controllers;
using Harvester.Driving.Recording;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;

namespace Harvester.Runs.Driving;

/// <summary>Records the drive in one simulated game as a session, which is begun with the first frame.</summary>
/// <param name="game">The game.</param>
/// <param name="roads">Its roads.</param>
/// <param name="plan">How it is recorded.</param>
/// <param name="origin">Where the session comes from.</param>
/// <param name="newOutput">Makes room for the session.</param>
/// <param name="release">Takes the room back, null if there was none, and whether the session is whole.</param>
public sealed class GameRecording(
    SimulatedGame game,
    IRoads roads,
    RecordPlan plan,
    SessionOrigin origin,
    Func<SessionOutput> newOutput,
    Action<GameRecording, SessionOutput?, bool> release
) : IDisposable
{
    /// <summary>Label range of a harvest, metres.</summary>
    private const double RangeMetres = 80;

    /// <summary>More real time than the labels of any frame take, milliseconds: rays must not depend on the machine's speed.</summary>
    private const double NoLimitMilliseconds = 1e9;

    private SessionOutput? _output;
    private SessionWriter? _writer;
    private DriveRecorder? _recorder;
    private WatchedController? _watched;
    private bool _isOver;

    /// <summary>Number of frames recorded.</summary>
    public int Frames => _recorder?.Frames ?? 0;

    /// <summary>Whether the built-in driver drives at this moment, for what a frame says.</summary>
    public Func<bool> IsByBuiltInDriver { get; set; } = static () => false;

    /// <summary>Why the session is incomplete, once it is finished; null if it is not.</summary>
    public string? Fault { get; private set; }

    /// <summary>The controller, watched: what it is given is recorded with its answers.</summary>
    public IController Watch(IController controller) => _watched = new WatchedController(controller);

    /// <summary>Takes a frame of the world as it is, if one is due. The game waits for the disk.</summary>
    /// <param name="bridgeFrame">Number of the frame on the live bridge; null without a bridge.</param>
    /// <returns>Whether a frame was taken.</returns>
    /// <exception cref="IOException">The session cannot be written.</exception>
    /// <exception cref="GameFaultException">The game failed.</exception>
    public bool Look(long? bridgeFrame = null)
    {
        if (_recorder is null)
        {
            Begin();
        }

        _writer!.WaitForRoom();
        bool isTaken = _recorder!.Look(bridgeFrame);
        if (_writer.Fault is { } fault)
        {
            throw new IOException(fault);
        }

        return _recorder.Failure is { } failure ? throw new GameFaultException(OptionAdvice.TextOf(failure)) : isTaken;
    }

    /// <summary>Records the answer of the watched controller to the newest frame.</summary>
    public void Answer(DrivingControls controls) =>
        Answer(controls, _watched?.Input is { } input ? IndicatorOrder.Values(input.TorcsEquivalent) : null, _watched?.Target, null);

    /// <summary>Records the answer of a client to the newest frame.</summary>
    /// <param name="controls">Its controls.</param>
    /// <param name="indicators">The indicators that it sent; null if it sent controls.</param>
    /// <param name="target">The target of the controller that drives by the indicators; null if it is unknown.</param>
    /// <param name="bridgeFrame">Number of the frame on the live bridge that it answered; null if unknown.</param>
    public void Answer(DrivingControls controls, IReadOnlyList<double>? indicators, DriveTarget? target, long? bridgeFrame) =>
        _recorder?.Answer(controls, indicators, target, bridgeFrame);

    /// <summary>Discards the motion of the car: a client has placed it elsewhere.</summary>
    public void Reset() => _recorder?.Reset();

    /// <summary>Records a tick in which the world has moved.</summary>
    public void Tick(DriverKind driver, bool isDisturbed = false) => _recorder?.Tick(driver, isDisturbed);

    /// <summary>Finishes the session. Further calls do nothing.</summary>
    public void Dispose()
    {
        if (_isOver)
        {
            return;
        }

        _isOver = true;
        bool isWritten = false;
        try
        {
            FinishWriting();
            isWritten = _recorder is not null && Fault is null;
        }
        finally
        {
            release(this, _output, isWritten);
        }
    }

    private void FinishWriting()
    {
        if (_writer is not { } writer)
        {
            return;
        }

        _writer = null;
        try
        {
            writer.WaitForRoom();
            _recorder?.Dispose();
        }
        finally
        {
            writer.Dispose();
        }

        Fault = writer.Fault;
    }

    private void Begin()
    {
        _output = newOutput();
        _writer = new SessionWriter(_output.Begin(), origin);
        HarvestOptions options = DriveRecorder.Options(1 / plan.EverySeconds) with
        {
            Image = plan.Size,
            Format = plan.Format,
            RangeMetres = RangeMetres,
            MinFreeBytes = plan.MinFreeBytes,
            Events = plan.Events,
            TickBudgetMilliseconds = NoLimitMilliseconds,
            Faces = Harvester.Datasets.Faces.FaceFile.AsWritten(ModelFaces.Table),
        };
        _recorder = new DriveRecorder(
            options,
            game.Ports with
            {
                Roads = roads,
                Car = null,
            },
            _writer,
            () => TruthReader.Of(game, IsByBuiltInDriver())
        );
        _ = game.Conduct;
    }
}
