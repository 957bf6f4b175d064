using Harvester.Capture.Calibration;
using Harvester.Capture.Faults;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Play.Settings;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>Calibrates the camera for the following harvests, and writes the lens into the settings file.</summary>
public sealed class LensCalibration : ILastingFeature, IDisposable
{
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(10);
    private readonly Harvest _harvest;
    private readonly GamePorts _game;
    private readonly IMount _mount;
    private readonly PlayerMessages _messages;
    private readonly string _iniPath;
    private readonly DiskQueue _disk = new();
    private CalibrationSession? _session;

    /// <summary>Creates the feature; it is off.</summary>
    /// <param name="harvest">Its options receive the lens.</param>
    /// <param name="game">The game, with markers.</param>
    /// <param name="mount">The camera to calibrate.</param>
    /// <param name="messages">Reports the result.</param>
    /// <param name="iniPath">The settings file.</param>
    public LensCalibration(Harvest harvest, GamePorts game, IMount mount, PlayerMessages messages, string iniPath)
    {
        _harvest = harvest;
        _game = game;
        _mount = mount;
        _messages = messages;
        _iniPath = iniPath;
    }

    /// <inheritdoc/>
    public string Name => "The calibration";

    /// <inheritdoc/>
    public bool IsOn => _session is not null;

    /// <summary>Why it cannot begin; null if it can.</summary>
    public Func<string?> Obstacle { get; init; } = static () => null;

    /// <summary>Whether the settings file is being written.</summary>
    public bool IsBusy => _disk.IsBusy;

    /// <summary>Starts a calibration, or ends the one that is running.</summary>
    public void Toggle()
    {
        if (_session is not null)
        {
            Stop();
            _messages.Tell("The calibration was stopped.");
            return;
        }

        if ((_harvest.IsOn ? "End the harvest first, then calibrate." : Obstacle()) is { } obstacle)
        {
            _messages.Tell(obstacle);
            return;
        }

        if (!_mount.IsMounted)
        {
            _messages.Tell("Mount the camera first, then calibrate it.");
        }
        else
        {
            var options = new CalibrationOptions
            {
                Image = _harvest.Options.Image,
                MaxPictureLagTicks = _harvest.Options.MaxPictureLagTicks,
            };
            _session = new CalibrationSession(options, _game);
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        ThrowIfNotWritten();
        if (_session is not { } session)
        {
            return;
        }

        if (!_mount.IsMounted)
        {
            Stop();
            return;
        }

        if (session.Step() != CalibrationPhase.Settling)
        {
            _session = null;
            End(session);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        _session?.Dispose();
        _session = null;
    }

    /// <summary>Stops, and waits until the lens is in the settings file, or for as long as a script may take to end.</summary>
    public void Finish()
    {
        Stop();
        _disk.Wait(MaxWaitForDisk);
        ThrowIfNotWritten();
    }

    /// <summary>Stops.</summary>
    public void Dispose() => Stop();

    private void End(CalibrationSession session)
    {
        if (session.Result is not { } result)
        {
            _messages.Tell(session.Failure is { } failure ? TextOf(failure) : "The calibration has no result.");
            return;
        }

        _harvest.Options = _harvest.Options with { Lens = result.Lens };
        IReadOnlyList<KeyValuePair<string, double>> values = LensSettings.ValuesOf(result.Lens);
        _disk.Add(() => IniEditor.Set(_iniPath, LensSettings.Section, values));
        _messages.Tell(
            FormattableString.Invariant(
                $"Calibrated: the error was {result.Before.RmsPixels:0.00} px and is {result.Validation.RmsPixels:0.00} px. "
            ) + $"The lens is in {Path.GetFileName(_iniPath)}."
        );
    }

    /// <summary>A failed calibration is not a failed check, which could be skipped; only the limit of the lag applies to both.</summary>
    private static string TextOf(CaptureFault failure) =>
        failure.Code == FaultCode.PictureLate ? HarvestAdvice.TextOf(failure) : failure.Message;

    private void ThrowIfNotWritten()
    {
        if (_disk.TakeFailure() is { } failure)
        {
            throw new IOException($"the lens cannot be written into {_iniPath}: {failure.Message}", failure);
        }
    }
}
