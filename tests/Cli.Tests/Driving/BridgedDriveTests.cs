using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;
using Harvester.Capture.Driving.Controllers;
using Harvester.Capture.Ports;
using Harvester.Cli.Driving;
using Harvester.Driving.Evaluation;
using Harvester.Simulation;

namespace Harvester.Cli.Tests.Driving;

public sealed class BridgedDriveTests
{
    private static readonly TimeSpan Little = TimeSpan.FromSeconds(0.2);
    private static readonly DrivingControls Gentle = new(0, 0.2, 0);

    [Fact]
    public void Run_after_a_fault_of_the_game_fails_and_does_not_wait()
    {
        using AnsweringBridge bridge = new(_ => throw new InvalidOperationException("the screen is gone"), new RequestFrameMessage());

        GameFaultException fault = Assert.Throws<GameFaultException>(() => Drive(bridge, TimeSpan.FromHours(1)));
        Assert.Contains("the screen is gone", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_after_a_fault_in_the_middle_of_the_drive_fails_and_is_no_success()
    {
        using AnsweringBridge bridge = new(
            state => state.Frame < 5
                ? [new ControlsMessage(Gentle, state.Frame), new StepMessage(0.1)]
                : throw new InvalidOperationException("the screen is gone"),
            new RequestFrameMessage());

        Assert.Throws<GameFaultException>(() => Drive(bridge, TimeSpan.FromHours(1)));
    }

    [Fact]
    public void Run_without_a_peer_gives_up()
    {
        using AnsweringBridge bridge = new(_ => []);

        IOException fault = Assert.Throws<IOException>(() => Drive(bridge, Little));
        Assert.Equal("No peer has driven for 0.2 s.", fault.Message);
    }

    [Fact]
    public void Run_with_a_peer_that_stops_the_world_and_says_no_more_gives_up()
    {
        using AnsweringBridge bridge = new(
            state => state.Frame < 5 ? [new ControlsMessage(Gentle, state.Frame), new StepMessage(0.1)] : [], new RequestFrameMessage());

        Assert.Throws<IOException>(() => Drive(bridge, Little));
    }

    [Fact]
    public void Run_that_is_stopped_gives_what_it_has()
    {
        using CancellationTokenSource stopping = new();
        using AnsweringBridge bridge = new(
            state =>
            {
                if (state.Frame == 10)
                {
                    stopping.Cancel();
                }

                return [new ControlsMessage(Gentle, state.Frame), new StepMessage(0.1)];
            },
            new RequestFrameMessage());

        // The tenth frame after the first is at 1.0 s: ten samples, or one more with the rest of its tick.
        Assert.InRange(Drive(bridge, TimeSpan.FromHours(1), stopping.Token).Count, 9, 11);
    }

    private static IReadOnlyList<DriveSample> Drive(IDrivingBridge bridge, TimeSpan patience, CancellationToken stopping = default)
    {
        SimulatedGame game = new(new SimulationOptions { Seed = 1, TrafficDensity = 0, PedestrianDensity = 0, WindowAspect = 4.0 / 3 });
        BridgedDrive drive = new(
            game, new FixedRoads(game.Roads, "simulation"), bridge, static () => new StanleyController(new StanleyOptions()), patience);
        return drive.Run(100, 60, isRealTime: false, stopping);
    }
}
