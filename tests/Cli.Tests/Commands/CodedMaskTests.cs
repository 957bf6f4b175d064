using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>A session with masks from photographs, and what other commands make of it.</summary>
public sealed class CodedMaskTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public CodedMaskTests() =>
        Run("harvest", "--out", Session, "--frames", "1", "--seed", "7", "--size", "160x120", "--masks", "coded", "--no-report");

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Labels_have_amodal_masks_with_their_boxes()
    {
        Run("validate", Session);

        Assert.Contains("\"amodalMask\":{", LabelsOf(Session), StringComparison.Ordinal);
        Assert.Contains("\"box2dWhole\":[", LabelsOf(Session), StringComparison.Ordinal);
        Assert.Contains("\"maskMethod\": \"coded\"", File.ReadAllText(Path.Combine(Session, "session.json")), StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Relabel_keeps_amodal_masks()
    {
        Run("relabel", Session, "--out", _folder.PathOf("again"));

        Assert.Equal(LabelsOf(Session), LabelsOf(_folder.PathOf("again")));
    }

    [Fact]
    public void Import_of_other_masks_removes_amodal_masks()
    {
        string masks = _folder.PathOf("masks");
        Directory.CreateDirectory(masks);
        File.Copy(Path.Combine(Session, "masks", "00000000.png"), Path.Combine(masks, "00000000.png"));

        Run("masks", "import", Session, masks);
        Run("validate", Session);

        Assert.DoesNotContain("amodalMask", LabelsOf(Session), StringComparison.Ordinal);
        Assert.DoesNotContain("box2dWhole", LabelsOf(Session), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--shard", "1/2")]
    [InlineData("--resume")]
    [Trait("Category", "Heavy")]
    public void Comparison_of_masks_needs_a_whole_harvest(params string[] part) =>
        CliRun
            .Of(["harvest", "--out", _folder.PathOf("part"), "--masks", "both", .. part])
            .AssertFailed(ExitCode.Usage, "use it without --shard and --resume");

    private static string LabelsOf(string session) => File.ReadAllText(Path.Combine(session, "labels.jsonl"));

    private static void Run(params string[] line)
    {
        CliRun run = CliRun.Of(line);
        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
    }
}
