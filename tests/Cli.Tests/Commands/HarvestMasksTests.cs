using System.Text.Json;
using Harvester.Capture.Labels;
using Harvester.Datasets.Sessions;
using Harvester.Geometry.Visibility;

namespace Harvester.Cli.Tests.Commands;

/// <summary>What harvests let their masks cost.</summary>
public sealed class HarvestMasksTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Harvest_masks_take_no_more_rays_than_is_asked()
    {
        Harvest(Session, "--frames", "2", "--masks", "--mask-rays", "40");

        Assert.All(new SessionReader(Session).ReadLabels(), label => Assert.Equal(40, label.PixelMap!.RaysCast));
        Assert.Equal(40, OptionOfSession("maskRayBudget"));
    }

    [Fact]
    public void Harvest_masks_show_what_is_beyond_the_reach_of_rays_by_its_box()
    {
        Harvest(Session, "--frames", "2", "--masks", "--ray-reach", "20");

        ObjectLabel[] far =
            [.. new SessionReader(Session).ReadLabels().SelectMany(label => label.Objects).Where(item => item.Parent is null && item.DistanceMetres > 40)];
        Assert.NotEmpty(far);
        Assert.All(far, item => Assert.Equal(OcclusionMethod.Silhouettes, item.OcclusionMethod));
        Assert.Equal(20, OptionOfSession("rayReachMetres"));
    }

    [Theory]
    [InlineData("--mask-rays", "-1")]
    [InlineData("--mask-rays", "many")]
    [InlineData("--ray-reach", "0")]
    public void Harvest_bad_limit_of_masks_is_refused(string option, string value)
    {
        CliRun run = Harvest(Session, "--masks", option, value);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(option, run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Session));
    }

    [Theory]
    [InlineData("--mask-rays", "100")]
    [InlineData("--ray-reach", "100")]
    public void Harvest_limit_of_masks_without_masks_is_refused(string option, string value)
    {
        Harvest(Session, option, value).AssertFailed(ExitCode.Usage, $"{option} does nothing without --masks.");

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
