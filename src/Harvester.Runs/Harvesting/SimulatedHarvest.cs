using System.Diagnostics;
using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Capture.Surveys;
using Harvester.Datasets.Faces;
using Harvester.Datasets.Props;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Runs.Faults;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Roads;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;

namespace Harvester.Runs.Harvesting;

/// <summary>Builds the simulated game of a plan and harvests it, tick by tick.</summary>
public sealed class SimulatedHarvest
{
    /// <summary>Frame rate of the simulated game, a usual one of the real game.</summary>
    public const double TicksPerSecond = 60;

    private readonly HarvestPlan _plan;
    private readonly SimulatedGame _game;
    private readonly FaceTable _faces;

    private readonly IReadOnlyList<Vector2D> _places;
    private readonly PaintTable? _paint;
    private readonly StagedRun? _staged;

    private SimulatedHarvest(
        HarvestPlan plan,
        SimulatedGame game,
        FaceTable faces,
        IReadOnlyList<Vector2D> places,
        PaintTable? paint,
        StagedRun? staged
    )
    {
        _staged = staged;
        _places = places;
        _paint = paint;
        _plan = plan;
        _game = game;
        _faces = faces;
    }

    /// <summary>Reads the files of the plan and builds the world.</summary>
    /// <exception cref="DatasetFormatException">A file of roads, paint, props or faces is invalid.</exception>
    /// <exception cref="UsageException">There is no road near the start position.</exception>
    public static SimulatedHarvest Build(HarvestPlan plan, Action<string> warn)
    {
        SimulatedGame.BeginModels();
        RoadNetwork? roads = plan.Roads is null ? null : RoadImporter.Import(plan.Roads).Network;
        TrafficReplay? replay = plan.Log is null ? null : LoggedTraffic.Read(plan.Log);
        PaintTable? paint = plan.Paint is { } table ? PaintFile.Read(table, roads ?? TownBuilder.Build(plan.Seed)) : null;
        FaceTable faces = FaceFile.AsWritten(
            plan.Faces is null ? ModelFaces.Table : ModelFaces.Table.OverriddenBy(FaceFile.ReadValid(plan.Faces, warn))
        );
        Lens lens = plan.Options.Lens;
        List<PropPlacement> props = [.. plan.Props.SelectMany(PropPlacementImporter.Import)];
        int count = plan.Options.Places?.Count ?? 1;
        List<Vector2D> places = count == 1 ? [] : SpreadPlaces.Of(roads ?? TownBuilder.Build(plan.Seed), count, plan.Seed, plan.Near);
        try
        {
            SimulationOptions options = plan.Variety with
            {
                Seed = plan.Seed,
                TrafficSeed = plan.Trial?.TrafficSeed,
                Roads = roads,
                Near =
                    replay is not null ? LoggedTraffic.StartOf(replay)
                    : count == 1 ? plan.Near
                    : places[0],
                Replay = replay,
                Props = plan.Props.Count > 0 ? props : null,
                Weather = plan.Weather,
                DayOfYear = plan.DayOfYear,
                TimeOfDay = plan.TimeOfDay,
                VerticalFovDegrees = plan.FovDegrees,
                WindowAspect = plan.Options.Image.Aspect,
                Lens = new RenderLens(lens.FocalScale, lens.CentreOffsetX, lens.CentreOffsetY, lens.K1, lens.K2),
                Detail = plan.Detail,
                DefersPictures = true,
                IsWarm = true,
                Quirks = plan.Quirks,
            };
            StagedRun? staged = plan.Scenario is { } scenario ? StagedRun.Begin(scenario, options, plan.Near) : null;
            SimulatedGame game = staged?.Game ?? new SimulatedGame(options);
            if (plan.Options.Rig is { } rig)
            {
                RigMounting.Mount(rig, game);
            }

            if (staged is null)
            {
                plan.Trial?.Drive.Begin(game);
            }

            return new SimulatedHarvest(plan, game, faces, places, paint, staged);
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message);
        }
    }

    /// <summary>Harvests until the end, a fault or cancellation. The session is opened and closed in every case.</summary>
    /// <param name="folder">Folder to write the session to; empty except for its mark and, where the plan resumes, its frames.</param>
    /// <param name="report">Receives the number of frames after each frame.</param>
    /// <param name="cancellation">Stops between two ticks.</param>
    /// <exception cref="IOException">The folder cannot be created.</exception>
    public HarvestOutcome Run(string folder, Action<int> report, CancellationToken cancellation)
    {
        var clock = Stopwatch.StartNew();
        using var writer = new SessionWriter(folder, OriginOf(_plan), _plan.Resume, _plan.Options.ViewsPerMoment)
        {
            Replays = _plan.Resume,
        };
        int resumed = writer.FramesWritten;
        if (_staged is not null)
        {
            writer.KeepAtEnd(ScenarioRecord.FileName, () => _staged.Record!.ToJson());
        }

        RoadNetwork roads = _plan.Roads is null ? KeepRoads(_game.Roads, writer) : _game.Roads;
        PaintTour? tour = _plan.Survey is { } survey
            ? new PaintTour(Ports(roads), _game.Ports.Car!, survey.Plan.Stations, survey.View, TourTimes.OfSimulation)
            : null;
        using var session = new HarvestSession(
            _plan.Options with
            {
                Faces = _faces,
                RecordedThrough = writer.RecordedThrough,
            },
            tour?.Ports ?? Ports(roads),
            writer
        )
        {
            Tour = tour,
        };
        var changes = new ChangeSchedule(_plan.Changes);
        do
        {
            // The game waits for the disk; otherwise the frames would depend on the disk's speed.
            writer.WaitForRoom();
            changes.Apply(_game, session.Counters.Taken);
            _plan.Trial?.Drive.Tick(_game);
            _staged?.Tick();
            _game.Tick(1 / TicksPerSecond);
            int before = session.Status.Captured;
            if (session.Step().Captured != before)
            {
                report(session.Status.Captured);
            }

            GoOn(session.Counters.Taken);
        } while (
            !session.Status.IsOver
            && !(_plan.Trial?.Drive.IsOver ?? false)
            && !(_staged?.IsOver ?? false)
            && !cancellation.IsCancellationRequested
        );

        session.Stop();
        writer.Dispose();
        return new HarvestOutcome(
            writer.FramesWritten,
            session.Status.Discarded,
            clock.Elapsed,
            writer.IsSpaceLow ? $"{writer.Fault} {OptionAdvice.OnLowSpace}"
                : session.Failure is { } failure ? OptionAdvice.TextOf(failure)
                : writer.Fault,
            writer.Fault is not null,
            cancellation.IsCancellationRequested && session.Status.Captured < _plan.Frames
        )
        {
            Resumed = resumed,
            Warnings = [.. session.Warnings.Select(OptionAdvice.TextOf)],
            Freezing = session.Freezing,
            Masks = session.MaskComparison,
        };
    }

    /// <summary>Goes to the next place once all frames of this one are taken.</summary>
    /// <exception cref="UsageException">No lane of the next place can be driven on.</exception>
    private void GoOn(int taken)
    {
        if (_game.Place + 1 < _places.Count && taken == _plan.Options.Places!.FirstFrameOf(_game.Place + 1))
        {
            Vector2D place = _places[_game.Place + 1];
            try
            {
                _game.GoTo(place);
            }
            catch (ArgumentException e)
            {
                throw new UsageException(FormattableString.Invariant($"Place {_game.Place + 1} at {place.X}, {place.Y}: {e.Message}"));
            }
        }
    }

    /// <summary>
    /// Writes the roads of a generated town beside the scenes, and returns them as read back: relabelling then finds the same numbers.
    /// </summary>
    private RoadNetwork KeepRoads(RoadNetwork town, SessionWriter writer)
    {
        if (!_plan.Options.Scenes)
        {
            return town;
        }

        using var text = new StringWriter(CultureInfo.InvariantCulture);
        RoadCsvWriter.Write(town, text);
        writer.Keep(FramePaths.Roads, text.ToString());
        return RoadCsvReader.Read(new StringReader(text.ToString()));
    }

    private GamePorts Ports(RoadNetwork roads) =>
        _game.Ports with
        {
            Roads = _plan.Survey is null
                ? new FixedRoads(
                    roads,
                    _plan.Roads is null ? "simulation" : "roadFile",
                    _plan.LookAhead,
                    _plan.LaneWidth,
                    _plan.NarrowLaneWidth,
                    _paint
                )
                : null,
            Paint = _paint is null ? _game.Ports.Paint : new MeasuredPaint(_paint),
        };

    /// <summary>The program and its version, as sessions name it.</summary>
    public static string ToolText { get; } = $"harvester {typeof(SimulatedHarvest).Assembly.GetName().Version!.ToString(3)}";

    /// <summary>Where the session of a plan comes from.</summary>
    public static SessionOrigin OriginOf(HarvestPlan plan) =>
        new()
        {
            Game = "simulation",
            Tool = ToolText,
            Seed = plan.Seed,
            Truth = LabelTruths.OfSimulation(plan.Variety.ReportsTrueOcclusion),
            Settings = [.. SettingsOf(plan)],
        };

    private static IEnumerable<KeyValuePair<string, string>> SettingsOf(HarvestPlan plan)
    {
        yield return new("weather", plan.Weather);
        yield return new("dayOfYear", plan.DayOfYear.ToString(CultureInfo.InvariantCulture));
        yield return new("timeOfDay", plan.TimeOfDay.ToString(@"hh\:mm", CultureInfo.InvariantCulture));
        yield return new("lookAhead", plan.LookAhead.ToString());
        yield return new("laneWidth", plan.LaneWidth.ToString(CultureInfo.InvariantCulture));
        yield return new("narrowLaneWidth", plan.NarrowLaneWidth.ToString(CultureInfo.InvariantCulture));
        if (plan.Roads is { } roads)
        {
            yield return new("roads", Path.GetFileName(roads));
        }

        if (plan.Log is { } log)
        {
            yield return new("log", Path.GetFileName(Path.TrimEndingDirectorySeparator(log)));
        }

        if (plan.Paint is { } paint)
        {
            yield return new("paint", Path.GetFileName(paint));
        }

        if (plan.Props.Count > 0)
        {
            yield return new("props", string.Join(", ", plan.Props.Select(Path.GetFileName)));
        }

        if (plan.Faces is { } faces)
        {
            yield return new("spaces", Path.GetFileName(faces));
        }

        if (plan.QuirksText is { } quirks)
        {
            yield return new("quirks", quirks);
        }

        if (plan.Variety.HasVariedRoads)
        {
            yield return new("variedRoads", "true");
        }

        if (plan.Variety.PaintWear > 0)
        {
            yield return new("paintWear", plan.Variety.PaintWear.ToString(CultureInfo.InvariantCulture));
        }

        if (plan.Variety.HasCrashes)
        {
            yield return new("crashes", "true");
        }

        if (plan.Changes.Count > 0)
        {
            yield return new("change", string.Join("; ", plan.Changes.Select(change => change.Text)));
        }

        if (plan.Near is { } near)
        {
            yield return new("near", string.Create(CultureInfo.InvariantCulture, $"{near.X},{near.Y}"));
        }

        if (plan.Options.Places is { } places)
        {
            yield return new("places", places.Count.ToString(CultureInfo.InvariantCulture));
        }

        foreach (
            (string name, double factor) in new[]
            {
                ("wander", plan.Variety.Wander),
                ("laneChanges", plan.Variety.LaneChanges),
                ("traffic", plan.Variety.TrafficDensity),
                ("pedestrians", plan.Variety.PedestrianDensity),
                ("parked", plan.Variety.ParkedDensity!.Value),
            }
        )
        {
            yield return new(name, factor.ToString(CultureInfo.InvariantCulture));
        }

        if (plan.Trial is { } trial)
        {
            yield return new("plan", trial.Plan);
            yield return new("trial", trial.Id);
            yield return new("trafficSeed", trial.TrafficSeed.ToString(CultureInfo.InvariantCulture));
        }

        if (plan.Scenario is { } scenario)
        {
            yield return new("scenario", scenario.Template.Middle.Name);
            yield return new("scenarioKind", scenario.Template.Middle.Kind);
            yield return new("scenarioSeed", scenario.Seed.ToString(CultureInfo.InvariantCulture));
            if (scenario.IsEgoBlind)
            {
                yield return new("egoBrakes", "false");
            }
        }

        if (plan.Survey is { } survey)
        {
            yield return new("survey", "paint");
            yield return new("surveyRange", survey.RangeMetres.ToString(CultureInfo.InvariantCulture));
            yield return new("surveyHeight", survey.View.HeightMetres.ToString(CultureInfo.InvariantCulture));
        }

        if (plan.Options.Shard.Count > 1)
        {
            yield return new("shard", plan.Options.Shard.ToString());
        }
    }
}
