using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Harvesting;

public sealed class PhaseCallsTests
{
    /// <summary>Calls of the fake game that one reading of the scene makes: camera, ego, entities, environment.</summary>
    private const int CallsOfAReading = 4;

    [Fact]
    public void Calls_are_charged_to_the_phase_that_made_them()
    {
        const int frames = 3;
        var calls = new TestCalls();
        var game = new FakeGame();
        game.OnCall = call =>
        {
            calls.Natives++;
            calls.Rays += call == "Cast" ? 1 : 0;
        };
        using var session = new HarvestSession(
            new HarvestOptions
            {
                Image = new ImageSize(64, 48),
                MaxFrames = frames,
                ProbeLag = false,
                OcclusionSamples = 9,
            },
            game.Ports with
            {
                Calls = calls,
            },
            new MemorySink()
        );
        game.Run(session);

        (long labelling, long rays) = session.Calls.Phases[HarvestPhase.Labelling];
        const int freeze = 1,
            grab = 1,
            unfreeze = 1,
            readingsAfterTheGrab = 1;
        Assert.Equal(calls.Rays, rays);

        // An object that nothing hides takes 4 rays.
        Assert.InRange(rays, 4 * frames, 4 * frames * 2);
        Assert.Equal(rays + (frames * (grab + (readingsAfterTheGrab * CallsOfAReading) + unfreeze)), labelling);

        // The first reading and one in each of the ticks that the picture may be late.
        int readings = 1 + new HarvestOptions().MaxPictureLagTicks;
        Assert.Equal((frames * (freeze + (readings * CallsOfAReading)), 0), session.Calls.Phases[HarvestPhase.Settling]);
    }

    [Fact]
    public void Calls_of_others_between_two_steps_are_not_counted()
    {
        var calls = new TestCalls();
        var game = new FakeGame();
        using var session = new HarvestSession(
            new HarvestOptions
            {
                Image = new ImageSize(64, 48),
                MaxFrames = 2,
                ProbeLag = false,
            },
            game.Ports with
            {
                Calls = calls,
            },
            new MemorySink()
        );
        while (!session.Step().IsOver)
        {
            calls.Natives += 50;
            game.Tick();
        }

        Assert.Empty(session.Calls.Phases);
    }
}
