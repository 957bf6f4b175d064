using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

public sealed class HarvestOnRealRoadsTests
{
    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Harvest_on_the_games_own_streets_gives_a_valid_session()
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");

        CliRun run = CliRun.Of(
            "harvest", "--out", session, "--frames", "5", "--size", "320x240",
            "--roads", RealWorldFactAttribute.PathOf("nodes.zip")!, "--props", RealWorldFactAttribute.PathOf("worldTrafficLights.json")!, "--near", "0,-1000");

        Assert.Equal("", run.Error);
        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.StartsWith($"{session}: 5 frames, ", CliRun.Of("validate", session).Out, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", session).ExitCode);
    }

    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Harvest_far_from_any_road_is_a_usage_error()
    {
        using var folder = new TemporaryFolder();

        CliRun.Of(
            "harvest", "--out", folder.PathOf("session"), "--roads", RealWorldFactAttribute.PathOf("nodes.zip")!, "--near", "90000,90000")
            .AssertFailed(ExitCode.Usage, "road");
    }
}
