using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using Harvester.Capture.Storage;

namespace Harvester.Capture.Playing;

/// <summary>What the mod tells: messages to the player, and a log file. Telling never throws. All calls come from one thread.</summary>
public sealed class PlayerMessages
{
    private const string Prefix = "GtaDataHarvester: ";
    private const long RepeatAfterMilliseconds = 5_000;
    private readonly string _logPath;
    private readonly Action<string> _show;
    private readonly DiskQueue _disk = new();
    private readonly Stopwatch _sinceLast = Stopwatch.StartNew();
    private string _last = string.Empty;

    /// <summary>Makes the log's place known.</summary>
    /// <param name="folder">The folder that the mod lies in.</param>
    /// <param name="show">Shows a message in the game.</param>
    public PlayerMessages(string folder, Action<string> show)
    {
        _logPath = Path.Combine(folder, "GtaDataHarvester.log");
        _show = show;
    }

    /// <summary>Whether something is on its way to the log.</summary>
    public bool IsBusy => _disk.IsBusy;

    /// <summary>Tells the player, and the log; the same message again within five seconds only once.</summary>
    public void Tell(string message)
    {
        if (message == _last && _sinceLast.ElapsedMilliseconds < RepeatAfterMilliseconds)
        {
            return;
        }

        _last = message;
        _sinceLast.Restart();
        Log(message);
        Quietly(() => _show(Prefix + message));
    }

    /// <summary>Tells the player that something failed, and the log why.</summary>
    public void TellFailure(string what, Exception exception)
    {
        Log(exception?.ToString() ?? what);
        Tell($"{what} failed: {exception?.Message} More in GtaDataHarvester.log.");
    }

    /// <summary>Writes a line to the log, on another thread.</summary>
    public void Log(string line)
    {
        string entry = DateTime.Now.ToString("yyyy-MM-dd HH:mm:ss ", CultureInfo.InvariantCulture) + line + Environment.NewLine;
        _disk.Add(() => Quietly(() => File.AppendAllText(_logPath, entry)));
    }

    /// <summary>Waits until all is in the log, at most so long.</summary>
    public void Wait(TimeSpan longest) => _disk.Wait(longest);

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
