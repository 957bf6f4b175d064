using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>Pictures rendered by another thread while the world moves on are those of the moment at which they were grabbed.</summary>
public sealed class DeferredPictureTests
{
    private const int Frames = 5;

    public static TheoryData<string> Games => [.. Quirks.Keys];

    private static IReadOnlyDictionary<string, GameQuirks> Quirks { get; } =
        new Dictionary<string, GameQuirks>
        {
            ["none"] = new(),
            ["late pictures"] = new() { PictureLagTicks = 3, IsCameraReportedLate = true },
            ["weather that goes on"] = new()
            {
                Paused = new FreezeQuirks
                {
                    LetsWeatherGoOn = true,
                    HoldsCamera = true,
                    CreepTicks = 3,
                },
            },
            ["vanishing vehicles"] = new()
            {
                VanishingFraction = 0.1,
                RaysMeetBoxes = true,
                RayMissFraction = 0.3,
            },
        };

    [Theory]
    [MemberData(nameof(Games))]
    [Trait("Category", "Heavy")]
    public void Deferred_frames_equal_those_rendered_at_once(string quirks)
    {
        List<CapturedFrame> prompt = Harvest(Quirks[quirks], defers: false);
        List<CapturedFrame> deferred = Harvest(Quirks[quirks], defers: true);

        Assert.Equal(Frames, prompt.Count);
        Assert.Equal(Lines(prompt), Lines(deferred));
        Assert.All(prompt.Zip(deferred), pair => Assert.Equal(pair.First.Picture.Bytes, pair.Second.Picture.Bytes));
    }

    private static IEnumerable<string> Lines(List<CapturedFrame> frames) => frames.Select(frame => JsonLabelWriter.Line(frame.Label));

    private static List<CapturedFrame> Harvest(GameQuirks quirks, bool defers)
    {
        var game = new SimulatedGame(
            new SimulationOptions
            {
                Seed = 5,
                Weather = "rain",
                TimeOfDay = TimeSpan.FromHours(21),
                Quirks = quirks,
                DefersPictures = defers,
            }
        );
        Assert.Equal(defers, game.Ports.Screen is IDeferringScreen);
        var options = new HarvestOptions
        {
            Image = new ImageSize(160, 120),
            MaxFrames = Frames,
            Faces = ModelFaces.Table,
        };
        var sink = new MemorySink();
        using var session = new HarvestSession(options, game.Ports, sink);
        while (!session.Status.IsOver)
        {
            game.Tick(1 / 60.0);
            session.Step();
        }

        Assert.Null(session.Fault);
        return sink.Frames;
    }
}
