using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Traffic;

/// <summary>Recorded traffic, moved by its poses.</summary>
internal sealed class ReplayedTraffic
{
    private readonly TrafficReplay _replay;
    private readonly StagedGround _ground;
    private readonly List<ReplayedBody> _bodies = [];

    /// <summary>Chooses the models.</summary>
    /// <param name="replay">What was recorded.</param>
    /// <param name="catalogue">The models.</param>
    /// <param name="nextHandle">Gives handles.</param>
    /// <param name="ground">The ground.</param>
    public ReplayedTraffic(TrafficReplay replay, ModelCatalogue catalogue, Func<int> nextHandle, StagedGround ground)
    {
        (_replay, _ground) = (replay, ground);
        for (int i = 0; i < replay.Tracks.Count; i++)
        {
            if (i != replay.Ego)
            {
                Model model = ModelOf(replay.Tracks[i], catalogue);
                int handle = nextHandle();
                _bodies.Add(new ReplayedBody(handle, model.Riders.Count > 0 ? nextHandle() : 0, model, replay.Tracks[i]));
            }
        }
    }

    /// <summary>Those that are there.</summary>
    public IEnumerable<ReplayedBody> Present => _bodies.Where(body => body.IsThere);

    /// <summary>Moves everything to a time.</summary>
    /// <param name="timeSeconds">Time of the world.</param>
    /// <param name="seconds">Time since the last call.</param>
    /// <param name="ego">The car that carries the camera; it stays where it is while it is not known.</param>
    public void MoveTo(double timeSeconds, double seconds, Vehicle ego)
    {
        (int step, double part) = StepAt(timeSeconds);
        foreach (ReplayedBody body in _bodies)
        {
            body.MoveTo(step, part, seconds, _ground);
        }

        if (ReplayedPlace.Between(_replay.Tracks[_replay.Ego].States, step, part) is { } state)
        {
            ego.MoveStaged(
                ReplayedPlace.PoseOf(state, ego.Model, _ground),
                state.Velocity.Length,
                new Vector3D(state.Velocity.X, state.Velocity.Y, 0),
                []
            );
        }
    }

    private (int Step, double Part) StepAt(double timeSeconds)
    {
        IReadOnlyList<double> times = _replay.Times;
        int after = 0;
        while (after < times.Count && times[after] <= timeSeconds)
        {
            after++;
        }

        return after == 0 ? (0, 0)
            : after == times.Count ? (times.Count - 1, 0)
            : (after - 1, (timeSeconds - times[after - 1]) / (times[after] - times[after - 1]));
    }

    /// <summary>The model nearest in size among those of its kind; with its rider, if it has one.</summary>
    private static Model ModelOf(ReplayTrack track, ModelCatalogue catalogue)
    {
        IEnumerable<Model> models = track.Kind switch
        {
            ReplayKind.Pedestrian => catalogue.Pedestrians,
            ReplayKind.Cyclist => catalogue.Vehicles.Where(model => model.Class == ObjectClass.Bicycle),
            _ => catalogue.Vehicles.Where(model => model.Class != ObjectClass.Bicycle),
        };
        return models.MinBy(model => (SizeOf(model) - track.Size).LengthSquared)!;
    }

    private static Vector3D SizeOf(Model model)
    {
        (Vector3D min, Vector3D max) = ReplayedPlace.ExtentsOf(model);
        return max - min;
    }
}
