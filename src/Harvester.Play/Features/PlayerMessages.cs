using System.Diagnostics;
using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;

namespace Harvester.Play.Features;

/// <summary>Messages to the player, and the log file. It never throws. All calls come from one thread.</summary>
public sealed class PlayerMessages
{
    private const string Prefix = "GtaDataHarvester: ";
    private const double RepeatAfterMilliseconds = 5_000;
    private readonly string _logPath;
    private readonly Action<string> _show;
    private readonly DiskQueue _disk = new();
    private readonly IClock _clock;
    private readonly Dictionary<string, double> _failures = [];

    /// <summary>Creates the messages and the log.</summary>
    /// <param name="folder">The folder of the mod.</param>
    /// <param name="show">Shows a message in the game.</param>
    /// <param name="clock">Real time.</param>
    public PlayerMessages(string folder, Action<string> show, IClock clock)
    {
        _logPath = Path.Combine(folder, "GtaDataHarvester.log");
        _show = show;
        _clock = clock;
    }

    /// <summary>Whether something is still being written to the log.</summary>
    public bool IsBusy => _disk.IsBusy;

    /// <summary>Shows and logs a message.</summary>
    public void Tell(string message)
    {
        _failures.Clear();
        Show(message);
    }

    /// <summary>
    /// Shows a failure to the player and logs its reason. The same failure is repeated at most every five seconds while there are only
    /// failures, so that one in every tick does not fill the disk.
    /// </summary>
    public void TellFailure(string what, Exception exception)
    {
        string message = $"{what} failed: {FailureAdvice.AddTo(exception?.Message ?? string.Empty)} More in GtaDataHarvester.log.";
        if (!_failures.TryGetValue(message, out double lastShown) || IsLongAgo(lastShown))
        {
            _failures[message] = _clock.Milliseconds;
            Log(exception?.ToString() ?? what);
            Show(message);
        }
    }

    /// <summary>Writes a line to the log, on another thread.</summary>
    public void Log(string line)
    {
        string entry = DateTime.Now.ToString("yyyy-MM-dd HH:mm:ss ", CultureInfo.InvariantCulture) + line + Environment.NewLine;
        _disk.Add(() => Quietly(() => File.AppendAllText(_logPath, entry)));
    }

    /// <summary>Waits until everything is in the log, or until the time is over.</summary>
    public void Wait(TimeSpan timeout) => _disk.Wait(timeout);

    private bool IsLongAgo(double milliseconds) => _clock.Milliseconds - milliseconds >= RepeatAfterMilliseconds;

    private void Show(string message)
    {
        Log(message);
        Quietly(() => _show(Prefix + message));
    }

    private static void Quietly(Action tell)
    {
        try
        {
            tell();
        }
#pragma warning disable CA1031 // A failure to show a message cannot be shown either.
        catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
        {
            Trace.WriteLine(exception.Message);
        }
    }
}
