using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Files;

namespace Harvester.Evaluation.Clients;

/// <summary>
/// The far end of a folder bridge: state.txt in, controls.txt and command.json out, each whole by renaming. It tells neither where the car
/// is, where it points nor how wide its lane is; the latter is taken for that of ordinary roads. A state that stood there before does not
/// count.
/// </summary>
public sealed class FolderLink : IBridgeLink
{
    private static readonly int Values = IndicatorTable.Count + 4;
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(3);

    /// <summary>A file that somebody else has open for a moment, or a disk that fails for one, is tried again for so long.</summary>
    private static readonly TimeSpan PatienceOfWriting = TimeSpan.FromSeconds(2);

    private readonly string _folder;
    private string? _seen;
    private bool _isHeard;
    private int _commands;

    /// <summary>Looks into the folder.</summary>
    /// <param name="folder">The shared folder.</param>
    /// <exception cref="IOException">It is not there, or nothing can be written there.</exception>
    public FolderLink(string folder)
    {
        _folder = Directory.Exists(folder) ? folder
            : throw new IOException($"Shared folder not found: '{folder}'. Start the game's side first; it creates the folder.");
        _seen = ReadState();

        AskForFrame();
    }

    /// <summary>A file may be written by somebody else before the game has read it.</summary>
    public bool MayLose => true;

    /// <inheritdoc/>
    public ClientFrame? Receive(TimeSpan patience)
    {
        var waited = Stopwatch.StartNew();
        do
        {
            string? state = ReadState();
            if (state is not null && state != _seen && FrameOf(state) is { } frame)
            {
                _seen = state;
                _isHeard = true;
                return frame;
            }

            Thread.Sleep(Poll);
        }
        while (waited.Elapsed < patience);
        return null;
    }

    /// <inheritdoc/>
    public void Send(DrivingControls controls, long frame) => WriteWhole(
        "controls.txt", FormattableString.Invariant($"{controls.Steering:0.######} {controls.Throttle:0.######} {controls.Brake:0.######} {frame}\n"));

    /// <summary>
    /// Asks for a frame; until the first has come by a hello, with which a world goes on that an earlier client has stopped.
    /// </summary>
    public void AskForFrame() => Command(_isHeard ? "{\"type\":\"requestFrame\"}" : "{\"type\":\"hello\"}");

    /// <inheritdoc/>
    public void Step(double seconds) =>
        Command(string.Create(CultureInfo.InvariantCulture, $"{{\"type\":\"step\",\"seconds\":{seconds}}}"));

    /// <summary>Nothing is held.</summary>
    public void Dispose()
    {
    }

    private string? ReadState()
    {
        try
        {
            return File.ReadAllText(Path.Combine(_folder, "state.txt"));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // It is being replaced just now, or is not there yet; what lasts is told by the silence.
            return null;
        }
    }

    /// <summary>What a state says; null for one that is not whole.</summary>
    private static ClientFrame? FrameOf(string state)
    {
        string[] words = state.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        double[] numbers = new double[Values];
        for (int i = 0; i < Values; i++)
        {
            if (i >= words.Length || !TryNumber(words[i], out numbers[i]))
            {
                return null;
            }
        }

        // The picture's name lies between.
        if (words.Length < Values + 2 || !TryNumber(words[Values + 1], out double angleAhead))
        {
            return null;
        }

        LaneIndicators torcs = ClientIndicators.Of(numbers[..IndicatorTable.Count]);
        int frame = IndicatorTable.Count, time = frame + 1, speed = frame + 2, fast = frame + 3;
        DrivingState seen = new(
            ClientIndicators.InMetres(torcs, ClientIndicators.Ordinary, angleAhead), torcs, numbers[fast] > 0, numbers[speed]);
        return new ClientFrame((long)numbers[frame], numbers[time], seen, null);
    }

    private static bool TryNumber(string word, out double number) =>
        double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out number);

    private void Command(string json)
    {
        // A file of the same time and length would not be taken for new: blanks tell one from the next.
        _commands = (_commands + 1) % 16;
        WriteWhole("command.json", json + new string(' ', _commands));
    }

    private void WriteWhole(string name, string text)
    {
        string path = Path.Combine(_folder, name);
        var tried = Stopwatch.StartNew();
        while (true)
        {
            try
            {
                AtomicFile.Write(path, text);
                return;
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException && tried.Elapsed < PatienceOfWriting)
            {
                Thread.Sleep(Poll);
            }
        }
    }
}
