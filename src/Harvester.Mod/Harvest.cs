using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using GTA;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;

namespace Harvester.Mod;

/// <summary>Starts, drives and ends harvests by the keys.</summary>
internal sealed class Harvest : IFeature, IDisposable
{
    private static readonly TimeSpan LongestWaitForTheDisk = TimeSpan.FromSeconds(10);
    private readonly ModSettings _settings;
    private readonly Messages _messages;
    private readonly CameraMount _mount;
    private readonly GamePorts _game;
    private HarvestSession? _session;
    private SessionWriter? _writer;
    private Task _closing = Task.CompletedTask;
    private string? _singlesFolder;

    /// <summary>Makes ready for harvests of a game.</summary>
    public Harvest(ModSettings settings, Messages messages, CameraMount mount, GamePorts game)
    {
        _settings = settings;
        _messages = messages;
        _mount = mount;
        _game = game;
    }

    /// <inheritdoc/>
    public string Name => "The harvest";

    /// <summary>The harvest that runs; null when none does.</summary>
    public HarvestStatus? Status => _session?.Status;

    /// <summary>Frames that wait to be written.</summary>
    public int Queued => _writer?.Queued ?? 0;

    /// <summary>Whether a picture may be grabbed now or so soon that nothing of ours may be drawn.</summary>
    public bool IsPictureNear => Status is { } status && (!_settings.Options.Freeze || status.Phase is not (HarvestPhase.Waiting or HarvestPhase.WaitingForSink));

    /// <summary>Whether an ended harvest is still being written.</summary>
    public bool IsWriting => !_closing.IsCompleted;

    /// <summary>Starts a harvest in a folder of its own, or ends the one that runs.</summary>
    public void Toggle()
    {
        if (_session is null)
        {
            Start(_settings.Options, NewFolder("session"), resume: false);
        }
        else
        {
            Stop();
        }
    }

    /// <summary>Harvests one frame. The single frames of one run of the game make a session together.</summary>
    public void TakeOne()
    {
        if (_session is not null)
        {
            _messages.Tell("A harvest is running already.");
            return;
        }

        bool resume = _singlesFolder is not null;
        _singlesFolder ??= NewFolder("singles");
        Start(_settings.Options with { MaxFrames = 1, ProbeLag = false }, _singlesFolder, resume);
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (_session is null)
        {
            return;
        }

        Natives.HideHudAndRadar();
        Natives.HideFeed();
        if (_mount.Vehicle == 0)
        {
            Stop();
        }
        else if (_session.Step().IsOver)
        {
            Close(_session);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        if (_session is { } session)
        {
            session.Stop();
            Close(session);
        }
    }

    /// <summary>Stops, and waits until everything taken is on disk, or for as long as a script may take to end.</summary>
    public void Dispose()
    {
        Stop();
        _closing.Wait(LongestWaitForTheDisk);
    }

    private void Start(HarvestOptions options, string folder, bool resume)
    {
        if (IsWriting)
        {
            _messages.Tell("The last harvest is still being written. Try again in a moment.");
            return;
        }

        if (GameBuild.ListProblem is { } problem)
        {
            _messages.Tell(problem);
            return;
        }

        if (_mount.Vehicle == 0)
        {
            _mount.Mount();
        }

        if (_mount.Vehicle == 0)
        {
            return;
        }

        var origin = new SessionOrigin
        {
            Game = $"GTA V {Game.Version}",
            Tool = $"GtaDataHarvester {typeof(Harvest).Assembly.GetName().Version}",
            RecordedUtc = DateTime.UtcNow.ToString("yyyy-MM-ddTHH:mm:ssZ", CultureInfo.InvariantCulture),
        };
        _writer = new SessionWriter(folder, origin, resume);
        _session = new HarvestSession(options, _game, _writer);
    }

    private void Close(HarvestSession session)
    {
        SessionWriter? writer = _writer;
        _session = null;
        _writer = null;
        _closing = Task.Run(() => writer?.Dispose());
        HarvestStatus status = session.Status;
        string discards = string.Join(", ", session.Counters.Discards.Select(discard => FormattableString.Invariant($"{discard.Value} {discard.Key}")));
        string counts = FormattableString.Invariant($"{status.Captured} frames")
            + (discards.Length > 0 ? $", discarded: {discards}" : string.Empty);
        _messages.Tell(status.Fault is { } fault ? $"{fault} ({counts})" : $"The harvest ended: {counts}, in {_settings.Folder}.");
    }

    private string NewFolder(string kind)
    {
        string name = Path.Combine(_settings.Folder, kind + DateTime.Now.ToString("-yyyyMMdd-HHmmss", CultureInfo.InvariantCulture));
        string free = name;
        for (int number = 2; Directory.Exists(free); number++)
        {
            free = FormattableString.Invariant($"{name}-{number}");
        }

        return free;
    }
}
