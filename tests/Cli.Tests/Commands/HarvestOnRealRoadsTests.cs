using Harvester.Cli.Terminals;
using Harvester.Datasets.Props;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
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
            "harvest",
            "--out",
            session,
            "--frames",
            "5",
            "--size",
            "320x240",
            "--roads",
            RealWorldFactAttribute.PathOf("nodes.zip")!,
            "--props",
            RealWorldFactAttribute.PathOf("worldTrafficLights.json")!,
            "--near",
            "0,-1000"
        );

        Assert.Equal("", run.Error);
        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.StartsWith($"{session}: 5 frames, ", CliRun.Of("validate", session).Out, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", session).ExitCode);
    }

    /// <summary>
    /// The first lights that can be seen from 0,-1000 come some ten seconds on; a frame a second for half a minute passes them.
    /// </summary>
    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Harvest_labels_real_traffic_lights_where_the_file_has_them()
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        string lights = RealWorldFactAttribute.PathOf("worldTrafficLights.json")!;

        CliRun.Of(
            "harvest",
            "--out",
            session,
            "--frames",
            "30",
            "--hz",
            "1",
            "--size",
            "400x300",
            "--classes",
            "trafficLight",
            "--no-report",
            "--roads",
            RealWorldFactAttribute.PathOf("nodes.zip")!,
            "--props",
            lights,
            "--near",
            "0,-1000",
            "--range",
            "200"
        );

        // The heads of a light are objects of their own, beside the light that carries them.
        ObjectLabel[] labels =
        [
            .. new SessionReader(session).ReadLabels().SelectMany(label => label.Objects).Where(label => label.Parent is null),
        ];
        IReadOnlyList<PropPlacement> given = PropPlacementImporter.Import(lights);
        Assert.NotEmpty(labels);
        Assert.All(
            labels,
            label =>
                Assert.Contains(given, light => label.Model == light.Name && label.Box3D.Contains(light.Position + new Vector3D(0, 0, 1)))
        );
    }

    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Harvest_far_from_any_road_is_a_usage_error()
    {
        using var folder = new TemporaryFolder();

        CliRun
            .Of(
                "harvest",
                "--out",
                folder.PathOf("session"),
                "--roads",
                RealWorldFactAttribute.PathOf("nodes.zip")!,
                "--near",
                "90000,90000"
            )
            .AssertFailed(ExitCode.Usage, "road");
    }
}
