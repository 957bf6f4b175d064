using System.Diagnostics.CodeAnalysis;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;
using Harvester.Capture.Driving.Controllers;
using Harvester.Capture.Imaging;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Cli.Serving;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Simulation;

namespace Harvester.Cli.Tests.Serving;

public sealed class ServedGameTests
{
    [Fact]
    public void Peer_in_lock_step_keeps_its_lane_by_the_indicators_that_it_was_told()
    {
        const int frames = 300;
        var game = new SimulatedGame(new SimulationOptions { Seed = 1, TrafficDensity = 0, PedestrianDensity = 0 });
        var options = new DrivingOptions { Picture = new ImageSize(32, 24) };
        using var cancellation = new CancellationTokenSource();
        using var peer = new StepwisePeer(game, frames, cancellation);
        using var served = new ServedGame(
            game, new FixedRoads(game.Roads, "simulation"), options, peer, static () => new DeepDrivingController(), isAssisted: true);
        served.Run(double.PositiveInfinity, cancellation.Token);

        Assert.Null(served.Status.Ending);

        // Each step is six ticks; the first picture is of the beginning.
        Assert.Equal(0.1 * (frames - 1), game.Ports.World.TimeSeconds, 6);
        Assert.True(served.Metres > 100, $"{served.Metres} m");
        Assert.True(peer.OffsetsInLane.Count > frames / 2, $"in a known lane in {peer.OffsetsInLane.Count} frames");

        // Lanes are 5.4 m wide and the car is 2 m wide at most: half of the room that is left on either side.
        Assert.All(peer.OffsetsInLane, offset => Assert.InRange(offset, -1.7, 1.7));
    }

    [Fact]
    public void Silent_peer_is_answered_with_the_brake_in_junctions_too()
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = 1, TrafficDensity = 0, PedestrianDensity = 0 });
        using var cancellation = new CancellationTokenSource();
        using var peer = new StepwisePeer(game, 30, cancellation) { IsSilent = true };
        using var served = new ServedGame(
            game, new FixedRoads(game.Roads, "simulation"), new DrivingOptions { Picture = new ImageSize(32, 24) }, peer, static () => new DeepDrivingController(), isAssisted: true);
        served.Run(double.PositiveInfinity, cancellation.Token);

        Assert.InRange(game.Ports.World.ReadEgo().Velocity.Length, 0, 0.01);
    }

    /// <summary>A bridge to a peer that takes what it is told for what it sees, says so, and asks for the next tenth of a second.</summary>
    private sealed class StepwisePeer(SimulatedGame game, int frames, CancellationTokenSource done) : IDrivingBridge
    {
        private readonly Queue<PeerMessage> _messages = new([new PauseMessage(true), new RequestFrameMessage()]);

        public bool IsSilent { get; init; }

        /// <summary>How far the car was from the middle of its lane, by the truth, metres; junctions left out.</summary>
        public List<double> OffsetsInLane { get; } = [];

        public string? Problem => null;

        public void Publish(BridgeState state, PixelBuffer picture)
        {
            EgoState ego = game.Ports.World.ReadEgo();
            Vector3D centre = ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);
            if (game.Truth.Locate(centre, ego.Pose.Axes.Forward) is { IsInJunction: false } place && state.AreLanesKnown)
            {
                OffsetsInLane.Add(place.RightOfLaneCentre);
            }

            if (state.Frame + 1 >= frames)
            {
                done.Cancel();
            }

            _messages.Enqueue(new StepMessage(0.1));
            if (!IsSilent)
            {
                _messages.Enqueue(new IndicatorsMessage(IndicatorOrder.Values(state.TorcsEquivalent), state.Frame));
            }
        }

        public bool TryReceive([NotNullWhen(true)] out PeerMessage? message) => _messages.TryDequeue(out message);

        public void Dispose()
        {
        }
    }
}
