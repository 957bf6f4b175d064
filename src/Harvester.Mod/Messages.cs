using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using GTA.UI;

namespace Harvester.Mod;

/// <summary>What the mod tells: messages to the player above the map, and a log file beside the dll. Telling never throws.</summary>
internal sealed class Messages
{
    private const string Prefix = "GtaDataHarvester: ";
    private const long RepeatAfterMilliseconds = 5_000;
    private readonly string _logPath;
    private readonly Stopwatch _sinceLast = Stopwatch.StartNew();
    private string _last = string.Empty;

    /// <summary>Makes the log's place known.</summary>
    /// <param name="folder">The folder that the mod lies in.</param>
    public Messages(string folder) => _logPath = Path.Combine(folder, "GtaDataHarvester.log");

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
        Quietly(() => Notification.Show(Prefix + message));
    }

    /// <summary>Tells the player that something failed, and the log why.</summary>
    public void TellFailure(string what, Exception exception)
    {
        Log(exception.ToString());
        Tell($"{what} failed: {exception.Message} More in GtaDataHarvester.log.");
    }

    /// <summary>Writes a line to the log.</summary>
    public void Log(string line) => Quietly(() => File.AppendAllText(
        _logPath, DateTime.Now.ToString("yyyy-MM-dd HH:mm:ss ", CultureInfo.InvariantCulture) + line + Environment.NewLine));

    private static void Quietly(Action tell)
    {
        try
        {
            tell();
        }
        catch (Exception exception) when (exception is not ThreadAbortException)
        {
            Trace.WriteLine(exception.Message);
        }
    }
}
