using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Controllers;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Peers;

/// <summary>
/// The far end of a folder bridge: state.txt in, controls.txt and command.json out, each whole by renaming. It tells neither where the car
/// points nor how wide its lane is; the latter is taken for that of ordinary roads.
/// </summary>
/// <param name="folder">The shared folder.</param>
public sealed class FolderLink(string folder) : IPeerLink
{
    private const int Values = IndicatorOrder.Count + 4;
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(3);

    private long _lastFrame = -1;
    private int _steps;

    /// <inheritdoc/>
    public PeerFrame? Receive(TimeSpan patience)
    {
        var waited = Stopwatch.StartNew();
        do
        {
            if (TryRead() is { } frame && frame.Frame != _lastFrame)
            {
                _lastFrame = frame.Frame;
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

    /// <inheritdoc/>
    public void Step(double seconds)
    {
        // A file of the same time and length would not be taken for new: blanks tell one from the next.
        _steps = (_steps + 1) % 16;
        WriteWhole("command.json", string.Create(CultureInfo.InvariantCulture, $"{{\"type\":\"step\",\"seconds\":{seconds}}}") + new string(' ', _steps));
    }

    /// <summary>Nothing is held.</summary>
    public void Dispose()
    {
    }

    private PeerFrame? TryRead()
    {
        string[] words;
        try
        {
            words = File.ReadAllText(Path.Combine(folder, "state.txt")).Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return null;
        }

        if (words.Length < Values)
        {
            return null;
        }

        double[] numbers = [.. words.Take(Values).Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
        LaneIndicators torcs = PeerIndicators.Of(numbers[..IndicatorOrder.Count]);
        const int frame = IndicatorOrder.Count, time = frame + 1, speed = frame + 2, fast = frame + 3;
        return new PeerFrame((long)numbers[frame], numbers[time], new DrivingState(
            TorcsEquivalent.InMetres(torcs, PeerIndicators.Ordinary), torcs, numbers[fast] > 0, numbers[speed]));
    }

    private void WriteWhole(string name, string text)
    {
        string path = Path.Combine(folder, name);
        File.WriteAllText(path + ".part", text);
        File.Move(path + ".part", path, overwrite: true);
    }
}
