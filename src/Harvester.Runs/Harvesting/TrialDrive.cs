using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Harvesting;

/// <summary>The drive of a trial in the simulated game: where it begins, along which path it goes and when it is over.</summary>
public sealed class TrialDrive
{
    /// <summary>Objects within this distance are watched for while a path is driven, metres.</summary>
    private const double SightMetres = 60;

    private readonly PlanPlace _place;
    private readonly PathFollower? _follower;
    private Vector3D? _last;
    private double _metres;

    /// <summary>A drive that has not begun.</summary>
    /// <param name="place">The place, chosen.</param>
    /// <param name="speedMetresPerSecond">Speed along a path, m/s.</param>
    public TrialDrive(PlanPlace place, double speedMetresPerSecond)
    {
        _place = place;
        _follower = place.Path.Count > 0 ? new PathFollower(place.Path, speedMetresPerSecond) : null;
    }

    /// <summary>Whether the end of the path, or the distance to drive, is reached.</summary>
    public bool IsOver => (_follower?.IsAtEnd ?? false) || _metres >= _place.Metres;

    /// <summary>Places the car at the start, if the plan says in which direction it looks there.</summary>
    public void Begin(SimulatedGame game)
    {
        if ((_follower?.StartHeadingDegrees ?? _place.HeadingDegrees) is { } heading && _place.Start is { } start)
        {
            double height = game.Roads.Nodes.MinBy(node => (new Vector2D(node.Position.X, node.Position.Y) - start).Length)!.Position.Z;
            game.Ports.Car!.Reset(new Vector3D(start.X, start.Y, height), heading);
        }
    }

    /// <summary>Drives for the coming tick. Off a path, the game's own driver does.</summary>
    public void Tick(SimulatedGame game)
    {
        if (game.IsFrozen)
        {
            return;
        }

        EgoState ego = game.Ports.World.ReadEgo();
        _metres += _last is { } last ? (ego.Pose.Position - last).Length : 0;
        _last = ego.Pose.Position;
        if (_follower is { } follower)
        {
            game.Ports.Car!.Drive(follower.Drive(ego, game.Ports.World.ReadEntities(ego.Pose.Position, SightMetres)));
        }
    }
}
