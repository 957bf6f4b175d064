using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>Lines about the running harvest and surveys, shown while no image is grabbed.</summary>
public sealed class HarvestLine : IFeature
{
    private const double DiskEveryMilliseconds = 5_000;
    private const double BytesPerGigabyte = 1e9;
    private readonly Harvest _harvest;
    private readonly string _folder;
    private readonly IClock _clock;
    private readonly IDisplay _display;
    private double _diskAskedAt = double.NegativeInfinity;
    private Task<string> _asking = Task.FromResult(string.Empty);
    private string _disk = string.Empty;
    private bool _hasFailed;

    /// <summary>Creates the lines.</summary>
    /// <param name="harvest">The harvest.</param>
    /// <param name="folder">The folder of the sessions; its free space is shown.</param>
    /// <param name="clock">Real time.</param>
    /// <param name="display">Shows the lines.</param>
    public HarvestLine(Harvest harvest, string folder, IClock clock, IDisplay display)
    {
        _harvest = harvest;
        _folder = folder;
        _clock = clock;
        _display = display;
    }

    /// <summary>Whether nothing may be drawn now.</summary>
    public Func<bool> IsPictureNear { get; init; } = static () => false;

    /// <summary>The lines of the surveys; null from one that is off.</summary>
    public IReadOnlyList<Func<string?>> SurveyLines { get; init; } = [];

    /// <inheritdoc/>
    public string Name => "The display";

    /// <inheritdoc/>
    public bool IsOn { get; private set; }

    /// <inheritdoc/>
    public void Tick()
    {
        string[] surveys = [.. SurveyLines.Select(line => line()).OfType<string>()];
        if (_harvest.Status is null && surveys.Length == 0)
        {
            IsOn = false;
            _hasFailed = false;
            return;
        }

        IsOn = !_hasFailed;
        if (_hasFailed || IsPictureNear())
        {
            return;
        }

        for (int i = 0; i < surveys.Length; i++)
        {
            _display.Text(surveys[i], 0.02, 0.05 + (0.03 * i));
        }

        if (_harvest.Status is { } status)
        {
            Tell(status);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        IsOn = false;
        _hasFailed = true;
    }

    private void Tell(HarvestStatus status)
    {
        AskDisk();
        string state = status.Phase == HarvestPhase.WaitingForSink ? "WAITING FOR DISK" : "REC";
        string frames = Counted.Of(status.Captured, "frame") + (_harvest.AreMasksReplaced ? "  MASKS FROM RAYS" : string.Empty);
        string line = FormattableString.Invariant(
            $"{state}  {frames}  {status.FramesPerSecond:0.0}/s  {status.Discarded} discarded  queue {_harvest.Queued}  {_disk}"
        );
        line = string.Join("  ", new[] { line, PaceText.Of(_harvest.RealSecondsPerGameSecond) }.Where(part => part.Length > 0));
        _display.Text(line, 0.02, 0.02);
    }

    private void AskDisk()
    {
        if (!_asking.IsCompleted)
        {
            return;
        }

        _disk = _asking.Result;
        double now = _clock.Milliseconds;
        if (now - _diskAskedAt >= DiskEveryMilliseconds)
        {
            _diskAskedAt = now;
            _asking = Task.Run(() => FreeSpace(_folder));
        }
    }

    private static string FreeSpace(string folder)
    {
        try
        {
            var drive = new DriveInfo(Path.GetPathRoot(Path.GetFullPath(folder)) ?? folder);
            return FormattableString.Invariant($"{drive.AvailableFreeSpace / BytesPerGigabyte:0.0} GB free");
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or ArgumentException)
        {
            // A network share has no drive letter.
            return string.Empty;
        }
    }
}
