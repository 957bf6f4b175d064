using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>Builds the asphalt and medians of roads, and what is beside and below them.</summary>
internal sealed class RoadSurfaces(
    RoadPlan plan,
    StreetIndex index,
    Terrain terrain,
    RoadLevels levels,
    Asphalt asphalt,
    AsphaltHeights heights,
    GroundMesh mesh
)
{
    public void Build()
    {
        RoadSides sides = new(index, terrain, levels, asphalt, mesh);
        TunnelBuilder tunnels = new(index, asphalt, mesh);
        foreach (Road road in plan.Roads)
        {
            Pave(road);
            sides.Build(road);
            tunnels.Build(road);
        }

        foreach (Junction junction in plan.Junctions.Where(junction => junction.Arms.Count != 2 || junction.IsCorner))
        {
            FillNode(junction);
            if (junction.Arms.Count == 1)
            {
                sides.AddEnd(junction.Arms[0]);
            }
        }
    }

    private void Pave(Road road)
    {
        RoadRibbon ribbon = new(road, asphalt.Of(road).Stations, mesh);
        foreach ((RoadFacet facet, double from, double left, double right) in asphalt.Of(road).All())
        {
            if (road.IsUnpaved)
            {
                mesh.AddQuad(
                    facet.NearLeft,
                    facet.NearRight,
                    facet.FarRight,
                    facet.FarLeft,
                    Palette.Dirt,
                    Surface.Ground,
                    SurfaceKind.Road
                );
            }
            else
            {
                bool hasLanes = !road.IsInner && !road.IsInTrim(from);
                mesh.AddAsphalt(facet, hasLanes ? road.Layout.InLanes(left) : default, hasLanes ? road.Layout.InLanes(right) : default);
            }
        }

        double median = road.Layout.MedianWidth;
        const double narrowestIsland = 1.5;
        if (median >= narrowestIsland && !road.Layout.IsOneWay)
        {
            const double lineRoom = 0.4;
            double half = (median / 2) - lineRoom;
            Func<double, bool> isPresent = distance => !road.IsInTrim(distance);
            Rgb top = road.IsHighway ? Palette.DryGrass : Palette.Grass;
            ribbon.Lay(
                new Rail(-half, Walkway.KerbHeight),
                new Rail(half, Walkway.KerbHeight),
                top,
                Surface.Ground,
                SurfaceKind.Terrain,
                isPresent
            );
            ribbon.Lay(
                new Rail(-half, 0),
                new Rail(-half, Walkway.KerbHeight),
                Palette.Kerb,
                Surface.Matte,
                SurfaceKind.Pavement,
                isPresent
            );
            ribbon.Lay(new Rail(half, Walkway.KerbHeight), new Rail(half, 0), Palette.Kerb, Surface.Matte, SurfaceKind.Pavement, isPresent);
        }
    }

    /// <summary>Adds a round plate that closes the wedges between the ends of roads.</summary>
    private void FillNode(Junction junction)
    {
        const int sides = 16;
        double radius = junction.Arms.Min(arm => arm.Road.Layout.HalfWidth);
        (Rgb colour, Surface surface) = junction.Arms.All(arm => arm.Road.IsUnpaved)
            ? (Palette.Dirt, Surface.Ground)
            : (Palette.Asphalt, Surface.Asphalt);
        List<Vector3D> rim =
        [
            .. Enumerable
                .Range(0, sides)
                .Select(i =>
                {
                    (double sin, double cos) = Math.SinCos(2 * Math.PI * i / sides);
                    Vector3D place = junction.Position + new Vector3D(radius * cos, radius * sin, 0);
                    return place with { Z = heights.Driven(place) ?? place.Z };
                }),
        ];
        const double below = 0.05;
        Vector3D down = Horizontal.Up * -below;
        for (int i = 0; i < sides; i++)
        {
            mesh.AddTriangle(junction.Position + down, rim[i] + down, rim[(i + 1) % sides] + down, colour, surface, SurfaceKind.Road);
        }
    }
}
