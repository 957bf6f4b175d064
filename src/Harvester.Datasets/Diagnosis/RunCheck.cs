using System.Globalization;
using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>Finds problems that several lines of a run show together: features that never ended, and slow ticks.</summary>
internal static class RunCheck
{
    /// <summary>Duration of a frame at 30 frames per second, milliseconds: a feature with longer ticks makes the game stutter.</summary>
    private const double LongTickMilliseconds = 1000.0 / 30;

    /// <summary>Features that copy images or freeze the game, for which long ticks are normal.</summary>
    private static readonly string[] MayBeSlow = ["The harvest", "The calibration", "The survey of signs", "The drive"];

    private static readonly Regex Switching = new(
        @"^\S+ \S+ (?<feature>(The|Marking) [a-z ]+): (?<state>on|off)\b",
        RegexOptions.CultureInvariant
    );
    private static readonly Regex Figures = new(
        @"(?<natives>[\d.]+) natives per tick, .* p99 (?<p99>[\d.]+) ms",
        RegexOptions.CultureInvariant
    );

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

        // The feature that was switched on last is the likeliest cause.
        return on.OrderBy(pair => pair.Value.Number)
            .Reverse()
            .Take(1)
            .Select(pair => new Finding(
                $"The log ends while '{pair.Key}' is on: the game still runs, or it crashed or was killed.",
                "If it crashed, read the end of ScriptHookVDotNet.log and ScriptHookV.log; after an update of the game, install the "
                    + "latest ScriptHookVDotNet.",
                pair.Value
            ));
    }

    private static IEnumerable<Finding> Slow(IReadOnlyList<LogLine> lines) =>
        lines
            .Select(line => (Line: line, Switching: Switching.Match(line.Text), Figures: Figures.Match(line.Text)))
            .Where(found => found.Switching.Success && found.Figures.Success)
            .Select(found =>
                (
                    found.Line,
                    Feature: found.Switching.Groups["feature"].Value,
                    Natives: Number(found.Figures, "natives"),
                    P99: Number(found.Figures, "p99")
                )
            )
            .Where(found => found.P99 > LongTickMilliseconds && !MayBeSlow.Contains(found.Feature))
            .Select(found => new Finding(
                $"'{found.Feature}' makes the game stutter: one tick in a hundred takes "
                    + FormattableString.Invariant($"{found.P99:0} ms or more, with {found.Natives:0} native calls per tick."),
                "A native call takes about 20 microseconds with ScriptHookVDotNet 3.6.0 and far less with the nightlies. "
                    + "Install the latest "
                    + "nightly, or lower Range under [Harvest].",
                found.Line
            ));

    private static double Number(Match match, string group) => double.Parse(match.Groups[group].Value, CultureInfo.InvariantCulture);
}
