using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;

namespace Harvester.Play.Features;

/// <summary>What the mod tells: messages to the player, and a log file. Telling never throws. All calls come from one thread.</summary>
public sealed class PlayerMessages
{
    private const string Prefix = "GtaDataHarvester: ";
    private const double RepeatAfterMilliseconds = 5_000;
    private readonly string _logPath;
    private readonly Action<string> _show;
    private readonly DiskQueue _disk = new();
    private readonly IClock _clock;
    private readonly Dictionary<string, double> _failures = [];

    /// <summary>Makes the log's place known.</summary>
    /// <param name="folder">The folder that the mod lies in.</param>
    /// <param name="show">Shows a message in the game.</param>
    /// <param name="clock">The player's time.</param>
    public PlayerMessages(string folder, Action<string> show, IClock clock)
    {
        _logPath = Path.Combine(folder, "GtaDataHarvester.log");
        _show = show;
        _clock = clock;
    }

    /// <summary>Whether something is on its way to the log.</summary>
    public bool IsBusy => _disk.IsBusy;

    /// <summary>Tells the player, and the log.</summary>
    public void Tell(string message)
    {
        _failures.Clear();
        Show(message);
    }

    /// <summary>
    /// Tells the player that something failed, and the log why; the same again within five seconds only once as long as nothing but
    /// failures is told: what fails in every tick does not fill the disk.
    /// </summary>
    public void TellFailure(string what, Exception exception)
    {
        string message = $"{what} failed: {exception?.Message} More in GtaDataHarvester.log.";
        if (!_failures.TryGetValue(message, out double told) || IsLongAgo(told))
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

    /// <summary>Waits until all is in the log, at most so long.</summary>
    public void Wait(TimeSpan longest) => _disk.Wait(longest);

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
#pragma warning disable CA1031 // Who cannot be told cannot be told that either.
        catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
        {
            Trace.WriteLine(exception.Message);
        }
    }
}
