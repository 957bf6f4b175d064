using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

/// <summary>data/example-roads.csv, which the examples of the docs drive on.</summary>
public sealed class ExampleRoadsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Example_network_is_that_of_the_town_of_seed_3()
    {
        string session = _folder.PathOf("session");
        SharedHarvest.CopyTo(session, "--frames", "1", "--seed", "3", "--size", "80x60", "--no-report");

        Assert.Equal(
            File.ReadAllText(Path.Combine(session, "scenes", "roads.csv")),
            File.ReadAllText(Path.Combine(RepositoryFolder.Path, "data", "example-roads.csv"))
        );
    }

    [Fact]
    public void Lanes_of_the_printed_place_on_it_are_known()
    {
        string roads = Path.Combine(RepositoryFolder.Path, "data", "example-roads.csv");

        CliRun run = CliRun.Of("lanes", "--roads", roads, "--position=-243,68.6,27.2", "--heading", "1");

        Assert.Equal(0, run.ExitCode);
        Assert.Contains("\"status\": \"known\"", run.Out, StringComparison.Ordinal);
    }
}
