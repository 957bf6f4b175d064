using Harvester.Driving.Scenarios;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenarios;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;

namespace Harvester.Runs.Scenarios;

/// <summary>The roads of a simulated game on which scenarios are staged, and the places on them where they can happen.</summary>
public sealed class ScenarioTown
{
    /// <summary>How far around a place the lanes are known, metres.</summary>
    private const double Reach = 420;

    /// <summary>Places are tried along each lane at this distance, and no more than so many of them.</summary>
    private const double Spacing = 9;
    private const int MostPlaces = 3000;

    /// <summary>Around so many nodes of a large network places are looked for, one after another.</summary>
    private const int MostRegions = 60;

    /// <summary>A network of more nodes than a town is looked at in regions.</summary>
    private const int TownNodes = 2000;

    private readonly int _seed;
    private readonly LaneMaps _maps;

    /// <summary>Prepares the roads of a game.</summary>
    /// <param name="roads">The roads; null for the town of the seed.</param>
    /// <param name="seed">Seed of the world.</param>
    public ScenarioTown(RoadNetwork? roads, int seed)
    {
        _seed = seed;
        Network = roads ?? TownBuilder.Build(seed);
        IsTown = roads is null;
        var curves = new RoadCurves(Network);
        _maps = new LaneMaps(curves, new LaneModel(Network, RoadGeometry.LaneWidth, RoadGeometry.NarrowLaneWidth));
    }

    /// <summary>The roads.</summary>
    public RoadNetwork Network { get; }

    /// <summary>Whether they are those of a generated town.</summary>
    public bool IsTown { get; }

    /// <summary>Binds a scenario at a given place.</summary>
    /// <param name="scenario">The scenario, with its parameters drawn.</param>
    /// <param name="near">The place, metres, world.</param>
    /// <param name="headingDegrees">Direction of the ego there, degrees counter-clockwise from north; null for that of the nearest
    /// lane.</param>
    /// <param name="seed">Chooses models and colours.</param>
    /// <param name="reason">Why it cannot happen there; null if it can.</param>
    public BoundScenario? At(Scenario scenario, Vector2D near, double? headingDegrees, int seed, out string? reason)
    {
        LaneNetwork map = MapAround(near);
        MapLane[] lanes = [.. map.Index.Near(new Vector3D(near.X, near.Y, 0), 15).Where(lane => lane.Junction is null)];
        Vector2D? wanted = headingDegrees is { } heading ? Ground(Axes.FromHeading(heading).Forward) : null;
        MapLane? lane = lanes
            .Where(lane => wanted is not { } direction || lane.StartDirection.Dot(direction) > 0)
            .MinBy(lane => lane.Centre.Min(point => (Ground(point) - near).Length));
        if (lane is null)
        {
            reason = FormattableString.Invariant($"No lane is at {near.X}, {near.Y}.");
            return null;
        }

        var track = new LaneTrack(lane.Centre);
        double along = Math.Clamp(track.Locate(new Vector3D(near.X, near.Y, 0)).At, 1, Math.Max(1, track.To - 1));
        return ScenarioBinder.Bind(scenario, map, track.PositionAt(along), track.DirectionAt(along), seed, out reason);
    }

    /// <summary>Binds a scenario at the first of many places, in an order that the seed gives, where it can happen.</summary>
    /// <param name="scenario">The scenario, with its parameters drawn.</param>
    /// <param name="seed">Chooses the place, models and colours.</param>
    /// <param name="reason">Why it can happen nowhere: what most places lack; null if it can.</param>
    public BoundScenario? Anywhere(Scenario scenario, int seed, out string? reason)
    {
        var random = new Random(seed);
        var reasons = new Dictionary<string, int>(StringComparer.Ordinal);
        foreach (LaneNetwork map in Regions(random))
        {
            (Vector3D Position, Vector3D Direction)[] places = [.. PlacesOn(map)];
            random.Shuffle(places);
            foreach ((Vector3D position, Vector3D direction) in places.Take(MostPlaces))
            {
                if (ScenarioBinder.Bind(scenario, map, position, direction, seed, out string? why) is { } bound)
                {
                    reason = null;
                    return bound;
                }

                reasons[why!] = reasons.GetValueOrDefault(why!) + 1;
            }
        }

        reason = reasons.Count == 0 ? "The roads have no lanes." : $"No place fits; most often: {reasons.MaxBy(each => each.Value).Key}";
        return null;
    }

    private IEnumerable<LaneNetwork> Regions(Random random)
    {
        if (Network.Nodes.Count <= TownNodes)
        {
            yield return Whole.Value;
            yield break;
        }

        for (int i = 0; i < MostRegions; i++)
        {
            Vector3D node = Network.Nodes[random.Next(Network.Nodes.Count)].Position;
            yield return MapAround(Ground(node));
        }
    }

    private Lazy<LaneNetwork> Whole => field ??= new(() => _maps.Whole(new MapContent { KnownMarks = [.. Marks()] }));

    private LaneNetwork MapAround(Vector2D near) =>
        Network.Nodes.Count <= TownNodes
            ? Whole.Value
            : _maps.Whole(area: new Box2D(near.X - Reach, near.Y - Reach, near.X + Reach, near.Y + Reach));

    /// <summary>The painted crossings of a town, which its road data does not have.</summary>
    private IReadOnlyList<PaintedMark> Marks() =>
        IsTown
            ? new SimulatedGame(
                new SimulationOptions
                {
                    Seed = _seed,
                    TrafficDensity = 0,
                    PedestrianDensity = 0,
                }
            ).Marks
            : [];

    private static IEnumerable<(Vector3D Position, Vector3D Direction)> PlacesOn(LaneNetwork map)
    {
        foreach (MapLane lane in map.Lanes.Where(lane => lane.Junction is null))
        {
            var track = new LaneTrack(lane.Centre);
            for (double along = 6; along < track.To - 3; along += Spacing)
            {
                yield return (track.PositionAt(along), track.DirectionAt(along));
            }
        }
    }

    private static Vector2D Ground(Vector3D vector) => new(vector.X, vector.Y);
}
