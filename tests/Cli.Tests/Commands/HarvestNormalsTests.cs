using Harvester.Cli.Terminals;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Maps of normals from the command line to the commands that read a session.</summary>
public sealed class HarvestNormalsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Maps_are_validated_and_kept_unless_the_lens_changes()
    {
        string session = _folder.PathOf("session");
        CliRun.Of("harvest", "--out", session, "--frames", "2", "--size", "80x60", "--normals", "--seed", "3", "--no-report").AssertDone();
        CliRun.Of("validate", "--schema", session).AssertDone();
        CliRun.Of("relabel", session, "--out", _folder.PathOf("same"), "--range", "30", "--no-report").AssertDone();
        string lens = _folder.File("lens.ini", "[Lens]\nFocalScale = 1.02\nCentreOffsetX = 0.001\nCentreOffsetY = 0\nK1 = -0.03\nK2 = 0\n");
        CliRun.Of("relabel", session, "--out", _folder.PathOf("bent"), "--calibration", lens, "--no-report").AssertDone();
        CliRun.Of("validate", "--schema", _folder.PathOf("same")).AssertDone();
        CliRun.Of("validate", "--schema", _folder.PathOf("bent")).AssertDone();

        Assert.Equal("normals/00000001.png", MapOf("same")!.File);
        Assert.Equal(
            File.ReadAllBytes(Path.Combine(session, "normals", "00000001.png")),
            File.ReadAllBytes(_folder.PathOf("same/normals/00000001.png"))
        );
        Assert.Null(MapOf("bent"));
        Assert.False(Directory.Exists(_folder.PathOf("bent/normals")));
        Assert.Contains("\"normals\": true", File.ReadAllText(_folder.PathOf("same/session.json")), StringComparison.Ordinal);
        Assert.DoesNotContain("normals", File.ReadAllText(_folder.PathOf("bent/session.json")), StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Map_of_another_format_is_a_problem()
    {
        string session = _folder.PathOf("grey");
        CliRun
            .Of("harvest", "--out", session, "--frames", "1", "--size", "80x60", "--normals", "--masks", "--seed", "3", "--no-report")
            .AssertDone();
        File.Copy(Path.Combine(session, "masks", "00000000.png"), Path.Combine(session, "normals", "00000000.png"), overwrite: true);

        CliRun validated = CliRun.Of("validate", session);

        Assert.Equal(ExitCode.BadData, validated.ExitCode);
        Assert.Contains(
            "map of normals 'normals/00000000.png' has 16 bits per pixel instead of 24.",
            validated.Out,
            StringComparison.Ordinal
        );
    }

    private MapLabel? MapOf(string session) => new SessionReader(_folder.PathOf(session)).ReadLabels().Last().Channels.Get<MapLabel>();
}
