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
    private const int MaxPlaces = 3000;

    /// <summary>Distance of a place from one at which something stood in the way, metres.</summary>
    private const double Apart = 60;

    /// <summary>Around so many nodes of a large network places are looked for, one after another.</summary>
    private const int MaxRegions = 60;

    /// <summary>A network of more nodes than a town is looked at in regions.</summary>
    private const int TownNodes = 2000;

    /// <summary>Number of regions whose lanes are kept in memory.</summary>
    private const int MaxKept = 6;

    private readonly List<(Vector2D Near, LaneNetwork Map)> _regions = [];
    private readonly int _seed;
    private readonly Lazy<LaneNetwork> _whole;

    /// <summary>The last one: scenarios that follow each other are usually staged on the same roads.</summary>
    private static volatile ScenarioTown? _last;

    /// <summary>Prepares the roads of a game, unless they are those of the last one.</summary>
    /// <param name="roads">The roads; null for the town of the seed.</param>
    /// <param name="seed">Seed of the world.</param>
    public static ScenarioTown Of(RoadNetwork? roads, int seed) =>
        _last is { } last && (roads is null ? last.IsTown && last._seed == seed : last.Network == roads)
            ? last
            : _last = new ScenarioTown(roads, seed);

    private ScenarioTown(RoadNetwork? roads, int seed)
    {
        _seed = seed;
        Network = roads ?? TownBuilder.Build(seed);
        IsTown = roads is null;
        _whole = new(() => MapOf(Network, new MapContent { KnownMarks = [.. Marks()] }));
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
    public BoundScenario? At(Scenario scenario, Vector2D near, double? headingDegrees, int seed, out string? reason) =>
        ScenarioBinder.BindNear(scenario, MapAround(near), near, headingDegrees, seed, out reason);

    /// <summary>Binds a scenario at places where it can happen, in an order that the seed gives, each away from those before.</summary>
    /// <param name="scenario">The scenario, with its parameters drawn.</param>
    /// <param name="seed">Chooses the places, models and colours.</param>
    /// <param name="reasons">Receives why it cannot happen at other places, and at how many.</param>
    public IEnumerable<BoundScenario> Anywhere(Scenario scenario, int seed, Dictionary<string, int> reasons)
    {
        var random = new Random(seed);
        List<Vector3D> before = [];
        foreach (LaneNetwork map in Regions(scenario.Place, random))
        {
            (Vector3D Position, Vector3D Direction)[] places = [.. PlacesOn(map)];
            random.Shuffle(places);
            foreach ((Vector3D position, Vector3D direction) in places.Take(MaxPlaces))
            {
                if (before.Exists(other => (other - position).Length < Apart))
                {
                    continue;
                }

                if (ScenarioBinder.Bind(scenario, map, position, direction, seed, out string? why) is { } bound)
                {
                    before.Add(position);
                    yield return bound;
                }
                else
                {
                    reasons[why!] = reasons.GetValueOrDefault(why!) + 1;
                }
            }
        }
    }

    private IEnumerable<LaneNetwork> Regions(ScenarioNeeds needs, Random random)
    {
        if (Network.Nodes.Count <= TownNodes)
        {
            yield return _whole.Value;
            yield break;
        }

        RoadNode[] nodes = [.. Network.Nodes.Where(node => PlaceNeeds.MayBeNear(needs, node))];
        for (int i = 0; i < MaxRegions && nodes.Length > 0; i++)
        {
            yield return MapAround(Ground(nodes[random.Next(nodes.Length)].Position));
        }
    }

    private LaneNetwork MapAround(Vector2D near) => Network.Nodes.Count <= TownNodes ? _whole.Value : RegionAround(near);

    /// <summary>The lanes around a place of a large network, of which scenarios with the same seed ask for the same ones.</summary>
    private LaneNetwork RegionAround(Vector2D near)
    {
        lock (_regions)
        {
            int known = _regions.FindIndex(region => region.Near == near);
            if (known >= 0)
            {
                return _regions[known].Map;
            }
        }

        var area = new Box2D(near.X - Reach, near.Y - Reach, near.X + Reach, near.Y + Reach);
        LaneNetwork map = MapOf(RoadsAround.Of(Network, area), MapContent.None);
        lock (_regions)
        {
            _regions.RemoveRange(0, Math.Max(0, _regions.Count + 1 - MaxKept));
            _regions.Add((near, map));
        }

        return map;
    }

    private static LaneNetwork MapOf(RoadNetwork roads, MapContent content) =>
        LaneNetwork.Of(new RoadCurves(roads), new LaneModel(roads, RoadGeometry.LaneWidth, RoadGeometry.NarrowLaneWidth), content);

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
