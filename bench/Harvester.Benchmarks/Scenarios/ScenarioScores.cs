using Harvester.Capture.Ports;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Runs.Driving;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Scenarios;
using Harvester.Simulation.Settings;

namespace Harvester.Benchmarks.Scenarios;

/// <summary>
/// Drives the ego of scenarios with each driver and prints for each kind in how many runs it touched an actor, and the mean part of its way
/// that it drove. The way is that of the scenario's end, or as far as the ego comes at its speed in the scenario's time.
/// </summary>
internal static class ScenarioScores
{
    private const double TickSeconds = 0.05;

    /// <summary>Traffic farther away stands still, metres: it takes most of the time.</summary>
    private const double TrafficRadius = 250;

    /// <summary>Runs all scenarios of a folder and prints a table.</summary>
    /// <param name="folder">Folder of scenario files; plans in it are left out.</param>
    /// <param name="first">The first seed.</param>
    /// <param name="last">The last seed.</param>
    /// <param name="roadFile">The roads; null for the town of each seed.</param>
    public static void Run(string folder, int first, int last, string? roadFile)
    {
        RoadNetwork? roads = roadFile is null ? null : RoadImporter.Import(roadFile).Network;
        ScenarioTemplate[] templates =
        [
            .. Directory
                .GetFiles(folder, "*.json")
                .Order(StringComparer.Ordinal)
                .Select(file => ScenarioParser.Read(File.ReadAllText(file)).Template)
                .OfType<ScenarioTemplate>(),
        ];
        var scores = templates.ToDictionary(
            template => template,
            _ => (ScenarioScore[])[.. ScenarioDriver.All.Select(_ => new ScenarioScore())]
        );
        ScenarioScore[] all = [.. ScenarioDriver.All.Select(_ => new ScenarioScore())];

        // Runs of a seed follow each other, because they share its town.
        for (int seed = first; seed <= last; seed++)
        {
            foreach (ScenarioTemplate template in templates)
            {
                foreach ((int index, ScenarioDriver driver) in ScenarioDriver.All.Index())
                {
                    Add(scores[template][index], template, seed, driver, roads);
                }
            }
        }

        Console.WriteLine($"| scenario | {string.Join(" | ", ScenarioDriver.All.Select(driver => driver.Name))} |");
        Console.WriteLine($"|---|{string.Concat(ScenarioDriver.All.Select(_ => "---|"))}");
        foreach (ScenarioTemplate template in templates)
        {
            Console.WriteLine($"| `{template.Middle.Name}` | {string.Join(" | ", scores[template].Select(score => score.ToString()))} |");
            foreach ((int index, ScenarioScore score) in scores[template].Index())
            {
                all[index].Add(score);
            }
        }

        Console.WriteLine($"| all | {string.Join(" | ", all.Select(score => score.ToString()))} |");
    }

    private static void Add(ScenarioScore score, ScenarioTemplate template, int seed, ScenarioDriver driver, RoadNetwork? roads)
    {
        StagedRun staged;
        try
        {
            staged = StagedRun.Begin(
                new PlannedScenario(template, seed) { IsEgoBlind = driver.IsBlind },
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
        }
        catch (ScenarioUnfitException)
        {
            return;
        }

        Scenario scenario = staged.Bound.Scenario;
        double way = Math.Min(scenario.End.Metres ?? double.PositiveInfinity, scenario.Ego.Speed * scenario.End.Seconds);
        Drive(staged, driver);
        score.Add(staged.Record!.Touched.Count > 0, Math.Clamp(staged.EgoAt / way, 0, 1));
    }

    private static void Drive(StagedRun staged, ScenarioDriver driver)
    {
        if (driver.Plan is not { } plan)
        {
            while (!staged.IsOver)
            {
                staged.Tick();
                staged.Game.Tick(TickSeconds);
            }

            return;
        }

        using var over = new CancellationTokenSource();
        var drive = new DirectDrive(
            staged.Game,
            new FixedRoads(staged.Game.Roads, "simulation", LookAhead.OfMetres(plan.LookAheadMetres)),
            plan.New
        )
        {
            BeforeTick = () =>
            {
                staged.Tick();
                if (staged.IsOver)
                {
                    over.Cancel();
                }
            },
        };
        drive.Run(double.PositiveInfinity, double.PositiveInfinity, static _ => { }, over.Token);
    }
}
