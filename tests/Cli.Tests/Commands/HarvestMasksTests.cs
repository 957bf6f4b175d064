using System.Text.Json;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>What harvests let their masks cost.</summary>
public sealed class HarvestMasksTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Frames_respect_the_ray_limit()
    {
        Harvest(Session, "--frames", "2", "--masks", "--rays", "1000");

        Assert.All(
            new SessionReader(Session).ReadLabels(),
            label =>
            {
                Assert.InRange(label.Rays!.Total, 1, 1000);
                Assert.Equal(label.PixelMap!.RaysCast, label.Rays.Map);
            }
        );
        Assert.Equal(1000, OptionOfSession("rayBudget"));
    }

    [Theory]
    [InlineData("--masks")]
    [InlineData("--no-report")]
    [Trait("Category", "Heavy")]
    public void Objects_beyond_the_reach_of_rays_are_ignore_regions(string option)
    {
        Harvest(Session, "--frames", "2", option, "--ray-reach", "20");

        FrameLabel[] labels = [.. new SessionReader(Session).ReadLabels()];
        Assert.DoesNotContain(labels.SelectMany(label => label.Objects), item => item.DistanceMetres > 40);
        Assert.Contains(
            labels.SelectMany(label => label.IgnoreRegions),
            region => region is { Reason: IgnoreReason.Undetermined, DistanceMetres: > 40 and < 150 }
        );
        Assert.Equal(20, OptionOfSession("rayReachMetres"));
        Assert.Contains("Warning: the visibility of ", CliRun.Of("validate", Session).Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--rays", "-1")]
    [InlineData("--rays", "many")]
    [InlineData("--ray-reach", "0")]
    public void Harvest_refuses_an_impossible_limit_of_rays(string option, string value)
    {
        CliRun run = Harvest(Session, "--masks", option, value);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(option, run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Session));
    }

    private double OptionOfSession(string name)
    {
        using JsonDocument info = JsonDocument.Parse(File.ReadAllText(Path.Combine(Session, "session.json")));
        return info.RootElement.GetProperty("options").GetProperty(name).GetDouble();
    }

    private static CliRun Harvest(string session, params string[] arguments) =>
        CliRun.Of(["harvest", "--out", session, "--size", "160x120", .. arguments]);
}
