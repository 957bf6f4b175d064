using Harvester.Cli.Terminals;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Voxels from the command line to the commands that read a session.</summary>
public sealed class HarvestOccupancyTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Voxels_are_validated_and_kept()
    {
        string session = Harvest();
        CliRun.Of("validate", "--schema", session).AssertDone();
        CliRun.Of("relabel", session, "--out", _folder.PathOf("same"), "--range", "60", "--no-report").AssertDone();

        OccupancyLabel map = new SessionReader(_folder.PathOf("same")).ReadLabels().Single().Channels.Get<OccupancyLabel>()!;
        Assert.Equal(VoxelShape.Usual, map.Shape);
        Assert.Equal("occupancy-instances/00000000.png", map.Instances);
    }

    [Fact]
    public void Values_that_are_no_classes_are_a_problem()
    {
        string session = Harvest();
        string classes = Path.Combine(session, "occupancy", "00000000.png");
        string visible = Path.Combine(session, "occupancy-visible", "00000000.png");
        File.Copy(classes, _folder.PathOf("classes.png"));
        File.Copy(visible, classes, overwrite: true);
        File.Copy(_folder.PathOf("classes.png"), visible, overwrite: true);
        File.Delete(Path.Combine(session, "manifest.jsonl"));

        CliRun validated = CliRun.Of("validate", session);

        Assert.Equal(ExitCode.BadData, validated.ExitCode);
        Assert.Contains("map of voxels 'occupancy-visible/00000000.png' has the value", validated.Out, StringComparison.Ordinal);
        Assert.Contains("has a number where 'occupancy/00000000.png' has no object.", validated.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void A_range_that_is_too_short_is_refused()
    {
        CliRun run = CliRun.Of(
            "harvest",
            "--out",
            _folder.PathOf("refused"),
            "--frames",
            "1",
            "--occupancy",
            "--range",
            "20",
            "--ignore-range",
            "20",
            "--no-report"
        );

        Assert.NotEqual(ExitCode.Done, run.ExitCode);
        Assert.Contains("Voxels reach 56.8 m, but objects are read up to 20 m.", run.Error, StringComparison.Ordinal);
    }

    private string Harvest()
    {
        string session = _folder.PathOf("session");
        CliRun
            .Of(
                "harvest",
                "--out",
                session,
                "--frames",
                "1",
                "--size",
                "80x60",
                "--seed",
                "3",
                "--places",
                "1",
                "--occupancy",
                "--no-report"
            )
            .AssertDone();
        return session;
    }
}
