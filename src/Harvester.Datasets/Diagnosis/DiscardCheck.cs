using System.Globalization;
using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>Finds harvests that discarded many of their frames, and explains the reasons of docs/dataset-format.md.</summary>
internal static class DiscardCheck
{
    /// <summary>A reason with a smaller fraction of the started frames is normal.</summary>
    private const double MaxUsualFraction = 0.1;

    private static readonly Regex Counts = new(
        @"(?<captured>\d+) frames?, discarded: (?<discards>(\d+ [a-zA-Z]+(, )?)+)",
        RegexOptions.CultureInvariant
    );
    private static readonly Regex GivenFreeze = new(
        @"\[Harvest\] Freeze = (Paused|TimeScale)",
        RegexOptions.CultureInvariant | RegexOptions.IgnoreCase
    );

    /// <summary>The findings for the harvests in a log.</summary>
    public static IEnumerable<Finding> Of(IReadOnlyList<LogLine> lines)
    {
        bool isFreezeGiven = lines.Any(line => GivenFreeze.IsMatch(line.Text));
        return lines
            .SelectMany(line => CountsIn(line.Text) is var (captured, discards) ? Of(captured, discards, isFreezeGiven, line) : [])
            .GroupBy(finding => finding.Cause)
            .Select(same => same.Last() with { Count = same.Count() });
    }

    /// <summary>The findings for one harvest.</summary>
    /// <param name="captured">Number of frames kept.</param>
    /// <param name="discards">Number of frames discarded, by reason.</param>
    /// <param name="isFreezeGiven">Whether the freeze method was configured, not chosen automatically.</param>
    /// <param name="evidence">The line with these numbers.</param>
    public static IEnumerable<Finding> Of(
        int captured,
        IReadOnlyList<KeyValuePair<string, int>> discards,
        bool isFreezeGiven,
        LogLine evidence
    )
    {
        int begun = captured + discards.Sum(discard => discard.Value);
        return discards
            .Where(discard => discard.Value > MaxUsualFraction * begun)
            .OrderByDescending(discard => discard.Value)
            .Select(discard =>
            {
                (string cause, string advice) = Explain(discard.Key, isFreezeGiven);
                return new Finding(cause, advice, evidence);
            });
    }

    private static (int Captured, KeyValuePair<string, int>[] Discards)? CountsIn(string text)
    {
        Match match = Counts.Match(text);
        return match.Success
            ? (
                int.Parse(match.Groups["captured"].Value, CultureInfo.InvariantCulture),
                [
                    .. match
                        .Groups["discards"]
                        .Value.Split([", "], StringSplitOptions.RemoveEmptyEntries)
                        .Select(part => part.Split(' '))
                        .Select(part => KeyValuePair.Create(part[1], int.Parse(part[0], CultureInfo.InvariantCulture))),
                ]
            )
            : null;
    }

    private static (string Cause, string Advice) Explain(string reason, bool isFreezeGiven) =>
        reason switch
        {
            "black" or "singleColour" => (
                "The images were black or of a single colour: the game runs in exclusive full screen, or its window cannot be copied.",
                "Choose windowed borderless in the game's graphics settings."
            ),
            "covered" => (
                "Something covered the game's window.",
                "Move other windows and overlays away, or give the game a monitor of its own."
            ),
            "minimised" or "noWindow" => (
                "The game's window was minimised or hidden.",
                "Keep the window open while a harvest runs; it need not be in the foreground."
            ),
            "offScreen" => (
                "Part of the game's window was outside the monitors.",
                "Move the window onto one monitor, or choose windowed borderless."
            ),
            "resized" or "moved" => (
                "The game's window was moved or resized while a harvest ran.",
                "Do not move or resize it until the harvest has ended."
            ),
            "unreadable" => (
                "Windows did not allow the screen to be copied: the computer was locked, or asked for a password.",
                "Keep the computer unlocked while a harvest runs."
            ),
            "neverStill" => (
                "Something kept moving while the game was frozen.",
                isFreezeGiven ? "Set Freeze = Auto under [Harvest]." : "Remove mods that move the camera or the traffic."
            ),
            "cameraMoved" or "egoMoved" or "objectMoved" or "objectsChanged" or "timeMoved" => (
                "The scene changed between image and labels although the game was frozen.",
                isFreezeGiven ? "Set Freeze = Auto under [Harvest]." : "Remove mods that create, move or delete vehicles or people."
            ),
            "tickMissed" => (
                "The game skipped frames of a live harvest.",
                "Lower the graphics settings or Rate under [Harvest], or harvest with Mode = Freeze."
            ),
            "groundNotLoaded" or "vehicleNotPlaced" => (
                "The survey of paint left places out, where the game loaded no ground or the vehicle did not stand.",
                "Start it again by its key: it photographs what is left."
            ),
            _ => ($"Frames were discarded for the reason {reason}.", "docs/dataset-format.md lists the reasons."),
        };
}
