using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Terminals;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Arguments;

/// <summary>The option that lets the simulated game misbehave as the real one does.</summary>
internal static class QuirkList
{
    private const string Form =
        "lag=N, lateCamera, vanish=P, boxRays, missedRays=P, and while the world is frozen creep=N, restless, heldCamera, weather, visibility; "
        + "the prefix paused. or timeScale. limits one of the latter to one freeze method (N: 0 to 60 ticks; P: fraction, 0 to 1)";
    private const int MaxTicks = 60;

    public static Option<string?> Option() => new("--quirks")
    {
        Description = "Imitate faults of the real game, separated by commas: " + Form,
        HelpName = "A,B",
    };

    /// <exception cref="UsageException">A part of the list is no quirk.</exception>
    public static GameQuirks Parse(string? list)
    {
        GameQuirks quirks = new();
        foreach (string part in list?.Split(',') ?? [])
        {
            quirks = With(quirks, part.Trim())
                ?? throw new UsageException($"--quirks takes a comma-separated list of {Form}, not '{part.Trim()}'.");
        }

        return quirks;
    }

    private static GameQuirks? With(GameQuirks quirks, string part)
    {
        string[] halves = part.Split('=', 2);
        string? value = halves.Length > 1 ? halves[1] : null;
        return (halves[0], value) switch
        {
            ("lag", not null) => Ticks(value) is { } lag ? quirks with { PictureLagTicks = lag } : null,
            ("vanish", not null) => Fraction(value) is { } gone ? quirks with { VanishingFraction = gone } : null,
            ("missedRays", not null) => Fraction(value) is { } missed ? quirks with { RayMissFraction = missed } : null,
            ("lateCamera", null) => quirks with { IsCameraReportedLate = true },
            ("boxRays", null) => quirks with { RaysMeetBoxes = true },
            _ => WithFreezing(quirks, halves[0], value),
        };
    }

    /// <summary>A quirk of both ways of freezing, or of the one that its name begins with.</summary>
    private static GameQuirks? WithFreezing(GameQuirks quirks, string name, string? value)
    {
        string[] parts = name.Split('.', 2);
        return parts switch
        {
            [_] => With(quirks.Paused, name, value) is { } paused && With(quirks.TimeScale, name, value) is { } timeScale
                ? quirks with { Paused = paused, TimeScale = timeScale }
                : null,
            ["paused", var quirk] => With(quirks.Paused, quirk, value) is { } changed ? quirks with { Paused = changed } : null,
            ["timeScale", var quirk] => With(quirks.TimeScale, quirk, value) is { } changed ? quirks with { TimeScale = changed } : null,
            _ => null,
        };
    }

    private static FreezeQuirks? With(FreezeQuirks quirks, string name, string? value) => (name, value) switch
    {
        ("creep", not null) => Ticks(value) is { } creep ? quirks with { CreepTicks = creep } : null,
        ("restless", null) => quirks with { NeverStands = true },
        ("heldCamera", null) => quirks with { HoldsCamera = true },
        ("weather", null) => quirks with { LetsWeatherGoOn = true },
        ("visibility", null) => quirks with { ChangesVisibility = true },
        _ => null,
    };

    private static int? Ticks(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int ticks) && ticks <= MaxTicks ? ticks : null;

    private static double? Fraction(string text) =>
        double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double fraction) && fraction <= 1
            ? fraction : null;
}
