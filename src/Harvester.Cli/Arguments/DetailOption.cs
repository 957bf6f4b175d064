using System.CommandLine;
using Harvester.Runs.Faults;
using Harvester.Simulation.Rendering;

namespace Harvester.Cli.Arguments;

/// <summary>--detail: how much of the light pictures show.</summary>
internal static class DetailOption
{
    private const string Plain = "plain";

    /// <summary>The value for all of the light.</summary>
    public const string Full = "full";

    public static Option<string> Create() =>
        new("--detail")
        {
            Description = $"Pictures of the simulated game: {Plain}, or {Full} with shadows, worn and wet roads; labels are the same",
            HelpName = "LEVEL",
            DefaultValueFactory = _ => Plain,
        };

    /// <summary>The level that a value names.</summary>
    /// <exception cref="UsageException">The value is not a level.</exception>
    public static Detail Parse(string value) =>
        value.ToLowerInvariant() switch
        {
            Plain => Detail.Plain,
            Full => Detail.Full,
            _ => throw new UsageException($"--detail takes {Plain} or {Full}, not '{value}'."),
        };
}
