using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Labelling;
using Harvester.Evaluation.Figures;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;

namespace Harvester.Cli.Driving;

/// <summary>Takes samples of the truth about the ego of a simulated game.</summary>
internal sealed class DriveSampler(SimulatedGame game)
{
    private const double MaxBody = 25;

    private readonly List<DriveSample> _samples = [];
    private double _metres;

    public IReadOnlyList<DriveSample> Samples => _samples;

    /// <summary>Way of the car so far, metres.</summary>
    public double Metres => _metres;

    /// <summary>Takes one.</summary>
    /// <param name="isByController">Whether the controller that is judged drives.</param>
    public void Take(bool isByController)
    {
        EgoState ego = game.Ports.World.ReadEgo();
        GroundBox body = GroundBox.Of(ego.Pose, ego.ModelMin, ego.ModelMax);
        double time = game.Ports.World.TimeSeconds;
        DriveSample? before = _samples.LastOrDefault();
        double way = before is null ? 0 : (body.Centre - before.Position).Length;
        bool isTeleported = before is null || Relocation.Is(way, before.Speed, ego.Velocity.Length, time - before.TimeSeconds);
        _metres += isTeleported ? 0 : way;
        _samples.Add(new DriveSample
        {
            TimeSeconds = time,
            Position = body.Centre,
            Speed = ego.Velocity.Length,
            IsByController = isByController,
            IsTeleported = isTeleported,
            Lane = LaneOf(ego, body),
            Touching = [.. game.Ports.World.ReadEntities(ego.Pose.Position, MaxBody)
                .Where(entity => LaneTracker.IsVehicle(entity)
                    && body.Overlaps(GroundBox.Of(entity.Pose, entity.ModelMin, entity.ModelMax)))
                .Select(entity => entity.Handle)],
        });
    }

    private LanePlacement? LaneOf(EgoState ego, GroundBox body)
    {
        Vector3D centre = ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);
        return game.Truth.Locate(centre, ego.Pose.Axes.Forward) switch
        {
            { IsInJunction: true } => null,
            { } at => new LanePlacement(
                at.Road,
                at.Lane,
                at.Lanes,
                at.LaneWidth,
                at.RightOfLaneCentre,
                (body.HalfWidth * Math.Cos(at.AngleToRoad)) + (body.HalfLength * Math.Abs(Math.Sin(at.AngleToRoad)))),
            null => new LanePlacement(-1, null, 0, 0, 0, body.HalfWidth),
        };
    }
}
