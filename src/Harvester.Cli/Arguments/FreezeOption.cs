using System.CommandLine;
using Harvester.Capture.Ports;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Arguments;

/// <summary>The option that says how a game is made to stand still for a frame.</summary>
internal static class FreezeOption
{
    private const string Auto = "auto";
    private const string Paused = "paused";
    private const string TimeScale = "timeScale";

    public static Option<string> Create() => new("--freeze")
    {
        Description = $"How to freeze the game for a frame: {Paused}, {TimeScale}, or {Auto} to measure both at the start and use the better one",
        HelpName = "METHOD",
        DefaultValueFactory = _ => Paused,
    };

    /// <summary>The way that a value names; null for the better one.</summary>
    /// <exception cref="UsageException">The value is none of those that the option takes.</exception>
    public static FreezeMethod? Parse(string value) => value switch
    {
        Paused => FreezeMethod.Paused,
        TimeScale => FreezeMethod.TimeScale,
        Auto => null,
        _ => throw new UsageException($"--freeze takes {Paused}, {TimeScale} or {Auto}, not '{value}'."),
    };
}
