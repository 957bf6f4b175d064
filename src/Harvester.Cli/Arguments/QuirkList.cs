using System.CommandLine;
using System.Globalization;
using Harvester.Runs.Faults;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Arguments;

/// <summary>--quirks: faults of the real game that the simulated game imitates.</summary>
internal static class QuirkList
{
    /// <summary>The quirks, for the help of a command that has the option.</summary>
    public const string Notes =
        "Quirks imitate faults of the real game (N: 0 to 60 ticks of 1/60 s; P: fraction, 0 to 1):\n"
        + "  lag=N          the image is N ticks older than the state of the game\n"
        + "  lateCamera     the camera is reported as it was one tick ago\n"
        + "  vanish=P       at a fraction P of snapshots, an object disappears right afterwards\n"
        + "  boxRays        rays hit the box around an object instead of its shape\n"
        + "  missedRays=P   rays pass through a fraction P of the moving vehicles beyond 30 m\n"
        + "  lateHiding=N   objects are hidden and shown N ticks after the harvest asks for it\n"
        + "  slowSky=N      a new weather or time of day fades in within N ticks\n"
        + "  unhideable=P   a fraction P of the objects cannot be hidden\n"
        + "  shadowsRemain  hidden objects still cast shadows\n"
        + "  noise=L        every pixel has noise with a standard deviation of L grey levels, 0 to 20\n"
        + "  movingTextures textures move on in a tenth of the world while it is frozen\n"
        + "  creep=N        a frozen world moves on for up to N ticks\n"
        + "  restless       a frozen world never stands still\n"
        + "  heldCamera     the camera cannot be moved while the world is frozen\n"
        + "  weather        rain and the time of day go on while the world is frozen\n"
        + "  visibility     vehicles appear and disappear while the world is frozen\n"
        + "The last five apply to both freeze methods; the prefix paused. or timeScale., as in paused.creep=3, limits them to one.";

    private const string Form =
        "lag=N, lateCamera, vanish=P, boxRays, missedRays=P, lateHiding=N, slowSky=N, unhideable=P, shadowsRemain, noise=L, "
        + "movingTextures, creep=N, restless, heldCamera, weather and visibility";
    private const int MaxTicks = 60;
    private const double MaxLevels = 20;

    public static Option<string?> Option() =>
        new("--quirks") { Description = "Imitate faults of the real game, see below; separated by commas", HelpName = "A,B" };

    /// <exception cref="UsageException">An entry of the list is not a quirk.</exception>
    public static GameQuirks Parse(string? list)
    {
        GameQuirks quirks = new();
        foreach (string part in list?.Split(',') ?? [])
        {
            quirks =
                With(quirks, part.Trim())
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
            ("lateHiding", not null) => Ticks(value) is { } late ? quirks with { VisibilityDelayTicks = late } : null,
            ("slowSky", not null) => Ticks(value) is { } slow ? quirks with { SlowSkyTicks = slow } : null,
            ("unhideable", not null) => Fraction(value) is { } shown ? quirks with { UnhideableFraction = shown } : null,
            ("shadowsRemain", null) => quirks with { ShadowsRemain = true },
            ("noise", not null) => Levels(value) is { } levels ? quirks with { PictureNoiseLevels = levels } : null,
            ("movingTextures", null) => quirks with { TexturesMove = true },
            ("boxRays", null) => quirks with { RaysMeetBoxes = true },
            _ => WithFreezing(quirks, halves[0], value),
        };
    }

    /// <summary>A quirk of both freeze methods, or of the one in its prefix.</summary>
    private static GameQuirks? WithFreezing(GameQuirks quirks, string name, string? value)
    {
        string[] parts = name.Split('.', 2);
        return parts switch
        {
            [_] => With(quirks.Paused, name, value) is { } paused && With(quirks.TimeScale, name, value) is { } timeScale
                ? quirks with
                {
                    Paused = paused,
                    TimeScale = timeScale,
                }
                : null,
            ["paused", var quirk] => With(quirks.Paused, quirk, value) is { } changed ? quirks with { Paused = changed } : null,
            ["timeScale", var quirk] => With(quirks.TimeScale, quirk, value) is { } changed ? quirks with { TimeScale = changed } : null,
            _ => null,
        };
    }

    private static FreezeQuirks? With(FreezeQuirks quirks, string name, string? value) =>
        (name, value) switch
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

    private static double? Levels(string text) =>
        double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double levels) && levels <= MaxLevels
            ? levels
            : null;

    private static double? Fraction(string text) =>
        double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double fraction) && fraction <= 1
            ? fraction
            : null;
}
