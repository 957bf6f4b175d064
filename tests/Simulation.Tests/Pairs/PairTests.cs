using Harvester.Capture.Harvesting;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Pairs;

/// <summary>The further pictures of a moment: the same world in other weathers, at other hours and without objects.</summary>
public sealed class PairTests
{
    private static readonly SimulationOptions Town = new()
    {
        Seed = 4,
        IsWarm = true,
        IsTimeOfDayFixed = true,
    };

    [Fact]
    [Trait("Category", "Heavy")]
    public void Pictures_are_named_after_what_they_show()
    {
        PairHarvest harvest = PairHarvest.Of(Town, PairHarvest.Options("rain,snow", "6", "nearest-vehicle"));
        PairLabel[] pairs = [.. harvest.Labels[0].Pairs];
        int vehicle = Assert.Single(pairs[0].Without);

        Assert.Equal(
            ["base-without-nearest-vehicle", "rain-06", "rain-06-without-nearest-vehicle", "snow-06", "snow-06-without-nearest-vehicle"],
            pairs.Select(pair => Path.GetFileNameWithoutExtension(pair.File))
        );
        Assert.Equal(["clear", "rain", "rain", "snow", "snow"], pairs.Select(pair => pair.Weather));
        Assert.Equal([12, 6, 6, 6, 6], pairs.Select(pair => pair.TimeOfDay.Hours));
        Assert.All(pairs, pair => Assert.Equal(pair.File!.Contains("without", StringComparison.Ordinal) ? [vehicle] : [], pair.Without));
        Assert.Equal(5, harvest.Pictures[0].Values.Select(Convert.ToBase64String).Distinct().Count() - 1);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Labels_are_those_of_a_harvest_without_pairs()
    {
        PairHarvest plain = PairHarvest.Of(Town, new PairOptions(), frames: 2);
        PairHarvest harvest = PairHarvest.Of(Town, PairHarvest.Options("thunder", "0", "vehicles,people"), frames: 2);

        for (int frame = 0; frame < 2; frame++)
        {
            Assert.Equal(plain.Pictures[frame]["frame"], harvest.Pictures[frame]["frame"]);
            Assert.Equal(
                JsonLabelWriter.Line(plain.Labels[frame] with { GameFrame = 0 }),
                JsonLabelWriter.Line(harvest.Labels[frame] with { GameFrame = 0, Pairs = [] })
            );
        }
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void World_is_bitwise_the_same_in_all_pictures()
    {
        PairHarvest harvest = PairHarvest.Of(Town, PairHarvest.Options("clear,rain,xmas", "0,6,12", "vehicles,people,signs"));
        SceneSnapshot first = harvest.Scenes[0];

        Assert.True(harvest.Scenes.Select(scene => scene.Environment).Distinct().Count() >= 9);
        Assert.All(
            harvest.Scenes,
            scene =>
            {
                Assert.Equal((first.TimeSeconds, first.Camera, first.Ego), (scene.TimeSeconds, scene.Camera, scene.Ego));
                Assert.Equal(first.Entities.Select(Unlit), scene.Entities.Select(Unlit));
            }
        );
    }

    [Theory]
    [InlineData("rain", 18)]
    [InlineData("clear", 0)]
    [InlineData("blizzard", 6)]
    [Trait("Category", "Heavy")]
    public void Separate_harvest_has_the_same_labels_and_picture(string weather, int hour)
    {
        PairHarvest pairs = PairHarvest.Of(Town, PairHarvest.Options("rain,clear,blizzard", "0,6,18"));
        PairHarvest alone = PairHarvest.Of(Town with { Weather = weather, TimeOfDay = TimeSpan.FromHours(hour) }, new PairOptions());

        Assert.Equal(Geometry(alone.Labels[0]), Geometry(pairs.Labels[0]));
        Assert.Equal(alone.Pictures[0]["frame"], pairs.Pictures[0][$"{weather}-{hour:00}"]);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Moment_is_taken_under_144_skies()
    {
        PairHarvest harvest = PairHarvest.Of(
            Town,
            PairHarvest.Options(string.Join(',', WeatherNames.All.Take(12)), "0,2,4,6,8,10,12,14,16,18,20,22")
        );

        Assert.Empty(harvest.Warnings);
        Assert.Equal(144, harvest.Labels[0].Pairs.Count);
        Assert.Equal(144, harvest.Labels[0].Pairs.Select(pair => (pair.Weather, pair.TimeOfDay)).Distinct().Count());
        Assert.All(harvest.Labels[0].Pairs, pair => Assert.NotNull(pair.File));
        Assert.All(harvest.Scenes, scene => Assert.Equal(harvest.Scenes[0].Entities.Select(Unlit), scene.Entities.Select(Unlit)));
        Assert.Equal(
            JsonLabelWriter.Line(PairHarvest.Of(Town, new PairOptions()).Labels[0]),
            JsonLabelWriter.Line(harvest.Labels[0] with { Pairs = [] })
        );
    }

    [Theory]
    [InlineData(5)]
    [InlineData(20)]
    [Trait("Category", "Heavy")]
    public void Sky_that_fades_in_is_waited_for(int ticks)
    {
        PairOptions options = PairHarvest.Options("thunder", "0,12", "nearest-vehicle");
        SimulationOptions slow = Town with { Quirks = new GameQuirks { SlowSkyTicks = ticks } };

        PairHarvest settled = PairHarvest.Of(Town, options);
        PairHarvest waited = PairHarvest.Of(slow, options);
        Assert.Equal(settled.Pictures[0].Keys, waited.Pictures[0].Keys);
        Assert.All(settled.Pictures[0], picture => Assert.Equal(picture.Value, waited.Pictures[0][picture.Key]));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Sky_that_is_not_waited_for_is_wrong()
    {
        // The fixed wait of a frozen frame, four ticks, shows a sky on its way from noon to midnight.
        var options = new HarvestOptions();
        PairHarvest settled = PairHarvest.Of(Town, PairHarvest.Options("thunder", "0"));
        PairHarvest begun = PairHarvest.Of(Town with { Quirks = new GameQuirks { SlowSkyTicks = 60 } }, new PairOptions());
        begun.Game.Ports.Pause.Freeze();
        begun.Game.Ports.Sky!.Set("thunder", TimeSpan.Zero);
        for (int tick = 0; tick < options.MaxPictureLagTicks; tick++)
        {
            begun.Game.Tick(1 / 60.0);
        }

        byte[] shown = begun.Game.Render(PairHarvest.Size).Colour;
        double difference = shown.Zip(settled.Pictures[0]["thunder-00"], (a, b) => Math.Abs(a - b)).Average();
        Assert.InRange(difference, 20, 255);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Sky_that_does_not_settle_in_time_is_dropped()
    {
        SimulationOptions slow = Town with { Quirks = new GameQuirks { SlowSkyTicks = 60 } };
        PairHarvest harvest = PairHarvest.Of(slow, PairHarvest.Options("thunder", "0,12") with { MaxTicks = 30 });

        Assert.All(harvest.Labels[0].Pairs, pair => Assert.Equal((null, PairDrop.Unsettled), (pair.File, pair.Dropped!.Value)));
        Assert.Equal("2 of 2 further pictures of moments are missing: 2 unsettled.", Assert.Single(harvest.Warnings));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Objects_that_are_hidden_late_are_waited_for()
    {
        PairOptions options = PairHarvest.Options("clear,rain", "0,12", "nearest-vehicle,people");
        SimulationOptions late = Town with
        {
            Quirks = new GameQuirks { VisibilityDelayTicks = 15, PictureLagTicks = 3 },
        };

        PairHarvest settled = PairHarvest.Of(Town, options);
        PairHarvest waited = PairHarvest.Of(late, options);
        Assert.All(settled.Pictures[0], picture => Assert.Equal(picture.Value, waited.Pictures[0][picture.Key]));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Objects_that_cannot_be_hidden_are_dropped()
    {
        SimulationOptions fixedObjects = Town with { Quirks = new GameQuirks { UnhideableFraction = 1 } };
        PairHarvest harvest = PairHarvest.Of(fixedObjects, PairHarvest.Options("rain", "", "nearest-vehicle"));

        Assert.Equal([PairDrop.NotHidden, null, PairDrop.NotHidden], harvest.Labels[0].Pairs.Select(pair => pair.Dropped));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Sky_and_objects_are_as_before_afterwards()
    {
        PairHarvest harvest = PairHarvest.Of(Town, PairHarvest.Options("rain", "0", "vehicles"));
        harvest.Game.Tick(1 / 60.0);

        Assert.Equal(new EnvironmentState("clear", TimeSpan.FromHours(12)), harvest.Game.Shown.Environment);
        Assert.Empty(harvest.Game.Hidden.Current);
    }

    /// <summary>What a label line says of places and shapes: all but the sky and the lamps that follow it.</summary>
    private static string Geometry(FrameLabel label) =>
        JsonLabelWriter.Line(
            label with
            {
                Pairs = [],
                GameFrame = 0,
                Environment = new EnvironmentState("", TimeSpan.Zero),
                Objects =
                [
                    .. label.Objects.Select(item =>
                        item with
                        {
                            Lights = null,
                            Face = item.Face is { } face ? face with { Light = null } : null,
                        }
                    ),
                ],
            }
        );

    /// <summary>An entity without the lamps that a dark sky switches on.</summary>
    private static EntityState Unlit(EntityState entity) => entity with { Lights = null };
}
