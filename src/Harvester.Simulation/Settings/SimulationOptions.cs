using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Settings;

/// <summary>The options of a simulated game.</summary>
public sealed record SimulationOptions
{
    /// <summary>Seed of everything random: town, traffic, routes.</summary>
    public int Seed { get; init; }

    /// <summary>Seed of traffic, people and routes alone, so that worlds of one seed differ in them; null for <see cref="Seed"/>.</summary>
    public int? TrafficSeed { get; init; }

    /// <summary>The roads of the world; null for a town made from the seed.</summary>
    public RoadNetwork? Roads { get; init; }

    /// <summary>
    /// Whether lane widths (3.0 to 6.5 m), edge lines and paint are drawn at random for each road, so that no constant describes them.
    /// </summary>
    public bool HasVariedRoads { get; init; }

    /// <summary>How worn the paint of roads is, from 0, new, to 1: half of it gone, and the rest faded.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not from 0 to 1.</exception>
    public double PaintWear
    {
        get;
        init =>
            field = value is >= 0 and <= 1
                ? value
                : throw new ArgumentOutOfRangeException(nameof(PaintWear), value, "Wear is from 0 to 1.");
    }

    /// <summary>Where the ego starts, metres, world x and y; null for the middle of the roads.</summary>
    public Vector2D? Near { get; init; }

    /// <summary>
    /// Seed of a random start of the ego on the built roads, from which it can drive on forever; null to start near <see cref="Near"/>.
    /// </summary>
    public int? StartSeed { get; init; }

    /// <summary>Where the ego begins a scenario, into which actors can be put; null for ordinary traffic alone.</summary>
    public StageSetting? Stage { get; init; }

    /// <summary>Roads farther than this from the start are not built, metres; the ego does not leave the others.</summary>
    public double RadiusMetres { get; init; } = 400;

    /// <summary>
    /// Vehicles and people farther than this from the ego stand still until it comes nearer, metres; null to move all. Much of the time
    /// goes into those that are far away.
    /// </summary>
    public double? TrafficRadiusMetres { get; init; }

    /// <summary>Positions of traffic lights and street lamps, in place of generated ones; null to generate them.</summary>
    public IReadOnlyList<PropPlacement>? Props { get; init; }

    /// <summary>The weather, one of <see cref="WeatherNames.All"/>.</summary>
    public string Weather { get; init; } = "clear";

    /// <summary>The time of day at the start.</summary>
    public TimeSpan TimeOfDay { get; init; } = TimeSpan.FromHours(12);

    /// <summary>The day of the year, 1 to 366: where the sun stands at a time of day. By default the first of May.</summary>
    public int DayOfYear { get; init; } = 121;

    /// <summary>Whether the time of day is fixed; otherwise a minute of the game's day passes every two seconds.</summary>
    public bool IsTimeOfDayFixed { get; init; }

    /// <summary>Vertical field of view, degrees.</summary>
    public double VerticalFovDegrees { get; init; } = 50;

    /// <summary>Width divided by height of the window.</summary>
    public double WindowAspect { get; init; } = 4.0 / 3;

    /// <summary>The unreported distortion of the game's camera.</summary>
    public RenderLens Lens { get; init; } = RenderLens.None;

    /// <summary>How much of the light the pictures show.</summary>
    public Detail Detail { get; init; }

    /// <summary>Distance of the near plane, metres.</summary>
    public double NearClip { get; init; } = 0.15;

    /// <summary>
    /// Factor on the number of moving vehicles, and of parked ones unless <see cref="ParkedDensity"/> is set; 0 for none.
    /// </summary>
    public double TrafficDensity { get; init; } = 1;

    /// <summary>Factor on the number of parked vehicles; null for that of the moving ones.</summary>
    public double? ParkedDensity { get; init; }

    /// <summary>Factor on the number of people on foot.</summary>
    public double PedestrianDensity { get; init; } = 1;

    /// <summary>
    /// How far and how often the ego's driver leaves the middle of its lane: 0 follows it exactly, 1 has a standard deviation of about
    /// 0.7 m.
    /// </summary>
    public double Wander { get; init; }

    /// <summary>Factor on the number of lane changes, drifts onto markings between lanes and overtakings; 0 for none.</summary>
    public double LaneChanges { get; init; }

    /// <summary>
    /// Whether vehicles brake only as hard as tyres allow and collide when that does not suffice; otherwise they stop at once before they
    /// touch anything.
    /// </summary>
    public bool HasCrashes { get; init; }

    /// <summary>
    /// Whether the ego starts beside the start position and the world has already moved for some seconds, which depend on the seed.
    /// </summary>
    public bool IsWarm { get; init; }

    /// <summary>
    /// Whether a harvest's pictures are rendered by another thread while the game goes on. The pictures are the same.
    /// </summary>
    public bool DefersPictures { get; init; }

    /// <summary>Whether the renderer reports how much of each object is hidden; each object is drawn once more for it.</summary>
    public bool ReportsTrueOcclusion { get; init; }

    /// <summary>Recorded traffic to replay; null for traffic that drives by itself. The densities should then be 0.</summary>
    public TrafficReplay? Replay { get; init; }

    /// <summary>Imitated faults of the real game; none by default.</summary>
    public GameQuirks Quirks { get; init; } = new();
}
