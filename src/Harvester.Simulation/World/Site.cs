using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>Roads, the land around them, and the buildings for them. Immutable, so worlds on the same roads share it.</summary>
internal sealed class Site
{
    private Site(int seed, RoadNetwork network, RoadPlan plan, Settlement settlement, double wear)
    {
        Network = network;
        Plan = plan;
        Settlement = settlement;
        Index = new StreetIndex(plan.Roads);
        Walkways = Walkway.Find(plan, Index);
        RoadLevels levels = new(plan.Roads, Index);
        AsphaltHeights heights = new(Index, levels);
        Lanes = new LaneGraph(plan, heights);
        Signals = new Signals(plan, network);
        Terrain = new Terrain(plan, levels);
        Buildings = new BuildingStock(seed);

        GroundMesh ground = new();
        Terrain.Build(ground, settlement);
        Asphalt asphalt = new(Index, heights);
        new RoadSurfaces(plan, Index, Terrain, levels, asphalt, heights, ground).Build();
        List<PaintedRun> paint =
        [
            .. plan.Roads.Where(road => !road.IsInner && !road.IsUnpaved).SelectMany(road => PaintedRun.Of(road, asphalt)),
        ];
        Marks = new RoadPainter(plan, paint, Index, asphalt, ground, new PaintWear(seed, wear)).Paint();
        Paint = [.. paint.Select(run => run.Line())];
        Ground = [.. ground.Instances()];
        GroundPlan = new Lazy<GroundPlan>(() => new GroundPlan(plan.Roads, asphalt, Marks, Ground));
    }

    public RoadNetwork Network { get; }

    public RoadPlan Plan { get; }

    public StreetIndex Index { get; }

    public IReadOnlyList<Walkway> Walkways { get; }

    public LaneGraph Lanes { get; }

    public Signals Signals { get; }

    public Terrain Terrain { get; }

    /// <summary>Where town and country are.</summary>
    public Settlement Settlement { get; }

    public BuildingStock Buildings { get; }

    /// <summary>The lines painted along the roads.</summary>
    public IReadOnlyList<PaintedLine> Paint { get; }

    /// <summary>The stop lines and pedestrian crossings.</summary>
    public IReadOnlyList<PaintedMark> Marks { get; }

    /// <summary>The meshes of ground, roads and paint.</summary>
    public IReadOnlyList<MeshInstance> Ground { get; }

    /// <summary>The ground as faces; made when first asked for.</summary>
    public Lazy<GroundPlan> GroundPlan { get; }

    /// <summary>A town generated from a seed.</summary>
    /// <param name="seed">The seed.</param>
    /// <param name="style">How its roads are painted.</param>
    public static Site OfTown(int seed, RoadStyle style = default)
    {
        RoadNetwork network = TownBuilder.Build(seed);
        int? varySeed = style.IsVaried ? seed : null;
        RoadPlan plan = RoadPlan.Build(network, Vector3D.Zero, double.PositiveInfinity, varySeed: varySeed);
        return new Site(seed, network, plan, Settlement.Generated, style.Wear);
    }

    /// <summary>The part of given roads within a radius of a point.</summary>
    /// <exception cref="ArgumentException">No road lies there.</exception>
    public static Site OfRoads(int seed, RoadNetwork network, Vector3D centre, double radiusMetres, RoadStyle style = default)
    {
        Settlement settlement = Settlement.Of(network, centre);
        var plan = RoadPlan.Build(network, centre, radiusMetres, settlement, style.IsVaried ? seed : null);
        return new Site(seed, network, plan, settlement, style.Wear);
    }
}
