using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Tests.Scenarios;

/// <summary>Plays a scenario without pictures, and records the poses that the simulated game truly has.</summary>
internal sealed record StagedRecording(IReadOnlyList<SeenMoment> Moments, ScenarioRecord Record, SimulatedGame Game)
{
    private const double TickSeconds = 1.0 / 30;

    /// <summary>Traffic farther away stands still, metres: it takes most of the time, and 150 m around the ego are cleared.</summary>
    private const double TrafficRadius = 250;

    public static StagedRecording Of(ScenarioTemplate template, int seed, RoadNetwork? roads = null, bool isBlind = false)
    {
        StagedRun staged = StagedRun.Begin(
            new PlannedScenario(template, seed) { IsEgoBlind = isBlind },
            new SimulationOptions
            {
                Seed = seed,
                Roads = roads,
                IsWarm = true,
                TrafficDensity = 0.5,
                ParkedDensity = 0.5,
                PedestrianDensity = 0.5,
                HasCrashes = true,
                TrafficRadiusMetres = TrafficRadius,
            },
            near: null
        );
        SimulatedGame game = staged.Game;
        Dictionary<int, string> names = staged.Record!.Handles.ToDictionary(each => each.Value, each => each.Key);
        var moments = new List<SeenMoment>();
        double began = game.Shown.TimeSeconds;
        while (!staged.IsOver)
        {
            SceneSnapshot shown = game.Shown;
            moments.Add(
                new SeenMoment(
                    shown.TimeSeconds - began,
                    Body(shown.Ego.Pose, shown.Ego.Velocity, shown.Ego.ModelMin, shown.Ego.ModelMax),
                    shown
                        .Entities.Where(entity => names.ContainsKey(entity.Handle))
                        .ToDictionary(
                            entity => names[entity.Handle],
                            entity => Body(entity.Pose, entity.Velocity, entity.ModelMin, entity.ModelMax)
                        )
                )
            );
            staged.Tick();
            game.Tick(TickSeconds);
        }

        return new StagedRecording(moments, staged.Record, game);
    }

    private static SeenBody Body(Pose pose, Vector3D velocity, Vector3D min, Vector3D max)
    {
        Vector3D forward = new Vector3D(pose.Axes.Forward.X, pose.Axes.Forward.Y, 0).Normalized();
        return new SeenBody(
            pose.Position.X,
            pose.Position.Y,
            forward.X,
            forward.Y,
            velocity.X,
            velocity.Y,
            max.Y,
            -min.Y,
            (max.X - min.X) / 2
        );
    }
}
