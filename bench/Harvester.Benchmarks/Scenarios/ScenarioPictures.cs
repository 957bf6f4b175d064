using Harvester.Geometry;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;

namespace Harvester.Benchmarks.Scenarios;

/// <summary>Stages all scenarios of a folder, and writes a picture of each from above.</summary>
internal static class ScenarioPictures
{
    private const double TickSeconds = 0.05;
    private const int MaxSeeds = 10;

    /// <summary>Writes NAME.svg for each scenario.</summary>
    /// <param name="folder">Folder of scenario files; plans in it are left out.</param>
    /// <param name="written">Folder to write to.</param>
    /// <param name="seed">The first seed to try.</param>
    public static void Run(string folder, string written, int seed)
    {
        Directory.CreateDirectory(written);
        foreach (string file in Directory.GetFiles(folder, "*.json").Order(StringComparer.Ordinal))
        {
            if (ScenarioParser.Read(File.ReadAllText(file)).Template is { } template)
            {
                using FileStream stream = File.Create(Path.Combine(written, $"{template.Middle.Name}.svg"));
                DrawingOf(template, seed).Write(stream);
            }
        }
    }

    /// <summary>The first of some seeds whose ego stays in the picture; the last of them if none does.</summary>
    private static ScenarioDrawing DrawingOf(ScenarioTemplate template, int seed)
    {
        for (int i = 0; ; i++)
        {
            var staged = StagedRun.Begin(
                new PlannedScenario(template, seed + i),
                new SimulationOptions
                {
                    Seed = seed + i,
                    IsWarm = true,
                    TrafficDensity = 0,
                    PedestrianDensity = 0,
                    HasCrashes = true,
                },
                near: null
            );
            var drawing = new ScenarioDrawing(staged.Bound, [.. Bodies(staged)]);
            if (drawing.ShowsEgo || i + 1 == MaxSeeds)
            {
                return drawing;
            }
        }
    }

    private static IEnumerable<DrawnBody> Bodies(StagedRun staged)
    {
        Dictionary<int, string> names = staged.Record!.Handles.ToDictionary(each => each.Value, each => each.Key);
        double began = staged.Game.Shown.TimeSeconds;
        while (!staged.IsOver)
        {
            SceneSnapshot shown = staged.Game.Shown;
            double seconds = shown.TimeSeconds - began;
            yield return Of(null, seconds, shown.Ego.Pose, shown.Ego.ModelMin, shown.Ego.ModelMax);
            foreach (EntityState entity in shown.Entities.Where(entity => names.ContainsKey(entity.Handle)))
            {
                yield return Of(names[entity.Handle], seconds, entity.Pose, entity.ModelMin, entity.ModelMax);
            }

            staged.Tick();
            staged.Game.Tick(TickSeconds);
        }
    }

    private static DrawnBody Of(string? id, double seconds, Pose pose, Vector3D min, Vector3D max)
    {
        Vector2D At(double right, double ahead)
        {
            Vector3D place = pose.Position + (pose.Axes.Right * right) + (pose.Axes.Forward * ahead);
            return new Vector2D(place.X, place.Y);
        }

        return new DrawnBody(id, seconds, At(0, 0), [At(min.X, max.Y), At(max.X, max.Y), At(max.X, min.Y), At(min.X, min.Y)]);
    }
}
