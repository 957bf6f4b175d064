using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>The objects beside the roads: buildings, trees, lamps, signs.</summary>
internal sealed class Scenery
{
    private const double LampSpacing = 34;
    private const double MotorwayLampSpacing = 48;
    private const double SignSpacing = 90;
    private const double TreeSpacing = 16;
    private const double BuildingGap = 2.5;
    private const double PavementAndShoulder = 5.6;

    private const string StopSign = "prop_sign_road_01a";
    private const string YieldSign = "prop_sign_road_02a";

    private readonly Random _random;
    private readonly StreetIndex _index;
    private readonly Terrain _terrain;
    private readonly ModelCatalogue _catalogue;
    private readonly HandleCounter _handles;
    private readonly BuildingStock _stock;
    private readonly Settlement _settlement;
    private readonly List<Model> _roadside;
    private readonly BodyIndex<Footprint> _buildings = new();
    private readonly List<Prop> _props = [];
    private readonly List<Vector3D> _lamps = [];

    public Scenery(int seed, Site site, ModelCatalogue catalogue, HandleCounter handles)
    {
        _random = new Random(seed);
        _index = site.Index;
        _terrain = site.Terrain;
        _catalogue = catalogue;
        _handles = handles;
        _stock = site.Buildings;
        _settlement = site.Settlement;
        _roadside = [.. catalogue.Signs.Where(sign => sign.Name is not StopSign and not YieldSign)];
    }

    public IReadOnlyList<Prop> Props => _props;

    /// <summary>The positions of the lamps' lights.</summary>
    public IReadOnlyList<Vector3D> Lamps => _lamps;

    public void AddAlong(IReadOnlyList<Walkway> walkways)
    {
        foreach (Walkway walkway in walkways)
        {
            AddBuildings(walkway);
            AddSigns(walkway);
        }

        foreach (Walkway walkway in walkways)
        {
            AddTrees(walkway);
        }
    }

    /// <summary>Adds lamps along streets, alternating between the sides, and along motorways.</summary>
    public void AddLamps(RoadPlan plan, IReadOnlyList<Walkway> walkways)
    {
        foreach (Walkway walkway in walkways)
        {
            double first = walkway.From + (walkway.OnRight ? LampSpacing / 4 : LampSpacing * 3 / 4);
            for (double distance = first; distance < walkway.To; distance += LampSpacing)
            {
                AddLamp(walkway.PlaceBeyondKerb(distance, 0.5), walkway.Road.Curve.TangentAt(distance), walkway.Side);
            }
        }

        foreach (Road road in plan.Roads.Where(road => road.IsHighway && !road.IsInTunnel))
        {
            for (double distance = MotorwayLampSpacing / 2; distance < road.Length; distance += MotorwayLampSpacing)
            {
                Vector3D place = road.Curve.OffsetAt(distance, road.RightKerb + 0.6);
                if (!_index.IsOnAnother(road, place, 1))
                {
                    AddLamp(place, road.Curve.TangentAt(distance), 1);
                }
            }
        }
    }

    /// <summary>Adds lamps at given positions; other props of the list are ignored.</summary>
    public void AddLamps(IEnumerable<PropPlacement> placements)
    {
        foreach (PropPlacement placement in placements)
        {
            Stand(new Pose(placement.Position, Axes.FromEuler(placement.Rotation)));
        }
    }

    private void AddLamp(Vector3D foot, Vector3D along, int side)
    {
        // A lamp's arm extends to its left, over the road.
        Vector3D level = new Vector3D(along.X, along.Y, 0).Normalized();
        Stand(new Pose(foot, Horizontal.AxesAlong(level * side)));
    }

    private void Stand(Pose pose)
    {
        _props.Add(new Prop(0, _catalogue.StreetLamp, 0, pose));
        _lamps.Add(pose.ToWorld(ModelCatalogue.StreetLampHead));
    }

    /// <summary>The arms of junctions that have a stop sign.</summary>
    public HashSet<(Junction Junction, RoadArm Arm)> StopArms { get; } = [];

    /// <summary>The stop and yield signs, each with the arm whose traffic it holds back.</summary>
    public List<(Prop Prop, RoadArm Arm)> WaitSigns { get; } = [];

    /// <summary>
    /// Adds stop signs where streets meet without lights, and a yield sign where a street with one lane each way continues.
    /// </summary>
    public void AddStopSigns(RoadPlan plan, Func<Junction, bool> hasLights)
    {
        const double besideKerb = 0.7;
        foreach (Junction junction in plan.Junctions.Where(junction => junction.IsCrossing && !hasLights(junction)))
        {
            foreach (
                RoadArm arm in junction.Arms.Where(arm =>
                    arm.Road is { IsStreet: true, IsTooShortToWait: false } && arm.Road.Layout.Lanes(!arm.AtStart) > 0
                )
            )
            {
                double offset = arm.AtStart ? arm.Road.LeftKerb - besideKerb : arm.Road.RightKerb + besideKerb;
                double distance = arm.DistanceAt(arm.Trim);
                Vector3D foot = arm.Road.Curve.OffsetAt(distance, offset) + (Horizontal.Up * Walkway.KerbHeight);
                bool goesStraightOn = junction.Arms.Any(other => other != arm && other.Outward.Dot(arm.Outward) < -0.8);
                if (!_index.IsOnAnother(arm.Road, foot, besideKerb))
                {
                    AddSign(_catalogue[goesStraightOn ? YieldSign : StopSign], foot, -arm.Outward);
                    WaitSigns.Add((_props[^1], arm));
                    if (!goesStraightOn)
                    {
                        StopArms.Add((junction, arm));
                    }
                }
            }
        }
    }

    private void AddBuildings(Walkway walkway)
    {
        double distance = walkway.From + 1;
        while (distance < walkway.To)
        {
            Zone zone = _settlement.At(walkway.PlaceBeyondKerb(distance, Walkway.Width));
            IReadOnlyList<Model> stock = _stock.In(zone);
            Model model = stock[_random.Next(stock.Count)];
            double width = model.Max.X - model.Min.X;
            double depth = model.Max.Y - model.Min.Y;
            double setBack = Walkway.Width + 0.5 + (_random.Next(4) * 0.8);
            double middle = distance + (width / 2);
            if (middle > walkway.To)
            {
                return;
            }

            Vector3D toStreet = Horizontal.RightOf(walkway.Road.Curve.TangentAt(middle)) * -walkway.Side;
            Vector3D centre = walkway.PlaceBeyondKerb(middle, setBack + (depth / 2));
            bool leavesGap = _random.Next(6) < GapsIn(zone);
            if (!leavesGap && TryAddBuilding(model, centre, toStreet, centre.Z))
            {
                distance += width + BuildingGap;
            }
            else
            {
                distance += 8;
            }
        }
    }

    /// <summary>Adds a building if it overlaps neither another one nor a road.</summary>
    /// <param name="model">The building.</param>
    /// <param name="centre">The middle of its footprint.</param>
    /// <param name="front">Horizontal unit vector of the direction in which it faces.</param>
    /// <param name="street">Height above which its foot does not lie, metres.</param>
    public bool TryAddBuilding(Model model, Vector3D centre, Vector3D front, double street)
    {
        Footprint footprint = new(centre, front, (model.Max.Y - model.Min.Y) / 2, (model.Max.X - model.Min.X) / 2);
        if (!IsFree(footprint))
        {
            return false;
        }

        _buildings.Add(footprint, centre);
        _props.Add(new Prop(0, model, 0, new Pose(centre with { Z = LowestGround(footprint, street) }, Horizontal.AxesAlong(front))));
        return true;
    }

    /// <summary>Of six lots, those that stay empty.</summary>
    private static int GapsIn(Zone zone) =>
        zone switch
        {
            Zone.Country => 5,
            Zone.Suburb => 2,
            _ => 1,
        };

    private bool IsFree(Footprint footprint)
    {
        Footprint grown = footprint.Grown(BuildingGap / 2);
        return !_buildings
                .Near(footprint.Centre)
                .Any(other => grown.Overlaps(other with { Centre = other.Centre with { Z = grown.Centre.Z } }))
            && Border(footprint).All(place => !_index.IsAbreast(place, PavementAndShoulder));
    }

    private static IEnumerable<Vector3D> Border(Footprint footprint)
    {
        const int steps = 5;
        Vector3D right = Horizontal.RightOf(footprint.Forward);
        for (int i = 0; i <= steps; i++)
        {
            for (int j = 0; j <= steps; j++)
            {
                if (i is 0 or steps || j is 0 or steps)
                {
                    yield return footprint.Centre
                        + (footprint.Forward * footprint.HalfLength * ((2.0 * i / steps) - 1))
                        + (right * footprint.HalfWidth * ((2.0 * j / steps) - 1));
                }
            }
        }
    }

    private double LowestGround(Footprint footprint, double street) => Math.Min(street, Border(footprint).Min(_terrain.HeightAt)) - 0.1;

    private void AddTrees(Walkway walkway)
    {
        for (double distance = walkway.From + (TreeSpacing / 2); distance < walkway.To; distance += TreeSpacing)
        {
            bool isStreetTree = _random.Next(3) == 0;
            double beyond = isStreetTree ? 0.7 : Walkway.Width + 3 + (25 * _random.NextDouble());
            Vector3D place = walkway.PlaceBeyondKerb(distance + (4 * _random.NextDouble()), beyond);
            Model tree = _catalogue.Trees[_random.Next(_catalogue.Trees.Count)];
            AddTree(tree, place, isStreetTree ? place.Z : _terrain.HeightAt(place), isStreetTree ? 2 : PavementAndShoulder);
        }
    }

    /// <summary>The kinds of trees.</summary>
    public IReadOnlyList<Model> Trees => _catalogue.Trees;

    /// <summary>Adds a tree, bush or rock on the ground, unless a building or road is there.</summary>
    public void AddPlant(Model model, Vector3D place) => AddTree(model, place, _terrain.HeightAt(place), PavementAndShoulder);

    private void AddTree(Model model, Vector3D place, double height, double roadMargin)
    {
        const double crown = 2;
        Footprint footprint = new(place, new Vector3D(0, 1, 0), crown, crown);
        bool isBuiltOver = _buildings
            .Near(place)
            .Any(other => footprint.Overlaps(other with { Centre = other.Centre with { Z = place.Z } }));
        if (!isBuiltOver && !_index.IsAbreast(place, roadMargin))
        {
            _props.Add(
                new Prop(0, model, _random.Next(), new Pose(place with { Z = height }, Axes.FromHeading(_random.NextDouble() * 360)))
            );
        }
    }

    private void AddSigns(Walkway walkway)
    {
        Road road = walkway.Road;
        bool facesForward = road.Layout.IsOneWay ? road.Layout.Forward > 0 : walkway.OnRight;
        for (double distance = walkway.From + 5; distance < walkway.To; distance += SignSpacing * (0.6 + (0.8 * _random.NextDouble())))
        {
            Model model = _roadside[_random.Next(_roadside.Count)];
            AddSign(model, walkway.PlaceBeyondKerb(distance, 0.6), road.Curve.TangentAt(distance) * (facesForward ? 1 : -1));
        }
    }

    private void AddSign(Model model, Vector3D foot, Vector3D direction)
    {
        Vector3D level = new Vector3D(direction.X, direction.Y, 0).Normalized();
        _props.Add(new Prop(_handles.Next(), model, 0, new Pose(foot, Horizontal.AxesAlong(level))));
    }
}
