using System;
using System.IO;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;

namespace Harvester.Mod;

/// <summary>A line about the harvest that runs, in moments when no picture is grabbed.</summary>
internal sealed class Hud : IFeature
{
    private const double DiskEveryMilliseconds = 5_000;
    private const double BytesPerGigabyte = 1e9;
    private static readonly Colour White = new(255, 255, 255, 255);
    private readonly Harvest _harvest;
    private readonly string _folder;
    private readonly IClock _clock;
    private double _diskAskedAt = double.NegativeInfinity;
    private string _disk = string.Empty;
    private bool _isOff;

    public Hud(Harvest harvest, string folder, IClock clock)
    {
        _harvest = harvest;
        _folder = folder;
        _clock = clock;
    }

    /// <inheritdoc/>
    public string Name => "The display";

    /// <inheritdoc/>
    public void Tick()
    {
        if (_harvest.Status is not { } status)
        {
            _isOff = false;
            return;
        }

        if (_isOff || _harvest.IsPictureNear)
        {
            return;
        }

        AskDisk();
        string state = status.Phase == HarvestPhase.WaitingForSink ? "WAITING FOR DISK" : "REC";
        string line = FormattableString.Invariant(
            $"{state}  {status.Captured} frames  {status.FramesPerSecond:0.0}/s  {status.Discarded} discarded  queue {_harvest.Queued}  {_disk}");
        Natives.DrawText(line, 0.02, 0.02, 0.35, White);
    }

    /// <inheritdoc/>
    public void Stop() => _isOff = true;

    private void AskDisk()
    {
        double now = _clock.Milliseconds;
        if (now - _diskAskedAt < DiskEveryMilliseconds)
        {
            return;
        }

        _diskAskedAt = now;
        try
        {
            var drive = new DriveInfo(Path.GetPathRoot(Path.GetFullPath(_folder)) ?? _folder);
            _disk = FormattableString.Invariant($"{drive.AvailableFreeSpace / BytesPerGigabyte:0.0} GB free");
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or ArgumentException)
        {
            // A share of the network is no drive with a letter.
            _disk = string.Empty;
        }
    }
}
