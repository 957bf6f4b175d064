using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Session;
using Harvester.Play.Settings;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>Lets a client drive the car over the live bridge, from one press of a key to the next or until the player drives.</summary>
public sealed class BridgeFeature : ILastingFeature, IDisposable
{
    private static readonly TimeSpan MaxWaitForBridge = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(10);

    /// <summary>Maximum number of logged problems, so that a faulty client does not fill the disk.</summary>
    private const int MaxLoggedProblems = 100;

    private readonly BridgeSettings _settings;
    private readonly GamePorts _game;
    private readonly PlayerCar _car;
    private readonly IMount _mount;
    private readonly IDisplay _display;
    private readonly PlayerMessages _messages;
    private readonly SlowResource<IDrivingBridge> _bridge = new();
    private DrivingSession? _session;
    private string? _problem;
    private int _problems;
    private int _hiddenTicks;

    /// <summary>Creates the feature; it is off.</summary>
    /// <param name="settings">The bridge and the controller.</param>
    /// <param name="game">The game; its car is driven.</param>
    /// <param name="car">The car to drive.</param>
    /// <param name="mount">The camera of the client's images.</param>
    /// <param name="display">Shows a line.</param>
    /// <param name="messages">Reports the start and end of drives.</param>
    public BridgeFeature(BridgeSettings settings, GamePorts game, PlayerCar car, IMount mount, IDisplay display, PlayerMessages messages)
    {
        _settings = settings;
        _game = game with { Car = car };
        _car = car;
        _mount = mount;
        _display = display;
        _messages = messages;
    }

    /// <inheritdoc/>
    public string Name => "The drive";

    /// <inheritdoc/>
    public bool IsOn => _bridge.IsHeld;

    /// <summary>Why no client can drive now; null if one can.</summary>
    public Func<string?> Obstacle { get; init; } = static () => null;

    /// <summary>Records the drives; null for none.</summary>
    public BridgeRecording? Recording { get; init; }

    /// <summary>Whether an image may be grabbed so soon that nothing may be drawn over it.</summary>
    public bool IsPictureNear => _session?.IsPictureNear ?? IsOn;

    /// <inheritdoc/>
    public bool IsBusy => _bridge.IsBusy || Recording is { IsBusy: true };

    /// <summary>Opens the bridge and lets the client drive, or ends that.</summary>
    public void Toggle()
    {
        if (IsOn)
        {
            End("The drive was stopped. The car is yours.");
            return;
        }

        string? obstacle =
            _settings.Kind == BridgeKind.Off ? "The bridge is off. Change Kind under [Bridge] in GtaDataHarvester.ini." : Obstacle();
        if (obstacle is not null)
        {
            _messages.Tell(obstacle);
            return;
        }

        if (!_mount.IsMounted)
        {
            _mount.Mount();
        }

        if (_mount.IsMounted)
        {
            _hiddenTicks = 0;
            _bridge.Open(_settings.Open);
        }
    }

    /// <summary>Gives the car back to the player, who has pressed a driving key.</summary>
    public void TakeBack()
    {
        if (IsOn)
        {
            End("You are driving again.");
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        Recording?.TellLateFault();
        if (!IsOn)
        {
            _car.GiveBack();
            return;
        }

        // Before the first image, the game's display must have disappeared from it.
        _hiddenTicks++;
        if (_bridge.TakeFailure() is { } failure)
        {
            throw failure;
        }

        if (_bridge.Opened is not { } bridge || _hiddenTicks <= _settings.Driving.SettleTicks)
        {
            return;
        }

        if (!_mount.IsMounted || Obstacle() is not null)
        {
            End("The drive has ended. The car is yours.");
            return;
        }

        if (_session is null)
        {
            _problem = null;
            _problems = 0;
            DrivingOptions driving = _settings.Driving with { WaitsForAnswers = Recording is not null };
            _session = new DrivingSession(driving, _game, bridge, _settings.Controller.New);
            Recording?.Begin();
            _messages.Tell($"The car waits for a client at {_settings.Place}. Any driving key takes it back.");
        }

        // A client that has been sent its last frame may be gone before it is recorded.
        bool hasClient = bridge.Client is not null;
        Recording?.BeforeTick(_session);
        DrivingStatus status = _session.Tick();
        if (!status.IsOver)
        {
            Recording?.AfterTick(_session, hasClient || bridge.Client is not null);
        }

        if (_session.Problem is { } problem && problem != _problem && _problems < MaxLoggedProblems)
        {
            _problem = problem;
            _problems++;
            string last = _problems == MaxLoggedProblems ? " No more problems of this drive are logged." : string.Empty;
            _messages.Log($"The bridge: {problem}{last}");
        }

        if (status.Ending is { } ending)
        {
            End($"{ending} The car is yours.");
        }
        else if (!IsPictureNear)
        {
            string who = status.IsClientAlive ? "DRIVEN by the client" : "BRAKING, no client drives";
            string recorded = Recording?.Frames is { } frames ? FormattableString.Invariant($"  REC {frames}") : "";
            _display.Text(
                FormattableString.Invariant($"{who} at {_settings.Place}  {Counted.Of(status.Frames, "frame")}{recorded}"),
                0.02,
                0.02
            );
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        if (IsOn)
        {
            DrivingSession? session = _session;
            _session = null;
            _bridge.Close();
            session?.Stop();
            Recording?.Stop();
        }

        // If the game refused, the next tick tries again.
        _car.GiveBack();
    }

    /// <summary>Stops, and waits until the bridge is closed, or for as long as a script may take to end.</summary>
    public void Finish()
    {
        Stop();
        _bridge.Wait(MaxWaitForBridge);
        Recording?.Wait(MaxWaitForDisk);
    }

    /// <summary>Stops and waits as <see cref="Finish"/> does.</summary>
    public void Dispose() => Finish();

    private void End(string message)
    {
        Stop();
        _messages.Tell(message);
    }
}
