using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>Builds the asphalt, medians, pavements and sides of roads and bridges.</summary>
internal sealed class RoadSurfaces(RoadPlan plan, RoadIndex index, Terrain terrain, Asphalt asphalt, GroundMesh mesh)
{
    private const double BridgeAbove = 3;
    private const double DeckThickness = 1.2;
    private const double ParapetHeight = 0.9;
    private const double ParapetThickness = 0.3;

    /// <summary>Width of another road's asphalt beyond its carriageway, metres.</summary>
    private const double OtherShoulder = 2.4;

    public void Build()
    {
        foreach (Road road in plan.Roads)
        {
            Pave(road);
            AddSide(road, onRight: true);
            AddSide(road, onRight: false);
        }

        foreach (Junction junction in plan.Junctions.Where(junction => junction.Arms.Count != 2 || junction.IsCorner))
        {
            FillNode(junction);
        }
    }

    /// <summary>Whether the ground lies far below a road.</summary>
    public bool IsBridge(Road road, double distance)
    {
        Vector3D place = road.Curve.PositionAt(distance);
        return place.Z - terrain.HeightAt(place) > BridgeAbove;
    }

    private void Pave(Road road)
    {
        RoadRibbon ribbon = new(road, asphalt.Of(road).Stations, mesh);
        Rgb colour = road.IsUnpaved ? Palette.Dirt : Palette.Asphalt;
        foreach (RoadFacet facet in asphalt.Of(road).All())
        {
            mesh.AddQuad(facet.NearLeft, facet.NearRight, facet.FarRight, facet.FarLeft, colour, Surface.Ground);
        }

        double median = road.Layout.MedianWidth;
        const double narrowestIsland = 1.5;
        if (median >= narrowestIsland && !road.Layout.IsOneWay)
        {
            const double lineRoom = 0.4;
            double half = (median / 2) - lineRoom;
            Func<double, bool> isPresent = distance => !road.IsInTrim(distance);
            Rgb top = road.IsHighway ? Palette.DryGrass : Palette.Grass;
            ribbon.Lay(new Rail(-half, Walkway.KerbHeight), new Rail(half, Walkway.KerbHeight), top, Surface.Ground, isPresent);
            ribbon.Lay(new Rail(-half, 0), new Rail(-half, Walkway.KerbHeight), Palette.Kerb, Surface.Matte, isPresent);
            ribbon.Lay(new Rail(half, Walkway.KerbHeight), new Rail(half, 0), Palette.Kerb, Surface.Matte, isPresent);
        }
    }

    private void AddSide(Road road, bool onRight)
    {
        RoadRibbon ribbon = new(road, asphalt.Of(road).Stations, mesh);
        double kerb = onRight ? road.RightKerb : road.LeftKerb;
        int side = onRight ? 1 : -1;
        double edge = kerb;
        double height = 0;
        bool isStreet = road.IsStreet;
        if (isStreet)
        {
            edge = kerb + (side * Walkway.Width);
            height = Walkway.KerbHeight;
            Func<double, bool> isPaved = distance => IsClear(road, distance, (kerb + edge) / 2);
            ribbon.Lay(new Rail(kerb, 0), new Rail(kerb, height), Palette.Kerb, Surface.Matte, isPaved);
            ribbon.Lay(new Rail(kerb, height), new Rail(edge, height), Palette.Pavement, Surface.Ground, isPaved);
        }

        const double bankWidth = 4;
        const double bankDepth = 3;
        ribbon.Lay(
            new Rail(edge, height),
            new Rail(edge + (side * bankWidth), height - bankDepth),
            Palette.Grass,
            Surface.Ground,
            distance => !IsBridge(road, distance) && IsClear(road, distance, edge)
                && IsClear(road, distance, edge + (side * bankWidth / 2)));
        AddParapet(ribbon, road, edge, side);
    }

    private void AddParapet(RoadRibbon ribbon, Road road, double edge, int side)
    {
        Func<double, bool> isPresent = distance => IsBridge(road, distance) && IsClear(road, distance, edge);
        double outer = edge + (side * ParapetThickness);
        Lay(edge, 0, edge, ParapetHeight);
        Lay(edge, ParapetHeight, outer, ParapetHeight);
        Lay(outer, ParapetHeight, outer, -DeckThickness);
        Lay(outer, -DeckThickness, 0, -DeckThickness);

        void Lay(double fromOffset, double fromHeight, double toOffset, double toHeight) =>
            ribbon.Lay(new Rail(fromOffset, fromHeight), new Rail(toOffset, toHeight), Palette.Concrete, Surface.Matte, isPresent);
    }

    private bool IsClear(Road road, double distance, double offset) =>
        !index.IsOnAnother(road, road.Curve.OffsetAt(distance, offset), OtherShoulder);

    /// <summary>Adds a round plate that closes the wedges between the ends of roads.</summary>
    private void FillNode(Junction junction)
    {
        const int sides = 16;
        double radius = junction.Arms.Min(arm => arm.Road.Layout.HalfWidth);
        Rgb colour = junction.Arms.All(arm => arm.Road.IsUnpaved) ? Palette.Dirt : Palette.Asphalt;
        List<Vector3D> rim = [.. Enumerable.Range(0, sides).Select(i =>
        {
            (double sin, double cos) = Math.SinCos(2 * Math.PI * i / sides);
            Vector3D place = junction.Position + new Vector3D(radius * cos, radius * sin, 0);
            RoadPlace? road = index.PlacesAt(place).Where(found => junction.Arms.Any(arm => arm.Road == found.Road)).Cast<RoadPlace?>()
                .FirstOrDefault();
            return road is { } on ? place with { Z = place.Z - on.Height } : place;
        })];
        const double below = 0.01;
        Vector3D down = Horizontal.Up * -below;
        for (int i = 0; i < sides; i++)
        {
            mesh.AddTriangle(junction.Position + down, rim[i] + down, rim[(i + 1) % sides] + down, colour, Surface.Ground);
        }
    }
}
