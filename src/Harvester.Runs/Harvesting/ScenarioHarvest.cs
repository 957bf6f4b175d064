using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Runs.Scenarios;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Harvesting;

/// <summary>Makes the harvest of a scenario.</summary>
public static class ScenarioHarvest
{
    private const double RangeMetres = 80;

    /// <summary>Factors on the ordinary traffic, which is there beyond the cleared surroundings of the ego.</summary>
    private const double Traffic = 0.5;

    /// <summary>The harvest of a scenario with a seed.</summary>
    /// <param name="scenario">The scenario.</param>
    /// <param name="folder">Folder of its session.</param>
    /// <param name="options">Size, rate and what is labelled; the number of frames is set here.</param>
    /// <param name="roads">File of the road network; null for the town of the seed.</param>
    /// <param name="near">The place; null for any where it can happen.</param>
    public static HarvestPlan Of(PlannedScenario scenario, string folder, HarvestOptions options, string? roads, Vector2D? near)
    {
        ArgumentNullException.ThrowIfNull(scenario);
        ArgumentNullException.ThrowIfNull(options);
        int frames = Math.Max(1, (int)Math.Floor(scenario.Template.Drawn(scenario.Seed).End.Seconds * options.RateHz));
        return new HarvestPlan
        {
            Folder = folder,
            Overwrite = false,
            Resume = false,
            Options = options with { MaxFrames = frames, Places = new PlaceSequence(frames, 1), RangeMetres = RangeMetres },
            Frames = frames,
            Seed = scenario.Seed,
            Scenario = scenario,
            FovDegrees = 50,
            Roads = roads,
            Props = [],
            Faces = null,
            Near = near,
            Variety = new SimulationOptions
            {
                TrafficDensity = Traffic,
                PedestrianDensity = Traffic,
                ParkedDensity = Traffic,
                HasCrashes = true,
            },
            Weather = "clear",
            DayOfYear = new SimulationOptions().DayOfYear,
            TimeOfDay = TimeSpan.FromHours(12),
            Detail = Detail.Plain,
            LookAhead = LookAhead.Thesis,
            LaneWidth = RoadGeometry.LaneWidth,
            NarrowLaneWidth = RoadGeometry.NarrowLaneWidth,
            Quirks = new GameQuirks(),
            QuirksText = null,
        };
    }
}
