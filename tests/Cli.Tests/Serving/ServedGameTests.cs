using Harvester.Capture.Ports;
using Harvester.Cli.Tests.Driving;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Driving;
using Harvester.Runs.Serving;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Tests.Serving;

public sealed class ServedGameTests
{
    private readonly SimulatedGame _game = new(
        new SimulationOptions
        {
            Seed = 1,
            TrafficDensity = 0,
            PedestrianDensity = 0,
        }
    );

    [Fact]
    public void Client_in_lock_step_keeps_its_lane_by_the_sent_indicators()
    {
        const int frames = 300;
        List<double> offsetsInLane = [];
        DrivingStatus status = Serve(
            frames,
            out double metres,
            state =>
            {
                EgoState ego = _game.Ports.World.ReadEgo();
                Vector3D centre = ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);
                if (_game.Truth.Locate(centre, ego.Pose.Axes.Forward) is { IsInJunction: false } place && state.AreLanesKnown)
                {
                    offsetsInLane.Add(place.RightOfLaneCentre);
                }

                return [new IndicatorsMessage(IndicatorOrder.Values(state.TorcsEquivalent), state.Frame)];
            }
        );

        Assert.Null(status.Ending);

        // Each step is six ticks; the first picture is of the beginning.
        Assert.Equal(0.1 * (frames - 1), _game.Ports.World.TimeSeconds, 6);
        Assert.True(metres > 100, $"{metres} m");
        Assert.True(offsetsInLane.Count > frames / 2, $"in a known lane in {offsetsInLane.Count} frames");

        // Lanes are 5.4 m wide and the car is 2 m wide at most: half of the room that is left on either side.
        Assert.All(offsetsInLane, offset => Assert.InRange(offset, -1.7, 1.7));
    }

    [Fact]
    public void Silent_client_is_answered_with_the_brake()
    {
        Serve(30, out _, _ => []);

        Assert.InRange(_game.Ports.World.ReadEgo().Velocity.Length, 0, 0.01);
    }

    /// <summary>
    /// Serves a client that uses the indicators it is sent as its estimate and requests a step of 0.1 s with each answer.
    /// </summary>
    private DrivingStatus Serve(int frames, out double metres, Func<BridgeState, IEnumerable<ClientMessage>> answer)
    {
        using CancellationTokenSource done = new();
        using AnsweringBridge bridge = new(
            state =>
            {
                if (state.Frame + 1 >= frames)
                {
                    done.Cancel();
                }

                return [new StepMessage(0.1), .. answer(state)];
            },
            new PauseMessage(true),
            new RequestFrameMessage()
        );
        using GameEndpoint bridged = new(
            _game,
            new FixedRoads(_game.Roads, "simulation"),
            new DrivingOptions { Picture = new ImageSize(32, 24) },
            bridge,
            static () => new DeepDrivingController(),
            isAssisted: true
        );
        DrivingStatus status = new ServedGame(_game, bridged).Run(double.PositiveInfinity, done.Token);
        metres = bridged.Metres;
        return status;
    }
}
