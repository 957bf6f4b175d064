using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>Looks for harvests that threw many of their frames away, and says why, by the reasons of docs/dataset-format.md.</summary>
internal static class DiscardCheck
{
    /// <summary>A reason that took a smaller share of the frames begun is part of a good harvest.</summary>
    private const double UsualShare = 0.1;

    private static readonly Regex Counts =
        new(@"(?<captured>\d+) frames?, discarded: (?<discards>(\d+ [a-zA-Z]+(, )?)+)", RegexOptions.CultureInvariant);
    private static readonly Regex GivenFreeze =
        new(@"\[Harvest\] Freeze = (Paused|TimeScale)", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);

    /// <summary>The harvests that a log tells of.</summary>
    public static IEnumerable<Finding> Of(IReadOnlyList<LogLine> lines)
    {
        bool isFreezeGiven = lines.Any(line => GivenFreeze.IsMatch(line.Text));
        return lines
            .SelectMany(line => CountsIn(line.Text) is var (captured, discards) ? Of(captured, discards, isFreezeGiven, line) : [])
            .GroupBy(finding => finding.Cause)
            .Select(same => same.Last() with { Count = same.Count() });
    }

    /// <summary>One harvest.</summary>
    /// <param name="captured">Frames kept.</param>
    /// <param name="discards">Frames thrown away, by reason.</param>
    /// <param name="isFreezeGiven">Whether the way of freezing was given, not tried.</param>
    /// <param name="evidence">Where this is stated.</param>
    public static IEnumerable<Finding> Of(
        int captured, IReadOnlyList<KeyValuePair<string, int>> discards, bool isFreezeGiven, LogLine evidence)
    {
        int begun = captured + discards.Sum(discard => discard.Value);
        return discards
            .Where(discard => discard.Value > UsualShare * begun)
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
            ? (int.Parse(match.Groups["captured"].Value, CultureInfo.InvariantCulture), [.. match.Groups["discards"].Value
                .Split([", "], StringSplitOptions.RemoveEmptyEntries)
                .Select(part => part.Split(' '))
                .Select(part => KeyValuePair.Create(part[1], int.Parse(part[0], CultureInfo.InvariantCulture)))])
            : null;
    }

    private static (string Cause, string Advice) Explain(string reason, bool isFreezeGiven) => reason switch
    {
        "black" or "singleColour" => (
            "The pictures were black or of a single colour: the game runs in exclusive full screen, or the picture cannot be copied.",
            "Choose windowed borderless in the game's graphics settings."),
        "covered" => (
            "Something lay over the game's window.",
            "Move other windows and overlays away; harvest on a monitor of its own."),
        "minimised" or "noWindow" => (
            "The game's window was minimised or hidden.",
            "Leave the window open while a harvest runs; it need not be in the foreground."),
        "offScreen" => (
            "Some of the game's window was on no monitor.",
            "Move the window onto one monitor, or choose windowed borderless."),
        "resized" or "moved" => (
            "The game's window was moved or resized while a harvest ran.",
            "Leave it alone until the harvest has ended."),
        "unreadable" => (
            "Windows did not let the picture be copied: the computer was locked, or asked for a password.",
            "Leave the computer unlocked while a harvest runs."),
        "neverStill" => (
            "Something went on moving while the game was frozen.",
            isFreezeGiven ? "Set Freeze = Auto under [Harvest]." : "Remove mods that move the camera or the traffic."),
        "cameraMoved" or "egoMoved" or "objectMoved" or "objectsChanged" or "timeMoved" => (
            "The scene changed between picture and labels though the game was frozen.",
            isFreezeGiven ? "Set Freeze = Auto under [Harvest]." : "Remove mods that make, move or delete vehicles and people."),
        "tickMissed" => (
            "The game skipped frames of a live harvest.",
            "Lower the graphics settings or Rate under [Harvest], or harvest with Mode = Freeze."),
        _ => (
            $"Frames were thrown away for the reason {reason}.",
            "docs/dataset-format.md lists the reasons."),
    };
}
