using System.Globalization;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests;

/// <summary>Seeds of the worlds in which heavy tests of measured paint take their figures.</summary>
internal static class TestSeeds
{
    /// <summary>The seeds in the environment variable GTADATAHARVESTER_PAINT_SEEDS, separated by commas.</summary>
    /// <param name="inCi">The seeds that CI tries where the variable is not set.</param>
    /// <param name="full">All.</param>
    public static IEnumerable<int> Or(int[] inCi, int[] full) =>
        Environment.GetEnvironmentVariable("GTADATAHARVESTER_PAINT_SEEDS") is { } seeds
            ? seeds.Split(',').Select(static seed => int.Parse(seed, CultureInfo.InvariantCulture))
            : ProofSize.Of(inCi, full);
}
