using System.CommandLine;
using Harvester.Capture.Ports;
using Harvester.Runs.Faults;

namespace Harvester.Cli.Arguments;

/// <summary>--freeze: how the game is frozen for a frame.</summary>
internal static class FreezeOption
{
    private const string Auto = "auto";
    private const string Paused = "paused";
    private const string TimeScale = "timeScale";

    public static Option<string> Create() =>
        new("--freeze")
        {
            Description =
                $"How to freeze the game for a frame: {Paused}, {TimeScale}, or {Auto} to measure both at the start and use the "
                + "better one",
            HelpName = "METHOD",
            DefaultValueFactory = _ => Paused,
        };

    /// <summary>The method that a value names; null for auto.</summary>
    /// <exception cref="UsageException">The value is not a method.</exception>
    public static FreezeMethod? Parse(string value) =>
        value.ToLowerInvariant() switch
        {
            Paused => FreezeMethod.Paused,
            "timescale" => FreezeMethod.TimeScale,
            Auto => null,
            _ => throw new UsageException($"--freeze takes {Paused}, {TimeScale} or {Auto}, not '{value}'."),
        };
}
