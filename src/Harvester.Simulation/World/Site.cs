using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>Roads, the land around them, and the buildings for them. Immutable, so worlds on the same roads share it.</summary>
internal sealed class Site
{
    private Site(int seed, RoadNetwork network, RoadPlan plan)
    {
        Network = network;
        Plan = plan;
        Index = new Streets.RoadIndex(plan.Roads);
        Walkways = Walkway.Find(plan, Index);
        Lanes = new LaneGraph(plan);
        Signals = new Signals(plan, network);
        Terrain = new Terrain(plan);
        Buildings = BuildingStock.Make(seed);

        GroundMesh ground = new();
        Terrain.Build(ground);
        Asphalt asphalt = new(Index);
        new RoadSurfaces(plan, Index, Terrain, asphalt, ground).Build();
        List<PaintRun> paint =
            [.. plan.Roads.Where(road => !road.IsInner && !road.IsUnpaved).SelectMany(road => PaintRun.Of(road, asphalt))];
        new RoadPainter(plan, paint, Index, asphalt, ground).Paint();
        Paint = [.. paint.Select(run => run.Line())];
        Ground = [.. ground.Instances()];
    }

    public RoadNetwork Network { get; }

    public RoadPlan Plan { get; }

    public Streets.RoadIndex Index { get; }

    public IReadOnlyList<Walkway> Walkways { get; }

    public LaneGraph Lanes { get; }

    public Signals Signals { get; }

    public Terrain Terrain { get; }

    public IReadOnlyList<Model> Buildings { get; }

    /// <summary>The lines painted along the roads.</summary>
    public IReadOnlyList<PaintedLine> Paint { get; }

    /// <summary>The meshes of ground, roads and paint.</summary>
    public IReadOnlyList<MeshInstance> Ground { get; }

    /// <summary>A town generated from a seed.</summary>
    public static Site OfTown(int seed)
    {
        RoadNetwork network = TownBuilder.Build(seed);
        return new Site(seed, network, RoadPlan.Build(network, Vector3D.Zero, double.PositiveInfinity));
    }

    /// <summary>The part of given roads within a radius of a point.</summary>
    /// <exception cref="ArgumentException">No road lies there.</exception>
    public static Site OfRoads(int seed, RoadNetwork network, Vector3D centre, double radiusMetres) =>
        new(seed, network, RoadPlan.Build(network, centre, radiusMetres));
}
