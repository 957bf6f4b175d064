using System.Globalization;

namespace Harvester.Cli.Tests;

/// <summary>Seeds of the worlds in which heavy tests of measured paint take their figures.</summary>
internal static class TestSeeds
{
    /// <summary>The seeds in the environment variable GTADATAHARVESTER_PAINT_SEEDS, separated by commas.</summary>
    /// <param name="usual">The seeds where the variable is not set.</param>
    public static IEnumerable<int> Or(string usual) =>
        (Environment.GetEnvironmentVariable("GTADATAHARVESTER_PAINT_SEEDS") ?? usual)
            .Split(',')
            .Select(static seed => int.Parse(seed, CultureInfo.InvariantCulture));
}
