using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Runs.Harvesting;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Events;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Plans;

/// <summary>Makes the harvest of a trial.</summary>
public static class TrialPlan
{
    private const double RangeMetres = 80;

    /// <summary>The harvest of an attempt at a trial.</summary>
    /// <param name="file">The plan.</param>
    /// <param name="world">The simulated world.</param>
    /// <param name="trial">The trial.</param>
    /// <param name="attempt">Number of the attempt, from 1.</param>
    /// <param name="folder">Folder of its session.</param>
    /// <param name="disk">How it uses the disk.</param>
    public static HarvestPlan Of(PlanFile file, PlanWorld world, Trial trial, int attempt, string folder, PlanDisk disk)
    {
        Plan plan = file.Plan;
        int frames = plan.FramesAt(trial.Place);
        PlannedScenario? scenario = trial.Place.Scenario is { } name
            ? new PlannedScenario(file.Scenarios[name], trial.SeedOf(plan.Seed, attempt)) { HeadingDegrees = trial.Place.HeadingDegrees }
            : null;
        var harvest = new HarvestPlan
        {
            Folder = folder,
            Overwrite = false,
            Resume = true,
            Options = new HarvestOptions
            {
                Image = trial.Camera.Image,
                MaxFrames = frames,
                Places = new PlaceSequence(frames, 1),
                RateHz = plan.Hz,
                RangeMetres = RangeMetres,
                Masks = plan.Masks != PlanMasks.Off,
                MaskMethod = plan.Masks == PlanMasks.Coded ? MaskMethod.Coded : MaskMethod.Rays,
                Events = plan.Events ? new EventOptions() : null,
                MaxCalibrationErrorPixels = 1,
                Sync = disk.Sync,
                MinFreeBytes = disk.MinFreeBytes,
            },
            Frames = frames,
            Seed = plan.Seed,
            Trial = new TrialSetting(
                plan.Name,
                trial.Id,
                trial.SeedOf(plan.Seed, attempt),
                new TrialDrive(trial.Place, plan.SpeedMetresPerSecond)
            ),
            FovDegrees = trial.Camera.VerticalFovDegrees,
            Roads = world.Roads,
            Paint = world.Paint,
            Props = [],
            Faces = null,
            Scenario = scenario,
            Near =
                trial.Place.Start is null && scenario is not null
                    ? null
                    : trial.Place.Start ?? throw new InvalidOperationException("The place of a trial is chosen before it begins."),
            Variety = new SimulationOptions
            {
                Wander = 1,
                LaneChanges = 1,
                TrafficDensity = plan.Traffic,
                PedestrianDensity = plan.Pedestrians,
                ParkedDensity = plan.Parked,
                HasCrashes = scenario is not null,
            },
            Weather = trial.Weather,
            DayOfYear = new SimulationOptions().DayOfYear,
            TimeOfDay = trial.Hour,
            Detail = world.Detail,
            LookAhead = LookAhead.Thesis,
            LaneWidth = RoadGeometry.LaneWidth,
            NarrowLaneWidth = RoadGeometry.NarrowLaneWidth,
            Quirks = new GameQuirks(),
            QuirksText = null,
        };
        return file.Rigs.TryGetValue(trial.Camera.Name, out Rig? rig) ? RigMounting.Planned(harvest, rig) : harvest;
    }
}
