using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.World;

/// <summary>What stands on the open land beside roads without houses: trees, bushes, rocks, and now and then a farm.</summary>
internal sealed class Countryside(int seed, Site site, Scenery scenery)
{
    private const double Spacing = 8;
    private const double Nearest = 9;
    private const double Depth = 45;
    private const double FarmSpacing = 140;
    private const double FarmNearest = 16;
    private const double FarmDepth = 40;

    private readonly Random _random = new(seed);

    /// <summary>Adds what stands beside motorways, tracks and country roads.</summary>
    public void AddAlong(RoadPlan plan)
    {
        foreach (
            Road road in plan.Roads.Where(road =>
                !road.IsInner && !road.IsInTunnel && (road.IsHighway || road.IsUnpaved || road.Zone == Zone.Country)
            )
        )
        {
            AddFarms(road);
            for (double distance = 0; distance < road.Length; distance += Spacing)
            {
                Vector3D place = BesideOf(road, distance, Nearest + (Depth * _random.NextDouble()));
                bool isOpen = site.Settlement.At(place) == Zone.Country;
                IReadOnlyList<Model> kinds = isOpen ? Kinds : scenery.Trees;
                scenery.AddPlant(kinds[_random.Next(kinds.Count)], place);
            }
        }
    }

    private IReadOnlyList<Model> Kinds => [.. scenery.Trees, RockModels.Bush, RockModels.Bush, RockModels.Rock];

    private void AddFarms(Road road)
    {
        for (double distance = FarmSpacing * _random.NextDouble(); distance < road.Length; distance += FarmSpacing)
        {
            Vector3D place = BesideOf(road, distance, FarmNearest + (FarmDepth * _random.NextDouble()));
            if (_random.Next(2) == 0 && !road.IsHighway && site.Settlement.At(place) == Zone.Country)
            {
                IReadOnlyList<Model> stock = site.Buildings.In(Zone.Country);
                Vector3D toRoad = (road.Curve.PositionAt(distance) - place) with { Z = 0 };
                scenery.TryAddBuilding(stock[_random.Next(stock.Count)], place, toRoad.Normalized(), place.Z);
            }
        }
    }

    private Vector3D BesideOf(Road road, double distance, double beyond) =>
        road.Curve.OffsetAt(distance, _random.Next(2) == 0 ? road.RightKerb + beyond : road.LeftKerb - beyond);
}
