using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>
/// Looks through a run of the mod for what shows in several lines together: features that never ended, and ticks that took long.
/// </summary>
internal static class RunCheck
{
    /// <summary>
    /// The time of a frame at 30 frames per second, milliseconds: a feature whose ticks take longer makes the game stutter.
    /// </summary>
    private const double LongTickMilliseconds = 1000.0 / 30;

    /// <summary>Those that copy pictures or stop the game, for which long ticks are usual.</summary>
    private static readonly string[] MayBeSlow = ["The harvest", "The calibration", "The survey of signs", "The drive"];

    private static readonly Regex Switching =
        new(@"^\S+ \S+ (?<feature>(The|Marking) [a-z ]+): (?<state>on|off)\b", RegexOptions.CultureInvariant);
    private static readonly Regex Figures =
        new(@"(?<natives>[\d.]+) natives per tick, .* p99 (?<p99>[\d.]+) ms", RegexOptions.CultureInvariant);

    public static IEnumerable<Finding> Of(IReadOnlyList<LogLine> lines) => [.. Unended(lines), .. Slow(lines)];

    private static IEnumerable<Finding> Unended(IReadOnlyList<LogLine> lines)
    {
        var on = new Dictionary<string, LogLine>(StringComparer.Ordinal);
        foreach (LogLine line in lines)
        {
            Match match = Switching.Match(line.Text);
            if (match.Success && match.Groups["state"].Value == "on")
            {
                on[match.Groups["feature"].Value] = line;
            }
            else if (match.Success)
            {
                on.Remove(match.Groups["feature"].Value);
            }
        }

        // Of several the last one to come on is the likeliest to have to do with it.
        return on.OrderBy(pair => pair.Value.Number).Reverse().Take(1).Select(pair => new Finding(
            $"The log ends while '{pair.Key}' is on: the game still runs, or it crashed or was killed.",
            "If it crashed: read the end of ScriptHookVDotNet.log and ScriptHookV.log, and after an update of the game install the latest ScriptHookVDotNet.",
            pair.Value));
    }

    private static IEnumerable<Finding> Slow(IReadOnlyList<LogLine> lines) => lines
        .Select(line => (Line: line, Switching: Switching.Match(line.Text), Figures: Figures.Match(line.Text)))
        .Where(found => found.Switching.Success && found.Figures.Success)
        .Select(found => (found.Line, Feature: found.Switching.Groups["feature"].Value, Natives: Number(found.Figures, "natives"),
            P99: Number(found.Figures, "p99")))
        .Where(found => found.P99 > LongTickMilliseconds && !MayBeSlow.Contains(found.Feature))
        .Select(found => new Finding(
            string.Create(CultureInfo.InvariantCulture, $"'{found.Feature}' makes the game stutter: one tick in a hundred takes {found.P99:0} ms or more, with {found.Natives:0} natives per tick."),
            "A native takes about 20 microseconds with ScriptHookVDotNet 3.6.0 and far less with the nightlies: install the latest nightly, or lower Range under [Harvest].",
            found.Line));

    private static double Number(Match match, string group) => double.Parse(match.Groups[group].Value, CultureInfo.InvariantCulture);
}
