using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Driving;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Tests.Driving;

public sealed class BridgedGameTests
{
    private const double TickSeconds = 0.05;
    private readonly SimulatedGame _game = new(
        new SimulationOptions
        {
            Seed = 1,
            TrafficDensity = 0,
            PedestrianDensity = 0,
        }
    );

    [Fact]
    [Trait("Category", "Heavy")]
    public void Dead_client_stops_the_car_even_in_a_junction()
    {
        bool isDead = false;
        using AnsweringBridge bridge = new(state =>
            isDead ? [] : [new IndicatorsMessage(IndicatorOrder.Values(state.TorcsEquivalent), state.Frame)]
        );
        using GameEndpoint bridged = Bridged(bridge);
        while (bridged.Status.AreLanesKnown || _game.Ports.World.ReadEgo().Velocity.Length < 3)
        {
            bridged.Tick(TickSeconds);
            Assert.True(_game.Ports.World.TimeSeconds < 120, "The car has come to no junction.");
        }

        Assert.False(bridged.IsByClient);
        isDead = true;

        // Half a second until it is noticed, and at 8 m/s² less than two until it stands.
        for (int tick = 0; tick < 2.5 / TickSeconds; tick++)
        {
            bridged.Tick(TickSeconds);
        }

        Assert.False(bridged.Status.IsClientAlive);
        Assert.Equal(0, _game.Ports.World.ReadEgo().Velocity.Length, 3);
    }

    [Fact]
    public void Teleported_car_gets_a_new_controller_and_no_distance()
    {
        int controllers = 0;
        using AnsweringBridge bridge = new(state => [new IndicatorsMessage(IndicatorOrder.Values(state.TorcsEquivalent), state.Frame)]);
        using GameEndpoint bridged = Bridged(
            bridge,
            () =>
            {
                controllers++;
                return new DeepDrivingController();
            }
        );
        for (int tick = 0; tick < 20; tick++)
        {
            bridged.Tick(TickSeconds);
        }

        int before = controllers;
        Pose there = _game.Ports.World.ReadEgo().Pose;
        _game.Ports.Car!.Reset(there.Position + new Vector3D(100, 0, 0), 0);
        bridged.Tick(TickSeconds);

        Assert.Equal(before + 1, controllers);
        Assert.False(bridged.Status.IsClientAlive);
        Assert.InRange(bridged.Metres, 0, 20);
    }

    [Fact]
    public void Client_can_reset_the_car_beside_its_lane_and_drive_on()
    {
        Pose at = _game.Ports.World.ReadEgo().Pose;
        Queue<ClientMessage> once = new([new ResetMessage(at.Position + (at.Axes.Right * 1.5), Angles.HeadingDegrees(at.Axes.Forward))]);
        using AnsweringBridge bridge = new(state =>
            [
                .. once.TryDequeue(out ClientMessage? reset) ? [reset] : Array.Empty<ClientMessage>(),
                new ControlsMessage(new DrivingControls(0, 0.3, 0), state.Frame),
            ]
        );
        using GameEndpoint bridged = Bridged(bridge);
        for (int tick = 0; tick < 20; tick++)
        {
            bridged.Tick(TickSeconds);
        }

        Assert.True(bridged.IsByClient);
    }

    private GameEndpoint Bridged(IDrivingBridge bridge, Func<IController>? newController = null) =>
        new(
            _game,
            new FixedRoads(_game.Roads, "simulation"),
            new DrivingOptions { Picture = new ImageSize(32, 24) },
            bridge,
            newController ?? (static () => new DeepDrivingController()),
            isAssisted: true
        );
}
